"""Invariants: contact of cracks. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import math

import numpy

from case import require, without_contact


# -------------------------------------------------------------------------- contact
def closures(case, result, index, inner=False):
    """By how many cells each particle just above a straight crack has come nearer to the one below it,
    by its id: away from tips inside the body, within the part of the crack that the body holds. With
    `inner` those alone that see whole cells: CRAMP's detection by areas over a cell takes nodes at an
    edge of the body, where half of the cell is empty, for nodes of surfaces that are apart. At r = 0
    the other half is there."""
    points = numpy.array(case.scene["cracks"][index]["points"], dtype=float)
    way = points[-1] - points[0]
    length, size = math.hypot(*way), min(case.cell)
    along, normal = way / length, numpy.array([-way[1], way[0]]) / length
    block = result.start.of_bodies([case.scene["bodies"][0]["name"]])
    place = result.start.position - points[0]
    part, height = place @ along, place @ normal / size
    left = result.start.position[block][:, 0].min()
    mouth = points[0][0] < left + 0.5 * size  # it begins at the face, else at a tip
    middle = block & (part > (0 if mouth else 0.25 * length)) & (part < 0.7 * length)
    if inner:
        edges = [result.start.position[block].min(axis=0), result.start.position[block].max(axis=0)]
        if case.axisymmetric and edges[0][0] < case.cell[0]:
            edges[0][0] = -math.inf
        reach = 1.75 * numpy.array(case.cell)
        middle &= ((result.start.position > edges[0] + reach) &
                   (result.start.position < edges[1] - reach)).all(axis=1)
    above = numpy.flatnonzero(middle & (height > 0) & (height < 0.55))
    below = numpy.flatnonzero(middle & (height < 0) & (height > -0.55))
    moved = (result.end.position - result.start.position) @ normal / size
    near = {}
    for particle in above:
        away = numpy.abs(part[below] - part[particle])
        if len(below) and away.min() < 0.3 * size:
            near[particle] = float(moved[below[away.argmin()]] - moved[particle])
    return near


def largest_change(one, other):
    """The largest difference of two results of `closures`."""
    return max((abs(one[particle] - other[particle]) for particle in one if particle in other),
               default=0.0)


APART = 0.1  # of a cell: closures of one crack that should be alike


def is_pressed(case):
    """A body between two rigid plates, over frictionless cracks."""
    return len(case.scene["bodies"]) == 3 and case.rigid and case.cracks and \
        all(crack.get("contact", "frictionless") == "frictionless" for crack in case.cracks)


def surfaces_do_not_pass_through(case):
    """Closed surfaces come nearer by a quarter of a cell at most: contact begins within a tenth, and the
    material between the centres of particles is compressed by as much again. Not where nodes between
    two cracks are without contact (docs/scenes.md)."""
    if not is_pressed(case) or case.base.status != 0 or without_contact(case.base):
        return False
    judged = False
    for index in range(len(case.cracks)):
        near = closures(case, case.base, index,
                        case.cracks[index].get("detection", "volume") == "cell")
        judged = judged or len(near) > 0
        require(max(near.values(), default=0) <= 0.25, f"particles beside crack {index} come nearer by "
                f"{max(near.values(), default=0):.3g} of a cell")
    return judged


def another_crack_beside_changes_nothing(case):
    """A crack closes alike with and without another one, also closed, more than a cell away. Nodes
    without contact, which are between the two, let surfaces come nearer (docs/scenes.md)."""
    if not is_pressed(case) or len(case.cracks) != 2 or case.base.status != 0 or \
            without_contact(case.base):
        return False
    scene = copy.deepcopy(case.scene)
    scene["cracks"].pop()
    alone = case.runner.run(scene)
    if alone.status != 0:
        return False
    both, one = closures(case, case.base, 0), closures(case, alone, 0)
    off = largest_change(both, one)
    require(off <= APART, f"particles beside crack 0 come nearer by up to {max(both.values(), default=0):.3g} "
            f"of a cell, by {max(one.values(), default=0):.3g} without crack 1; one by {off:.3g} more "
            f"or less; allowed: {APART}")
    return len(both) > 0


def detections_agree(case):
    """A crack closes alike however contact of its surfaces is detected."""
    if not is_pressed(case) or case.base.status != 0 or len(case.cracks) != 1:
        return False
    found = {}
    for detection in case.schema.child("cracks").child("detection").choices:
        scene = copy.deepcopy(case.scene)
        scene["cracks"][0]["detection"] = detection
        result = case.runner.run(scene)
        if result.status != 0:
            return False
        found[detection] = closures(case, result, 0, inner=True)
    first = next(iter(found))
    for detection, near in found.items():
        off = largest_change(found[first], near)
        require(off <= 1.5 * APART, f"particles beside the crack come nearer by up to "
                f"{max(near.values(), default=0):.3g} of a cell with detection {detection}, by "
                f"{max(found[first].values(), default=0):.3g} with {first}; one by {off:.3g} more or less; "
                f"allowed: {1.5 * APART}")
    return len(found[first]) > 0
