"""Draws heat conduction: functions (canvas, key) of the tables in meaning.py.

Temperatures vary by 1, from a level of 0, 10 or -3; a conductivity of the natural size has a stable step
of a quarter of a cell at the speed of waves.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, draw_value, short
from draw_bodies import SIDES, is_rigid
from draw_loads import line, nodes_across, place

RADIATING_LEVEL = 10  # absolute temperatures stay above 0


# ---------------------------------------------------------------------- materials
def draw_law(canvas, key):
    """None where nothing moves, and no other law is."""
    if canvas.notes["still"]:
        return "none"
    return canvas.pick([law for law in key.choices
                        if law not in ("none", "ideal_gas", "von_mises")])


def draw_heat_capacity(canvas, key):
    """Of each material of a scene with heat."""
    if not canvas.notes["heat"]:
        return ABSENT
    return short(canvas.pick([1, 0.5, 3]) * canvas.scale(key.unit))


def draw_size(canvas):
    """Of a conductivity; where all were 0 and nothing moved, no step would follow."""
    return canvas.pick([0.25, 1, 0.02, 0.0 if not canvas.notes["still"] else 0.5])


def draw_conductivity(canvas, key):
    """A number, or a tensor below."""
    canvas.notes["tensor"] = canvas.notes["heat"] and canvas.chance(40)
    if not canvas.notes["heat"] or canvas.notes["tensor"]:
        return ABSENT
    return short(draw_size(canvas) * canvas.scale(key.unit))


def draw_principal(canvas, key):
    """Two of them, equal or not."""
    if not canvas.notes["tensor"]:
        return ABSENT
    return [short(draw_size(canvas) * canvas.scale(key.unit)) for _ in range(2)]


def draw_angle(canvas, _):
    """Of a tensor's first axis, in degrees."""
    if not canvas.notes["tensor"] or not canvas.chance(70):
        return ABSENT
    return canvas.pick([30, 90, -45, 137.5, -360])


# ------------------------------------------------------------------- temperatures
def draw_field(canvas, key, time=True):
    """A temperature: the scene's level and a change of up to 1, in one direction, in both, or within cells."""
    level = canvas.notes["level"]
    names = ["r", "z"] if canvas.axisymmetric else ["x", "y"]
    centre = canvas.notes["centre"]
    form = canvas.integer(0, 4)
    if form == 3:
        size = short(canvas.pick([0.02, -0.02]) / (canvas.cell[0] * canvas.cell[1]))
        change = f"{size}*(({names[0]}-({centre[0]}))*({names[1]}-({centre[1]})))"
    elif form == 4:
        axis = canvas.integer(0, 1)
        change = f"0.5*sin({names[axis]}*{short(canvas.pick([1, 2.5]) / canvas.cell[axis])})"
    else:
        change = canvas.expression(key.unit, 1, time=time)
    if isinstance(change, str):
        return f"{level}+{change}" if level else change
    return short(level + change)


def draw_body_temperature(canvas, key):
    """Of a body's own, at t = 0."""
    if not canvas.notes["heat"] or is_rigid(canvas) or not canvas.chance(50):
        return ABSENT
    return draw_field(canvas, key, time=False)


# ---------------------------------------------------------------------- transport
def draw_transport(canvas, key):
    """Of scenes with heat: one group for each scalar that the schema has."""
    if not canvas.notes["heat"]:
        return ABSENT
    return {scalar.name: draw_scalar(canvas, scalar) for scalar in key.children
            if scalar.name == "temperature"}


def draw_scalar(canvas, key):
    """Start, source, conditions, fluxes."""
    scalar = {}
    fluxes = [draw_flux(canvas, key.child("fluxes")) for _ in range(canvas.pick([0, 0, 1, 1, 2]))]
    if canvas.chance(50):
        scalar["transfer"] = draw_value(canvas, key.child("transfer"), ())
    if canvas.notes["level"] or canvas.chance(60):
        scalar["start"] = draw_field(canvas, key.child("start"), time=False)
    if canvas.chance(30):
        scalar["source"] = canvas.expression(key.child("source").unit, 0.05)
    conditions = draw_conditions(canvas, key.child("conditions"))
    return scalar | {name: entries for name, entries in
                     (("conditions", conditions), ("fluxes", fluxes)) if entries}


def draw_conditions(canvas, key):
    """None, one, or two: lines of nodes at sides of the bodies, through them or around; rectangles; all
    nodes. Two have the same value unless no node can be on both."""
    count = canvas.pick([0, 0, 1, 1, 2])
    low, high = canvas.notes["whole"]
    if count == 0:
        return []
    value = key.child("value")
    if count == 2 and canvas.chance(50):  # opposite sides
        normal = canvas.integer(0, 1)
        return [{"region": line(canvas, nodes_across(canvas, normal, end[normal])),
                 "value": draw_field(canvas, value)} for end in (low, high)]
    shared = draw_field(canvas, value)
    return [{"region": draw_region(canvas), "value": shared} for _ in range(count)]


def draw_region(canvas):
    """Of a condition."""
    low, high = canvas.notes["whole"]
    normal, at_end = SIDES[canvas.pick(list(SIDES))]
    ends = nodes_across(canvas, normal, (high if at_end else low)[normal])
    form = canvas.integer(0, 5)
    middle = [(low[k] + high[k]) // 2 for k in range(2)]
    if form == 5:
        return {"all": True}
    if form == 4:
        return {"rectangle": {"from": place(canvas, middle),
                              "to": place(canvas, [middle[0] + 1, middle[1] + 2])}}
    if form == 3:  # through the bodies
        ends = nodes_across(canvas, normal, middle[normal])
    if form == 2:  # a part of the side
        ends[1][1 - normal] = middle[1 - normal]
    return line(canvas, ends)


def draw_flux(canvas, key):
    """One of the three kinds, through edges that are not at the axis."""
    edges = key.child("edge").choices
    low, _ = canvas.notes["whole"]
    if canvas.notes["axis"] is not None and low[0] <= canvas.notes["axis"]:
        edges = [edge for edge in edges if edge not in ("left", "all")]
    flux = {"body": f"b{canvas.integer(0, canvas.notes['deformable'] - 1)}",
            "edge": canvas.pick(edges)}
    kinds = ["value", "convection"] + ["radiation"] * (canvas.notes["level"] == RADIATING_LEVEL)
    kind = canvas.pick(kinds)
    part = key.child(kind)
    if kind == "value":
        flux["value"] = canvas.expression(part.unit, 0.1)
        return flux
    ambient = draw_field(canvas, part.child("ambient"))
    if kind == "convection":
        size = canvas.pick([0.1, 0.5, 0.02]) * canvas.scale(part.child("coefficient").unit)
        flux[kind] = {"coefficient": short(size), "ambient": ambient}
    else:  # as large as convection at the scene's level
        size = canvas.pick([0.1, 0.5]) * canvas.scale(part.child("sigma").unit)
        flux[kind] = {"emissivity": canvas.pick([1, 0.5]),
                      "sigma": short(size / (4 * RADIATING_LEVEL ** 3)), "ambient": ambient}
    return flux


LEVELS = [0, RADIATING_LEVEL, -3, RADIATING_LEVEL]
