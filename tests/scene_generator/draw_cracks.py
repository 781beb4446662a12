"""Draws cracks: functions (canvas, key) of the tables in meaning.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math

from draw import ABSENT, short
from draw_bodies import PAST_ROOM, SIDES, place

# From where boxes are cut into parts: no end is then on a line from a particle to a node, where
# round-off would decide whether that passes the crack. Not equal: such lines are diagonals too.
OFF = (0.0837, 0.0491)


# ------------------------------------------------------------------------- cracks
def draw_crack_count(canvas):
    """None in half of the scenes, else one or two; one beside contact, in one of the bodies."""
    if not canvas.notes["cracked"]:
        return 0
    if canvas.notes["contact"]:
        return 1
    return canvas.pick([1, 2])


def draw_crack_points(canvas, _):
    """A chain across the first body, off the nodes and the particles: straight or with a kink, in any
    direction; in the largest of several bodies in contact, or from a face of it; the second one is beside the first, from either end. What is pressed is one and a
    half cells away or more: pairs of particles then have one crack between them."""
    low, high = canvas.notes["boxes"][canvas.notes["cut"]]
    if canvas.path[-1] > 0 and canvas.notes["fracture"]:
        return [place(canvas, point) for point in chain_ahead(canvas)]
    if canvas.path[-1] > 0:
        first = canvas.notes["chain"]
        away = canvas.pick([2, 1.5, 1.75, 2.5, 3] +
                           ([] if canvas.situation == "pressed" else [0.2, 0.4, 0.7, 1]))
        (x0, y0), (x1, y1) = first[0], first[-1]
        length = math.hypot(x1 - x0, y1 - y0)
        side = 1 if y0 < (low[1] + high[1]) / 2 else -1
        across = [-(y1 - y0) / length * away * side, (x1 - x0) / length * away * side]
        order = reversed(first) if canvas.chance(50) else first
        return [place(canvas, [point[k] + across[k] for k in range(2)]) for point in order]
    width = [high[k] - low[k] for k in range(2)]
    if canvas.notes["past"]:
        chain = chain_past(canvas, low, high)
    elif canvas.notes["fracture"]:
        height = low[1] + width[1] // 2 + 0.4371
        outside = 2
        if (0, low[0]) in canvas.notes.get("planes", []):
            outside = PAST_ROOM - 0.3
        if canvas.axisymmetric:
            outside = min(outside, low[0] - canvas.notes["axis"])
        chain = [[low[0] - outside, height], [low[0], height],
                 [low[0] + width[0] // 2 + 0.3419, height]]
        chain = chain if outside else chain[1:]
        canvas.notes["tip"] = canvas.pick(["end", "start"])
        if canvas.notes["tip"] == "start":
            chain.reverse()
    elif canvas.situation == "pressed":
        angle = canvas.pick([0, 0, 45, -30, 60])
        height = low[1] + width[1] // 2 + canvas.pick([0.47, 0.03, 0.37])
        reach = canvas.pick([0.4, 0.25])
        face = low[0] if canvas.axisymmetric else low[0] - 0.07
        start = face if canvas.chance(50) else low[0] + 1.29  # 1.37 with 0.37: through nodes
        run = width[0] * reach
        chain = [[start, height], [start + run * math.cos(math.radians(angle)),
                                   height + run * math.sin(math.radians(angle))]]
    elif canvas.notes["contact"]:
        chain = chain_in_one_body(canvas, low, high)
    else:
        angle = math.radians(canvas.integer(0, 11) * 30 + 7)
        half = canvas.number(0.8, 0.7 * min(width) / 2, 4)
        middle = [low[k] + width[k] * canvas.number(0.4, 0.6, 4) + OFF[k] for k in range(2)]
        arm = [half * math.cos(angle), half * math.sin(angle)]
        chain = [[middle[k] - arm[k] for k in range(2)], [middle[k] + arm[k] for k in range(2)]]
        if canvas.chance(25):
            kink = [middle[0] - 0.4 * arm[1], middle[1] + 0.4 * arm[0]]
            chain.insert(1, kink)
    canvas.notes["chain"] = chain
    return [place(canvas, point) for point in chain]


def chain_in_one_body(canvas, low, high):
    """A chain within the body, or from one of its faces, which another body may touch."""
    width = [high[k] - low[k] for k in range(2)]
    reach = 0.3 * min(width)
    middle = [low[k] + width[k] * canvas.number(0.4, 0.6, 4) + OFF[k] for k in range(2)]
    if canvas.chance(50):
        axis, at_end = SIDES[canvas.pick(["left", "bottom", "right", "top"])]
        mouth = [middle[k] + reach * canvas.number(-0.7, 0.7, 4) for k in range(2)]
        mouth[axis] = (high if at_end else low)[axis]
        return [mouth, middle] if canvas.chance(50) else [middle, mouth]
    angle = math.radians(canvas.integer(0, 11) * 30 + 7)
    arm = [reach * math.cos(angle), reach * math.sin(angle)]
    return [[middle[k] - arm[k] for k in range(2)], [middle[k] + arm[k] for k in range(2)]]


def chain_ahead(canvas):
    """A chain ahead of a tip that grows, at an angle to its way, beyond the contour of two cells."""
    tip = canvas.notes["chain"][-1 if canvas.notes["tip"] == "end" else 0]
    angle = math.radians(canvas.pick([90, 60, 120, 45]))
    ahead = canvas.pick([3.1, 2.6, 3.6])
    arm = [1.2 * math.cos(angle), 1.2 * math.sin(angle)]
    signs = canvas.pick([(-1, 1), (1, -1)])
    return [[tip[k] + (ahead if k == 0 else 0) + sign * arm[k] for k in range(2)]
            for sign in signs]


def chain_past(canvas, low, high):
    """A chain straight across the plane of symmetry that is there for it, from either end, as far
    inside and outside as particles reach; with a point on the plane, which a cohesive crack needs."""
    axis, at_end = SIDES[canvas.notes["past"]]
    along, inward = (high, -1) if at_end else (low, 1)
    across = low[1 - axis] + (high[1 - axis] - low[1 - axis]) * canvas.number(0.4, 0.6, 4) + OFF[1 - axis]
    chain = [[0, 0], [0, 0], [0, 0]]
    for point, depth in zip(chain, (0.3 - PAST_ROOM, 0, canvas.pick([3.6, 4.2]))):
        point[axis], point[1 - axis] = along[axis] + inward * depth, across
    if canvas.chance(50):
        chain.reverse()
    return chain


def draw_contact(canvas, key):
    """Any."""
    if canvas.situation == "pressed":
        return "frictionless"
    return canvas.pick(key.choices) if canvas.chance(70) else ABSENT


def draw_friction(canvas, _):
    """Goes with contact: friction."""
    if canvas.notes["group"].get("contact") != "friction":
        return ABSENT
    return canvas.pick([0.3, 0, 1])


def draw_separated(canvas, key):
    """Below 1, and close to it in most scenes."""
    if canvas.situation == "pressed" or canvas.chance(60):
        return ABSENT
    return canvas.pick([0.9, 0.999, 0.5, short((key.low + key.high) / 4)])


def draw_touching(canvas, _):
    """Above 1."""
    if canvas.situation == "pressed" or canvas.chance(60):
        return ABSENT
    return canvas.pick([1.1, 1.001, 1.5, 2])


def draw_opening(canvas, _):
    """Not on a plane of symmetry."""
    if canvas.situation != "any":
        return ABSENT
    return canvas.pick([False, True]) if canvas.chance(30) else ABSENT


def draw_cohesive(canvas, key):
    """Strength a hundredth of the stiffest modulus, toughness above what the rise takes."""
    if canvas.situation != "any" or not canvas.chance(20):
        return ABSENT
    law = canvas.pick(key.child("law").choices)
    strength = short(0.02 * canvas.scale(key.child("strength").unit))
    stiffness = short(canvas.pick([0.2, 1]) * canvas.scale(key.child("stiffness").unit))
    onset = strength / stiffness
    cohesive = {"law": law, "strength": strength, "stiffness": stiffness,
                "toughness": short(canvas.pick([4, 10]) * strength * onset)}
    if law == "trilinear":
        cohesive["knee_opening"] = short(2 * onset)
        cohesive["knee_traction"] = short(0.4 * strength)
    return cohesive


def draw_tip(canvas, _):
    """The one in the body."""
    if canvas.notes["tip"] == "end" and canvas.chance(50):
        return ABSENT
    return canvas.notes["tip"]


def draw_integral_count(canvas):
    """Of the straight crack that is there for it."""
    return 1 if canvas.notes["fracture"] and canvas.path[-1] == 0 else 0


def draw_form(canvas, key):
    """More often than other choices: integrals are in few scenes."""
    return canvas.pick(key.choices) if canvas.chance(70) else ABSENT


def draw_contour(_canvas, key):
    """The smallest that there is: bodies are small."""
    return int(key.low)


def draw_propagation(canvas, key):
    """A toughness that some scenes reach."""
    if not canvas.chance(40):
        return ABSENT
    unit = key.child("toughness").unit
    growth = {"toughness": short(canvas.pick([1e-4, 1e-2]) * canvas.scale(unit)),
              "longest": short(1.5 * min(canvas.cell))}
    for name in ("increment", "direction", "every"):
        if canvas.chance(40):
            child = key.child(name)
            growth[name] = canvas.pick(child.choices or [1] if name != "increment" else [0.5, 0.25])
    return growth
