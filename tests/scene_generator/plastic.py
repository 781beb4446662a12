"""Invariants of plastic strain. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy

import numpy

from case import require
from draw_plastic import PLASTIC
from heat import ended
from images import same_bits

SAME = {"position": 1, "velocity": 1, "deformation_gradient": 1, "stress": 1, "plastic_strain": 1}
OF_VON_MISES = ("hardening_modulus", "hardening_strain", "hardening_exponent", "kinematic_modulus",
                "hardening_table")
OF_JOHNSON_COOK = ("hardening_coefficient", "hardening_exponent", "rate_coefficient",
                   "reference_rate", "softening_exponent", "reference_temperature",
                   "melting_temperature", "taylor_quinney", "specific_heat", "start_temperature")
SIMPLE = ("von_mises", "johnson_cook")  # whose stress does not depend on plastic work


def is_plastic(case):
    """Has a material plastic strain?"""
    return any(material["law"] in PLASTIC for material in case.scene["materials"])


def plastic_work(history):
    """What plastic strain has dissipated, as heat of the temperature that is conducted or not."""
    return history["plastic_dissipation"] + history.get("plastic_heat", 0.0)


def plastic_work_never_falls(case):
    """Plastic strain is at least 0, and what it dissipates does not fall, but for round-off of a sum."""
    base = case.base
    if base.status != 0 or not is_plastic(case):
        return False
    work = plastic_work(base.history)
    fall = -numpy.diff(work).min(initial=0.0)
    require(fall <= 1e-13 * work[-1], f"plastic_dissipation falls by {fall:.3g} of {work[-1]:.3g}")
    least = base.end.fields["plastic_strain"].min()
    require(least >= 0.0, f"a plastic strain of {least:.3g}")
    return True


def elastic_until_yield(case):
    """With a yield stress that nothing reaches there is no plastic strain: no work is dissipated."""
    if case.plain.status != 0 or not is_plastic(case):
        return False
    scene = copy.deepcopy(case.brief)
    for material in scene["materials"]:
        if "yield_stress" in material:
            material["yield_stress"] *= 1e6
        for point in material.get("hardening_table", []):
            point[1] *= 1e6
    run = case.runner.run(scene)
    if run.status != 0:
        return False
    work = plastic_work(run.history)[-1]
    require(work == 0.0, f"{work:.3g} dissipated below a millionth of the yield stress")
    return True


def perfect_metals_are_one(case):
    """Without hardening, rates and heat von Mises' law is Johnson and Cook's, to the last bit."""
    if case.plain.status != 0 or not any(
            material["law"] in SIMPLE for material in case.scene["materials"]):
        return False
    runs = []
    for law in SIMPLE:
        scene = copy.deepcopy(case.brief)
        scene.get("transport", {}).get("temperature", {}).pop("heating", None)
        for material in scene["materials"]:
            if material["law"] in SIMPLE:
                if "hardening_table" in material:
                    material["yield_stress"] = material["hardening_table"][0][1]
                for name in OF_VON_MISES + OF_JOHNSON_COOK:
                    material.pop(name, None)
                material["law"] = law
        runs.append(scene)
    one = case.runner.run(runs[0])
    if one.status != 0:
        return False
    same_bits(one, ended(case, runs[1], "as johnson_cook"), SAME, "as johnson_cook")
    return True
