"""Scales of a scene: its cell, its waves.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math


class Scalar:
    """A scalar that is conducted: its key in transport and what materials and results call it."""

    def __init__(self, name, words, of_material):
        self.name = name
        self.content, self.flow = words  # columns of the history
        self.capacity, self.one, self.two, self.angle, self.expansion, self.stress_free = of_material
        self.capacity_table, self.one_table = self.capacity + "_table", self.one + "_table"

    @property
    def flows(self):
        """Columns of the history: conditions', the source's, edges'."""
        return [f"{cause}_{self.flow}" for cause in ("boundary", "source", "edge")]

    @property
    def of_material(self):
        """Keys of materials."""
        return {self.capacity, self.one, self.two, self.angle, self.expansion, self.stress_free,
                self.capacity_table, self.one_table}

    def has_capacity(self, material):
        """Does the material conduct it?"""
        return self.capacity in material or self.capacity_table in material

    def capacity_per_volume(self, material, of=min):
        """Of the undeformed material; of a table the smallest, or the largest."""
        capacity = of(value for _, value in material[self.capacity_table]) \
            if self.capacity_table in material else material[self.capacity]
        return capacity * (material["density"] if self.name == "temperature" else 1)

    def diffusivity(self, material):
        """The largest of a material, along any direction and at any value of tables."""
        largest = max([material.get(self.one, 0), *material.get(self.two, []),
                       *(value for _, value in material.get(self.one_table, []))])
        return largest / self.capacity_per_volume(material) if self.name == "temperature" else largest


SCALARS = {scalar.name: scalar for scalar in (
    Scalar("temperature", ("thermal_energy", "heat"),
           ("heat_capacity", "conductivity", "principal_conductivities", "conductivity_angle",
            "thermal_expansion", "stress_free_temperature")),
    Scalar("concentration", ("solvent_mass", "solvent"),
           ("saturation", "diffusivity", "principal_diffusivities", "diffusivity_angle", "swelling",
            "stress_free_concentration")))}
HOTTEST = 13  # of absolute temperatures in scenes


def bulk_modulus(material):
    """Of a solid."""
    if "young" in material:
        return material["young"] / (3 * (1 - 2 * material["poisson"]))
    return material.get("bulk", 1)


def wave_speed(material):
    """Of longitudinal waves in the undeformed material, without flow of heat."""
    if "gas_constant" in material:
        constant = material["gas_constant"]
        capacity = SCALARS["temperature"].capacity_per_volume(material) / material["density"]
        return math.sqrt(constant * HOTTEST * (1 + constant / capacity))
    viscous = material.get("viscosity", {"linear": 0})["linear"]
    slower = viscous + math.sqrt(1 + viscous ** 2)
    if "sound_speed" in material:
        return slower * math.sqrt(material["sound_speed"] ** 2 +
                                  4 / 3 * material.get("shear", 0) / material["density"])
    if "adiabatic_index" in material:
        return slower * math.sqrt(material["adiabatic_index"] *
                                  (material["start_pressure"] + material["stiffening_pressure"]) /
                                  material["density"])
    shear = material.get("shear", 0)
    if "young" in material:
        shear = material["young"] / (2 * (1 + material["poisson"]))
    return slower * math.sqrt((bulk_modulus(material) + 4 / 3 * shear) / material["density"])


def film_of(flux):
    """Derivative of a flux by the scalar, at the highest temperature with radiation."""
    radiation = flux.get("radiation", {"emissivity": 0, "sigma": 0})
    return flux.get("convection", {}).get("coefficient", 0) + \
        4 * radiation["emissivity"] * radiation["sigma"] * HOTTEST ** 3


class Scales:
    """Of self.scene."""

    @property
    def axisymmetric(self):
        """Is the scene axisymmetric?"""
        return self.scene["geometry"] == "axisymmetric"

    @property
    def cell(self):
        """The size of a cell of the refined grid."""
        grid = self.scene["grid"]
        return [side / grid.get("refine", 1) for side in grid["cell"]]

    @property
    def wave(self):
        """Speed of waves in the stiffest material."""
        return max(map(wave_speed, self.scene["materials"]))

    @property
    def scalars(self):
        """What the scene conducts: its keys in transport, by scalar."""
        transport = self.scene.get("transport", {})
        return {SCALARS[name]: transport[name] for name in SCALARS if name in transport}

    @property
    def fluxes(self):
        """Of all scalars, through edges."""
        return [flux for given in self.scalars.values() for flux in given.get("fluxes", [])]

    @property
    def conduction_rate(self):
        """The inverse of the longest stable step of conduction in undeformed bodies; 0 without."""
        diffusivity = film = 0.0
        shorter = 1.0  # of FMPM, by its order
        for scalar in SCALARS.values():
            bodies = self.scene.get("bodies", [])
            used = [body.get("material") for body in bodies]
            materials = [material for material in self.scene["materials"]
                         if scalar.has_capacity(material) and (material["name"] in used or not bodies)]
            if not materials:
                continue
            diffusivity = max([diffusivity, *map(scalar.diffusivity, materials)])
            capacities = {material["name"]: scalar.capacity_per_volume(material)
                          for material in materials}
            of = {body["name"]: capacities[body["material"]] for body in bodies
                  if "material" in body}
            given = self.scene.get("transport", {}).get(scalar.name, {})
            if given.get("transfer") == "fmpm":
                shorter = max(shorter, (given.get("order", 2) + 2) / 4)
            fluxes = given.get("fluxes", [])
            film = max([film, *(film_of(flux) / of[flux["body"]] for flux in fluxes)])
        x, y = (1 / side for side in self.cell)
        return shorter * (2 * diffusivity * (x * x + y * y) + film * (x + y))
