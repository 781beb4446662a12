"""Draws transport, of heat and of a solvent: functions (canvas, key) of the tables in meaning.py.

Temperatures vary by 1, from a level of 0, 10 or -3, and concentrations by a quarter, from 0 or 0.5; a
conductivity of the natural size has a stable step of a quarter of a cell at the speed of waves.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math
import re

from draw import ABSENT, draw_value, short
from draw_bodies import SIDES, is_rigid
import draw_plastic as plastic
from draw_loads import line, nodes_across, place
from scales import SCALARS, bulk_modulus

RADIATING_LEVEL = 10  # absolute temperatures stay above 0
LEVELS = [0, RADIATING_LEVEL, -3, RADIATING_LEVEL]
PARTS = {"temperature": 1, "concentration": 0.25}  # by which they vary


# ------------------------------------------------------------------------ what there is
def settle(canvas):
    """Which scalars a scene conducts, and what of mechanics they change. In `coupled` stresses follow
    scalars; in `exchanging` bodies in contact, or the sides of cracks, exchange heat, in a part of the
    scenes with such stresses too. A third of those with mechanics has plastic strain."""
    notes, situation = canvas.notes, canvas.situation
    conducts = situation in ("heated", "coupled", "exchanging")
    kinds = ["heat", "heat", "heat", "solvent", "both"] if situation != "exchanging" else \
        ["heat", "heat", "heat", "heat", "both", "solvent"]
    kind = canvas.pick(kinds) if conducts else "none"
    notes["heat"], notes["solvent"] = kind in ("heat", "both"), kind in ("solvent", "both")
    notes["coupled"] = situation == "coupled" or situation == "exchanging" and canvas.chance(50)
    notes["exchanging"] = situation == "exchanging"
    notes["still"] = conducts and not notes["coupled"] and canvas.chance(50)
    notes["plastic"] = notes["plastic"] or conducts and not notes["still"] and canvas.chance(35)
    absolute = (notes["coupled"] or notes["plastic"]) and canvas.chance(70)
    notes["levels"] = {"temperature": canvas.pick([RADIATING_LEVEL] if absolute else LEVELS),
                       "concentration": canvas.pick([0, 0.5])}
    notes["gas"] = absolute and notes["heat"] and not notes["plastic"] and canvas.chance(50)
    notes["heats"] = absolute and notes["heat"] and canvas.chance(60)
    notes["tables"] = conducts and canvas.chance(25)


def scalar_of(key):
    """The scalar that a key is of."""
    solvent = re.search("concentration|saturation|swelling|diffusivit", key.path)
    return "concentration" if solvent else "temperature"


def is_conducted(canvas, key):
    """Does the scene conduct what the key is of?"""
    return canvas.notes["heat" if scalar_of(key) == "temperature" else "solvent"]


# ---------------------------------------------------------------------- materials
FLUIDS = ["mie_gruneisen", "stiffened_gas"]


def draw_law(canvas, key):
    """None where nothing moves, and no other law is."""
    if canvas.notes["still"]:
        return "none"
    if canvas.notes["plastic"]:
        return plastic.draw_law(canvas)
    if canvas.notes["gas"] and canvas.scene["geometry"] != "plane_stress" and canvas.chance(75):
        return "ideal_gas"
    fluid = canvas.situation == "any" and canvas.scene["geometry"] != "plane_stress" and \
        not canvas.notes["heat"] and canvas.chance(15)
    if fluid:
        return canvas.pick(FLUIDS)
    return canvas.pick([law for law in key.choices
                        if law not in ("none", "ideal_gas", *plastic.PLASTIC, *FLUIDS)])


def draw_of_fluid(sizes):
    """A parameter of a fluid, with waves as fast as in solids: one of these."""
    return lambda canvas, key: ABSENT if canvas.law_requires(key) is None else canvas.pick(sizes)


def draw_cutoff(canvas, key):
    """Of some fluids and solids with an equation of state: parts of the stiffness that stresses reach."""
    if canvas.law_requires(key) is None or not canvas.chance(50):
        return ABSENT
    material = canvas.notes["group"]
    return short(material["density"] * material["sound_speed"] ** 2 * canvas.pick([0.01, 0, 0.05]))


def draw_viscosity(canvas, _):
    """Of some materials, where nothing gives heat to it."""
    material = canvas.notes["group"]
    if material["law"] in ("none", "ideal_gas") or canvas.notes["heat"] or \
            canvas.scene["geometry"] == "plane_stress" or not canvas.chance(15):
        return ABSENT
    return {"linear": canvas.pick([0.1, 0, 0.5]), "quadratic": canvas.pick([1.5, 0, 0.5])}


def draw_gas_constant(canvas, key):
    """Waves as fast as in solids."""
    return canvas.pick([0.03, 0.1, 0.01]) if canvas.law_requires(key) else ABSENT


def draw_capacity(canvas, key):
    """Of heat or solvent: of each material of a scene that has it."""
    if not is_conducted(canvas, key):
        return ABSENT
    canvas.notes["varies"] = scalar_of(key) == "temperature" and canvas.notes["tables"] and \
        not canvas.notes["heats"] and canvas.chance(60)
    if canvas.notes["varies"]:
        return ABSENT
    return short(canvas.pick([1, 0.5, 3]) * canvas.scale(key.unit))


TABLE_ENDS = (-40, 60)  # beyond all values that scenes and invariants have


def draw_table(canvas, key, sizes):
    """Of a property: to either side of the scene's level it rises, falls, or has a peak."""
    scalar = scalar_of(key)
    level, part = canvas.notes["levels"][scalar], PARTS[scalar]
    places = [TABLE_ENDS[0], *(short(level + part * canvas.pick(away)) for away in
                               ([-0.5, -0.2], [0.1, 0.3], [0.6, 2])), TABLE_ENDS[1]]
    scale = canvas.scale(key.unit)
    kept = [0, *sorted(canvas.pick([[1, 2, 3], [2], [1, 3], []])), 4]
    return [[places[k], short(canvas.pick(sizes) * scale)] for k in kept]


def draw_capacity_table(canvas, key):
    """In the place of a number."""
    if not is_conducted(canvas, key) or not canvas.notes["varies"]:
        return ABSENT
    return draw_table(canvas, key, [1, 0.5, 2])


def draw_conductivity_table(canvas, key):
    """In the place of a number."""
    if not canvas.notes["table of " + scalar_of(key)]:
        return ABSENT
    return draw_table(canvas, key, [0.25, 1, 0.05])


def draw_size(canvas):
    """Of a conductivity; where all were 0 and nothing moved, no step would follow."""
    return canvas.pick([0.25, 1, 0.02, 0.0 if not canvas.notes["still"] else 0.5])


def draw_conductivity(canvas, key):
    """A number, or a tensor below."""
    tensor = is_conducted(canvas, key) and canvas.chance(40)
    canvas.notes["tensor of " + scalar_of(key)] = tensor
    table = is_conducted(canvas, key) and not tensor and canvas.notes["tables"] and canvas.chance(70)
    canvas.notes["table of " + scalar_of(key)] = table
    if not is_conducted(canvas, key) or tensor or table:
        return ABSENT
    return short(draw_size(canvas) * canvas.scale(key.unit))


def draw_principal(canvas, key):
    """Two of them, equal or not."""
    if not canvas.notes["tensor of " + scalar_of(key)]:
        return ABSENT
    return [short(draw_size(canvas) * canvas.scale(key.unit)) for _ in range(2)]


def draw_angle(canvas, key):
    """Of a tensor's first axis, in degrees."""
    if not canvas.notes["tensor of " + scalar_of(key)] or not canvas.chance(70):
        return ABSENT
    return canvas.pick([30, 90, -45, 137.5, -360])


HEATING_MOST = 0.2  # 9 alpha^2 K T/(rho c): by how much adiabatic moduli are larger


def draw_expansion(canvas, key):
    """Of solids whose stresses follow a scalar: percents of a strain for the changes that scalars have."""
    material = canvas.notes["group"]
    if not canvas.notes["coupled"] or not is_conducted(canvas, key) or \
            material["law"] in ("ideal_gas", *FLUIDS) or canvas.chance(20):
        return ABSENT
    if scalar_of(key) == "concentration":
        return canvas.pick([0.04, -0.02, 0.1, 0])
    capacity = SCALARS["temperature"].capacity_per_volume(material)
    most = math.sqrt(HEATING_MOST * capacity /
                     (9 * bulk_modulus(material) * (RADIATING_LEVEL + 3)))
    return canvas.pick([1, -1, 0.3, 0]) * short(min(0.02, most))


def draw_stress_free(canvas, key):
    """Goes with expansion: at the level of the scene, or beside it."""
    scalar = scalar_of(key)
    if {"temperature": "thermal_expansion", "concentration": "swelling"}[scalar] not in \
            canvas.notes["group"]:
        return ABSENT
    return short(canvas.notes["levels"][scalar] + canvas.pick([0, 0, 0.5, -0.25]))


# ------------------------------------------------------------------- temperatures
def draw_field(canvas, key, time=True):
    """A scalar: the scene's level and a change of up to 1, or a quarter, in one direction, in both, or within cells."""
    level, part = canvas.notes["levels"][scalar_of(key)], PARTS[scalar_of(key)]
    names = ["r", "z"] if canvas.axisymmetric else ["x", "y"]
    centre = canvas.notes["centre"]
    form = canvas.integer(0, 4)
    if form == 3:
        size = short(part * canvas.pick([0.02, -0.02]) / (canvas.cell[0] * canvas.cell[1]))
        change = f"{size}*(({names[0]}-({centre[0]}))*({names[1]}-({centre[1]})))"
    elif form == 4:
        axis = canvas.integer(0, 1)
        change = f"{0.5 * part}*sin({names[axis]}*{short(canvas.pick([1, 2.5]) / canvas.cell[axis])})"
    else:
        change = canvas.expression(key.unit, part, time=time)
    if isinstance(change, str):
        return f"{level}+{change}" if level else change
    return short(level + change)


def draw_body_start(canvas, key):
    """Of a body's own, at t = 0."""
    if not is_conducted(canvas, key) or is_rigid(canvas) or not canvas.chance(50):
        return ABSENT
    return draw_field(canvas, key, time=False)


# ---------------------------------------------------------------------- transport
def draw_transport(canvas, key):
    """Of scenes that conduct: one group for each scalar, and steps of their own beside mechanics."""
    groups = [child for child in key.children if child.shape == "group" and
              is_conducted(canvas, child)]
    if not groups:
        return ABSENT
    transport = {}
    if not canvas.notes["still"]:
        for name in ("substeps", "every"):
            if canvas.chance(25):
                transport[name] = canvas.pick([2, 1, 3, 7])
    return transport | {scalar.name: draw_scalar(canvas, scalar) for scalar in groups}


def draw_heating(canvas):
    """Heat of deformation, where something expands or is a gas, and temperatures are absolute; and of
    plastic work."""
    changes = any(material["law"] == "ideal_gas" or "taylor_quinney" in material or
                  material.get("thermal_expansion", 0) != 0
                  for material in canvas.scene["materials"])
    return {"heating": True} if canvas.notes["heats"] and changes else \
        {"heating": False} if canvas.chance(10) else {}


def draw_scalar(canvas, key):
    """Start, source, conditions, fluxes."""
    scalar = {}
    fluxes = [draw_flux(canvas, key.child("fluxes")) for _ in range(canvas.pick([0, 0, 1, 1, 2]))]
    if canvas.chance(50):
        scalar["transfer"] = draw_value(canvas, key.child("transfer"), ())
        if scalar["transfer"] in ("xpic", "fmpm"):
            scalar["order"] = canvas.integer(1, 4)
    if canvas.notes["levels"][key.name] or canvas.chance(60):
        scalar["start"] = draw_field(canvas, key.child("start"), time=False)
    if canvas.chance(30):
        scalar["source"] = canvas.expression(key.child("source").unit, 0.05)
    if key.child("heating") is not None:
        scalar |= draw_heating(canvas)
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
    kinds = ["value", "convection"]
    if key.child("radiation") is not None and canvas.notes["levels"]["temperature"] == RADIATING_LEVEL:
        kinds.append("radiation")
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
