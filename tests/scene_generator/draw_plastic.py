"""Draws materials with plastic strain: functions (canvas, key) of the tables in meaning.py.

Bodies move at parts of the speed of waves, so that stresses are such parts of the modulus: yield stresses are
between a thousandth and a tenth of it, and half of the scenes yield. Temperatures are from 10 on, 1 or 2
below melting, with a heat capacity at which softening is less steep than elastic unloading: s^2/(rho c
(T_m - T_r)) is far below 3 G. Beyond, the stress falls in a few steps of any size, and with it elastic
energy that nothing counts: a law without a solution.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, short

PLASTIC = ["von_mises", "johnson_cook", "von_mises_gruneisen", "johnson_cook_gruneisen"]
ABSOLUTE = 10  # level of temperatures that soften, see draw_heat.py
WITH_TEMPERATURE = ("mie_gruneisen", "von_mises_gruneisen")  # of which it changes nothing


def draw_law(canvas):
    """One with plastic strain, or a solid beside it. Those with an equation of state keep their own heat."""
    if canvas.chance(15):
        return canvas.pick(["neo_hookean", "linear_elastic"])
    alone = canvas.scene["geometry"] == "plane_stress" or canvas.notes["heat"] or \
        canvas.notes["solvent"]
    return canvas.pick(PLASTIC[:2] if alone else PLASTIC)


def shear_modulus(material):
    """Of a material whose moduli are drawn."""
    if "shear" in material:
        return material["shear"]
    return material["young"] / (2 * (1 + material["poisson"]))


def draw_yield_stress(canvas, _):
    """A part of the shear modulus; settles what else the material has."""
    notes = canvas.notes
    if notes["group"]["law"] not in PLASTIC:
        return ABSENT
    notes["hardens"], notes["rates"] = canvas.chance(60), canvas.chance(50)
    notes["softens"] = notes["group"]["law"].startswith("johnson_cook") and canvas.chance(60) and \
        (not notes["heat"] or notes["levels"]["temperature"] == ABSOLUTE)
    notes["table"] = notes["group"]["law"].startswith("von_mises") and canvas.chance(25)
    if notes["table"]:
        notes["hardens"] = False
        return ABSENT
    return short(shear_modulus(notes["group"]) * canvas.pick([0.01, 0.002, 0.1, 0.03]))


def has(canvas, key):
    """Has the material's law the parameter?"""
    return canvas.law_requires(key) is not None


def draw_part(canvas, key):
    """A modulus of hardening."""
    if not has(canvas, key) or canvas.chance(50):
        return ABSENT
    return short(shear_modulus(canvas.notes["group"]) * canvas.pick([0.1, 0, 0.5]))


def draw_modulus(canvas, key):
    """Of isotropic hardening."""
    return ABSENT if has(canvas, key) and canvas.notes["table"] else draw_part(canvas, key)


def draw_table(canvas, _):
    """In the place of a yield stress and its hardening: up to four points, steep and level pieces."""
    if canvas.notes["group"]["law"] not in PLASTIC or not canvas.notes["table"]:
        return ABSENT
    stress = shear_modulus(canvas.notes["group"]) * canvas.pick([0.01, 0.002, 0.1, 0.03])
    points, strain = [[0, short(stress)]], 0
    for _ in range(canvas.integer(0, 3)):
        strain += canvas.pick([0.01, 0.001, 0.1])
        stress *= canvas.pick([1.3, 1, 2])
        points.append([short(strain), short(stress)])
    return points


def draw_hardening_strain(canvas, key):
    """Of a power, with its exponent."""
    return canvas.pick([0.01, 0.1, 0.001]) if has(canvas, key) and canvas.notes["hardens"] else ABSENT


def draw_exponent(canvas, key):
    """Of a power."""
    return canvas.pick([0.5, 0.3, 1]) if has(canvas, key) and canvas.notes["hardens"] else ABSENT


def draw_coefficient(canvas, key):
    """Of Johnson and Cook's power."""
    if not has(canvas, key) or not canvas.notes["hardens"]:
        return ABSENT
    return short(canvas.notes["group"]["yield_stress"] * canvas.pick([1, 0.3, 4]))


def draw_rate_coefficient(canvas, key):
    """With the reference rate."""
    return canvas.pick([0.02, 0.2]) if has(canvas, key) and canvas.notes["rates"] else ABSENT


def draw_reference_rate(canvas, key):
    """Below the rates of the scene and within them."""
    if not has(canvas, key) or not canvas.notes["rates"]:
        return ABSENT
    return short(canvas.pick([0.001, 0.05]) * canvas.scale(key.unit))


def draw_of_softening(sizes):
    """A parameter of softening: one of these."""
    def draw(canvas, key):
        return canvas.pick(sizes) if has(canvas, key) and canvas.notes["softens"] else ABSENT
    return draw


def draw_quinney(canvas, key):
    """Of softening by the law's own heat; of plastic work that heats the temperature that is conducted."""
    if not canvas.notes["heat"]:
        return draw_of_softening([1, 0.9])(canvas, key)
    return canvas.pick([1, 0.9, 0.4]) if has(canvas, key) and canvas.notes["heats"] and \
        canvas.chance(80) else ABSENT


def draw_specific_heat(canvas, key):
    """Of softening: strains of percents warm by some tenths. Of an equation of state alone, which has a
    temperature then; and of a gas, which has one without a start."""
    material = canvas.notes["group"]
    if canvas.notes["heat"]:  # the law has the temperature that is conducted
        canvas.notes["warm"] = False
        return ABSENT
    canvas.notes["warm"] = material["law"] in WITH_TEMPERATURE and canvas.chance(40)
    softens = has(canvas, key) and material["law"] in PLASTIC and canvas.notes["softens"]
    gas = material["law"] == "stiffened_gas" and canvas.chance(30)
    if softens:
        least = material["yield_stress"] ** 2 / (3 * shear_modulus(material) * material["density"])
        return short(least * canvas.pick([30, 300]))
    return canvas.pick([0.01, 0.1]) if gas or canvas.notes["warm"] else ABSENT


def draw_temperature(canvas, key):
    """At the start: the reference temperature, or beside it."""
    softens = has(canvas, key) and canvas.notes["group"]["law"] in PLASTIC and \
        canvas.notes["softens"] and not canvas.notes["heat"]
    return canvas.pick([10, 10.5, 9]) if softens or canvas.notes["warm"] else ABSENT
