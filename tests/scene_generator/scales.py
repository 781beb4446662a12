"""Scales of a scene: its cell, its waves.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math


def wave_speed(material):
    """Of longitudinal waves in the undeformed material."""
    if "young" in material:
        young, poisson = material["young"], material["poisson"]
        modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
    else:
        modulus = material.get("bulk", 1) + 4 / 3 * material.get("shear", 0)
    return math.sqrt(modulus / material["density"])


def largest_conductivity(material):
    """Along any direction; 0 without."""
    return max([material.get("conductivity", 0), *material.get("principal_conductivities", [])])


def film_of(flux):
    """Derivative of a flux by the temperature, at an absolute temperature of 13 with radiation."""
    radiation = flux.get("radiation", {"emissivity": 0, "sigma": 0})
    return flux.get("convection", {}).get("coefficient", 0) + \
        4 * radiation["emissivity"] * radiation["sigma"] * 13 ** 3


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
    def fluxes(self):
        """Of heat, through edges."""
        return self.scene.get("transport", {}).get("temperature", {}).get("fluxes", [])

    @property
    def conduction_rate(self):
        """The inverse of the longest stable step of conduction in undeformed bodies; 0 without heat."""
        capacities = [material["density"] * material["heat_capacity"]
                      for material in self.scene["materials"] if "heat_capacity" in material]
        if not capacities:
            return 0.0
        diffusivity = max(largest_conductivity(material) / (material["density"] * material["heat_capacity"])
                          for material in self.scene["materials"])
        film = max(map(film_of, self.fluxes), default=0.0) / min(capacities)
        x, y = (1 / side for side in self.cell)
        return 2 * diffusivity * (x * x + y * y) + film * (x + y)
