"""Changes of a scene that leave its answer as it is, and how the answer's numbers change with them.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import re

import numpy

from scales import SCALARS
from schema import unit_exponents, visit

SIZES = {"grid.cell", "grid.cells", "bodies[].particles_per_cell"}  # pairs without a place or a way
TABLES = {f"materials[].{name}": scalar for scalar in SCALARS.values()
          for name in (scalar.capacity_table, scalar.one_table)}  # points over a scalar
ALONG = {"materials[].principal_conductivities",
         "materials[].principal_diffusivities"}  # pairs along axes that an angle turns
CURVES = {"materials[].hardening_table"}  # points without a place: a number, and what has the unit
WAYS = {"contact.pairs[].direction"}  # pairs that are vectors
NORMALS = {"left": (-1, 0), "right": (1, 0), "bottom": (0, -1), "top": (0, 1)}


class Motion:
    """x' = Q x + s, with a Q that takes axes to axes; and a size of which units are measured."""

    def __init__(self, matrix=((1, 0), (0, 1)), shift=(0, 0)):
        self.matrix, self.shift = numpy.array(matrix), numpy.array(shift, dtype=float)

    def point(self, point):
        """Where a point goes."""
        return [float(value) for value in self.matrix @ numpy.array(point) + self.shift]

    def vector(self, vectors):
        """Vectors, one a row."""
        return vectors @ self.matrix.T

    def gradient(self, gradients):
        """Deformation gradients, one a row: xx xy yx yy zz."""
        plane = gradients[:, :4].reshape(-1, 2, 2)
        turned = numpy.einsum("ij,njk,lk->nil", self.matrix, plane, self.matrix)
        return numpy.column_stack([turned.reshape(-1, 4), gradients[:, 4]])

    @property
    def swaps(self):
        """Does one axis become the other?"""
        return self.matrix[0, 0] == 0

    def edge(self, edge):
        """The name of the edge that an edge becomes."""
        if edge not in NORMALS:
            return edge
        normal = tuple(int(value) for value in self.matrix @ numpy.array(NORMALS[edge]))
        return next(name for name, other in NORMALS.items() if other == normal)

    def angle(self, degrees):
        """Of a direction, in degrees from the first axis."""
        (c, s), (d, e) = self.matrix[0], self.matrix[1]
        if c * e - s * d > 0:
            return degrees + float(numpy.degrees(numpy.arctan2(d, c)))
        return -degrees if s == 0 and c > 0 else 180 - degrees

    def substitute(self, expression, names):
        """The expression in the new coordinates."""
        if not isinstance(expression, str) or expression == "free":
            return expression
        old = {}
        for k in range(2):
            j = int(numpy.nonzero(self.matrix[:, k])[0][0])
            sign = "" if self.matrix[j, k] > 0 else "-"
            old[names[k]] = f"({sign}({names[j]}-({self.shift[j]!r})))"
        return re.sub(r"\b(" + "|".join(names) + r")\b(?!\()",
                      lambda match: old[match.group(1)], expression)

    def components(self, pair, names):
        """A pair of expressions that are a vector's components."""
        new = [None, None]
        for j in range(2):
            k = int(numpy.nonzero(self.matrix[j])[0][0])
            new[j] = self.substitute(pair[k], names)
            if self.matrix[j, k] < 0:
                new[j] = negative(new[j])
        return new


def negative(expression):
    """The expression with the other sign; what is free stays free."""
    if expression == "free":
        return expression
    return -expression if not isinstance(expression, str) else f"-({expression})"


def names_of(scene):
    """Names of the coordinates."""
    return ["r", "z"] if scene["geometry"] == "axisymmetric" else ["x", "y"]


def moved(schema, scene, motion):
    """The scene as seen after the motion."""
    names = names_of(scene)

    def change(key, value):
        if key.path == "grid.origin":
            return value  # below, with the other corner
        if key.path in CURVES:
            return [list(point) for point in value]
        if key.path in TABLES:
            return copy.deepcopy(value)
        if key.shape == "points":
            return [motion.point(point) for point in value]
        if key.shape == "pair" and key.path in SIZES:
            return value[::-1] if motion.swaps else list(value)
        if key.path in ALONG:
            return list(value)
        if key.path in WAYS:
            return [float(part) for part in motion.matrix @ numpy.array(value)]
        if key.shape == "pair" and key.value == "number":
            return motion.point(value)
        if key.shape == "pair" and key.value == "name":
            return list(value)
        if key.shape == "pair":
            return motion.components(value, names)
        if key.value in ("expression", "drive"):
            return motion.substitute(value, names)
        if key.name == "edge":
            return motion.edge(value)
        return value

    def change_material(material):
        return material | {scalar.angle: within_a_turn(motion.angle(material.get(scalar.angle, 0)))
                           for scalar in SCALARS.values() if scalar.two in material}

    new = visit(schema, scene, change)
    new["materials"] = [change_material(material) for material in new["materials"]]
    for section in ("tractions", "particle_forces"):
        for load, old in zip(new.get("loads", {}).get(section, []),
                             scene.get("loads", {}).get(section, [])):
            if old.get("frame") == "edge":  # normal, and tangent counter clockwise
                value = [motion.substitute(part, names) for part in old["value"]]
                turned = numpy.linalg.det(motion.matrix) < 0
                load["value"] = [value[0], negative(value[1]) if turned else value[1]]
    grid = scene["grid"]
    first = numpy.array(grid.get("origin", [0, 0]), dtype=float)
    other = first + numpy.array(grid["cell"]) * numpy.array(grid["cells"])
    ends = numpy.array([motion.point(first), motion.point(other)])
    new["grid"]["origin"] = [float(value) for value in ends.min(axis=0)]
    sort_corners(new)
    return new


def within_a_turn(degrees):
    """The angle within the range that a scene may have."""
    return degrees - 360 if degrees > 360 else degrees


def sort_corners(value):
    """Makes `from` the lower corner and `to` the upper one, all through a scene."""
    if isinstance(value, list):
        for entry in value:
            sort_corners(entry)
    if isinstance(value, dict):
        if "from" in value and "to" in value:
            corners = numpy.array([value["from"], value["to"]], dtype=float)
            value["from"] = [float(part) for part in corners.min(axis=0)]
            value["to"] = [float(part) for part in corners.max(axis=0)]
        for entry in value.values():
            sort_corners(entry)


def in_units(schema, scene, length, mass, time, temperature):
    """The scene in units so many times smaller: powers of two change no digit of any number."""
    sizes = {"length": length, "mass": mass, "time": time, "temperature": temperature}
    names = names_of(scene)

    def scale(unit):
        factor = 1.0
        for name, power in unit_exponents(unit).items():
            factor *= sizes[name] ** power
        return factor

    def expression(text, unit):
        if text == "free" or not isinstance(text, str):
            return text if text == "free" else text * scale(unit)
        inverse = {name: 1 / length for name in names} | {"t": 1 / time}
        text = re.sub(r"\b(" + "|".join([*names, "t"]) + r")\b(?!\()",
                      lambda match: f"({match.group(1)}*{inverse[match.group(1)]!r})", text)
        return f"({text})*{scale(unit)!r}"

    def change(key, value):
        if key.value in ("expression", "drive"):
            if key.shape == "pair":
                return [expression(part, key.unit) for part in value]
            return expression(value, key.unit)
        if key.value != "number" or not key.unit:
            return value
        if key.path in CURVES:
            return [[first, second * scale(key.unit)] for first, second in value]
        if key.path in TABLES:
            over = temperature if TABLES[key.path].name == "temperature" else 1
            return [[point * over, part * scale(key.unit)] for point, part in value]
        if key.shape == "points":
            return [[part * scale(key.unit) for part in point] for point in value]
        if key.shape == "pair":
            return [part * scale(key.unit) for part in value]
        return value * scale(key.unit)

    new = visit(schema, scene, change)
    # Defaults that have a unit.
    if scene["geometry"] != "axisymmetric" and "thickness" not in scene:
        new["thickness"] = length
    return new


def with_bodies_reversed(_, scene):
    """The same with its bodies in the other order."""
    new = copy.deepcopy(scene)
    new["bodies"].reverse()
    return new


def with_fields_reversed(_, scene):
    """The same with velocity fields in the other order: bodies, materials, pairs and both of each."""
    new = with_bodies_reversed(_, scene)
    new["materials"].reverse()
    pairs = new["contact"].get("pairs", [])
    pairs.reverse()
    for pair in pairs:
        pair["of"].reverse()
        if "direction" in pair:
            pair["direction"] = [-part for part in pair["direction"]]
    return new


def with_cracks_reversed(_, scene):
    """The same with cracks in the other order, each from its end to its start."""
    new = copy.deepcopy(scene)
    new["cracks"].reverse()
    for crack in new["cracks"]:
        crack["points"].reverse()
        for integral in crack.get("j_integral", []):
            integral["tip"] = "start" if integral.get("tip", "end") == "end" else "end"
    return new


def matched(state, other, motion):
    """The order in which the other state's particles are this state's ones, moved; None where they
    are not the same ones. Both are states at t = 0."""
    if len(state.id) != len(other.id):
        return None
    here = state.position @ motion.matrix.T + motion.shift
    span = numpy.ptp(here, axis=0).max() or 1.0
    order = numpy.empty(len(here), dtype=int)
    for name in state.body_names:
        mine = numpy.flatnonzero(state.of_bodies([name]))
        others = numpy.flatnonzero(other.of_bodies([name]))
        if len(mine) != len(others):
            return None
        away = numpy.abs(here[mine][:, None, :] - other.position[others][None, :, :]).max(axis=2)
        nearest = away.argmin(axis=1)
        if away.min(axis=1).max(initial=0) > 1e-6 * span:
            return None
        order[mine] = others[nearest]
    return order
