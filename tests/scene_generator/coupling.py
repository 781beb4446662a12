"""Invariants of what scalars and mechanics do to each other, of steps of transport, and of heat between
surfaces. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy

import numpy

import compare
from case import require
from draw_heat import FLUIDS
from heat import (LEVEL, capacity_of, close_to, ended, in_fixed_steps, with_short_steps,
                  with_slow_waves)
from images import agrees, same_bits
from scalars import (alone, groups_of, has_table, still, with_values, without_heat_of_strength,
                     without_input, without_passages, without_tables)
from scales import SCALARS
from transform import Motion

SAME = {"position": 1, "velocity": 1, "deformation_gradient": 1, "stress": 1, "temperature": 1,
        "concentration": 1}


def has_fluid(case):
    """Whether a material follows an equation of state."""
    return any(material["law"] in FLUIDS for material in case.scene["materials"])


# ------------------------------------------------------------------------- solvent
def as_heat(scene):
    """The scene without heat, its solvent called heat: c_s of a volume is the capacity c_s/rho of a mass,
    and its flux -c_s D grad mu that of a conductivity c_s D."""
    heat, solvent = SCALARS["temperature"], SCALARS["concentration"]
    given = scene["transport"].pop("concentration")
    scene["transport"]["temperature"] = given
    for body in scene["bodies"]:
        if solvent.name in body:
            body[heat.name] = body.pop(solvent.name)
    for material in scene["materials"]:
        capacity = material.pop(solvent.capacity)
        material[heat.capacity] = capacity / material["density"]
        if solvent.one_table in material:
            material[heat.one_table] = [[point, capacity * value]
                                        for point, value in material.pop(solvent.one_table)]
        elif solvent.one in material:
            material[heat.one] = capacity * material.pop(solvent.one)
        else:
            material[heat.two] = [capacity * part for part in material.pop(solvent.two)]
        for mine, other in ((solvent.angle, heat.angle), (solvent.expansion, heat.expansion),
                            (solvent.stress_free, heat.stress_free)):
            if mine in material:
                material[other] = material.pop(mine)
    return scene


def without_heat(scene):
    """The scene with its solvent alone."""
    scene["transport"].pop("temperature", None)
    for body in scene["bodies"]:
        body.pop("temperature", None)
    for material in scene["materials"]:
        for name in SCALARS["temperature"].of_material:
            material.pop(name, None)
        without_heat_of_strength(material)
    return without_passages(scene)


def solvent_is_heat_by_another_name(case):
    """The diffusion of a solvent is the conduction of heat with the same numbers, to the last bit; and so
    is what it moves. Not judged: laws that keep heat of their own, which a scene with solvent may have and
    one with heat may not."""
    if SCALARS["concentration"] not in case.scalars or case.gas or case.plain.status != 0 or \
            has_fluid(case):
        return False
    scene = without_heat(case.brief)
    one = case.runner.run(scene)
    if one.status != 0:
        return False
    other = ended(case, as_heat(copy.deepcopy(scene)), "with heat in the place of solvent")
    other.end.fields["concentration"] = other.end.fields["temperature"]
    same_bits(one, other, SAME, "with heat in the place of solvent")
    heat, solvent = SCALARS["temperature"], SCALARS["concentration"]
    for mine, theirs in zip((solvent.content, *solvent.flows), (heat.content, *heat.flows)):
        require((one.history[mine] == other.history[theirs]).all(),
                f"{mine} is not {theirs} with heat in the place of solvent")
    return True


# ----------------------------------------------------------------------- expansion
def no_expansion_changes_no_digit(case):
    """Materials that expand by nothing, with transport: the answer is that of those that do not expand,
    to the last bit, with the same kernels. Not judged: fluids, whose laws have no expansion."""
    if not case.conducts or case.at_rest or case.gas or case.plain.status != 0 or has_fluid(case):
        return False
    one, other = with_short_steps(case, case.brief), with_short_steps(case, case.brief)
    for scene in (one, other):
        scene["transport"].get("temperature", {}).pop("heating", None)
        for material in scene["materials"]:
            without_heat_of_strength(material)
            for scalar in case.scalars:
                material |= {scalar.expansion: 0, scalar.stress_free: LEVEL}
                if scene is one:
                    del material[scalar.expansion], material[scalar.stress_free]
    without = case.runner.run(one, "--kernels", "reference")
    if without.status != 0:
        return False
    same_bits(without, ended(case, other, "with an expansion of 0", "--kernels", "reference"), SAME,
              "with an expansion of 0")
    return True


def bodies_free_of_stress_stay(case):
    """Bodies at rest, with all scalars at the values at which they are free of stress: only round-off of
    the scalars moves them. Not judged: gases, which always have a pressure, and adhesion."""
    if not case.couples or case.gas or case.plain.status != 0:
        return False
    scene = without_input(with_values(still(case.brief), lambda _: LEVEL))
    run = case.runner.run(scene)
    require(run.status in (0, 2), f"at rest: exit {run.status}: {run.message}")
    if run.status == 2:
        return False
    way = compare.largest((run.end.position - run.start.position) / case.cell)
    speed = compare.largest(run.end.velocity) / case.wave
    require(max(way, speed) <= compare.ROUND_OFF, f"bodies free of stress move by {way:.3g} of a cell, "
            f"{speed:.3g} of the wave speed; allowed: {compare.ROUND_OFF:.3g}")
    return True


def closed_box(case):
    """The scene's grid, method and gas, in a box of planes of symmetry, of one temperature."""
    low, high = case.base.start.position.min(axis=0), case.base.start.position.max(axis=0)
    grid, cell = case.scene["grid"], numpy.array(case.scene["grid"]["cell"])
    first = numpy.array(grid.get("origin", [0, 0]))
    low = first + numpy.floor((low - first) / cell) * cell
    high = first + numpy.ceil((high - first) / cell) * cell
    corners = [[float(part) for part in corner] for corner in (low, high)]
    ends = [[float(part) for part in corner] for corner in (first, first + cell * grid["cells"])]
    gas = next(dict(material) for material in case.scene["materials"]
               if material["law"] == "ideal_gas")
    lattice = next((body["particles_per_cell"] for body in case.scene["bodies"]
                    if "particles_per_cell" in body), [2, 2])
    scene = case.brief
    scene["materials"] = [gas]
    scene["bodies"] = [{"name": "gas", "material": gas["name"], "particles_per_cell": lattice,
                        "region": {"rectangle": {"from": corners[0], "to": corners[1]}}}]
    scene["boundary"] = []
    for axis in range(2):
        for corner in corners:
            line = {"from": list(ends[0]), "to": list(ends[1])}
            line["from"][axis] = line["to"][axis] = corner[axis]
            scene["boundary"].append({"region": {"line": line}, "symmetry": True})
    for name in ("loads", "contact", "cracks"):
        scene.pop(name, None)
    scene["transport"] = {"temperature": {"start": LEVEL} | {
        name: value for name, value in case.scene["transport"]["temperature"].items()
        if name in ("heating", "transfer", "order")}}
    for name in SCALARS["concentration"].of_material:
        gas.pop(name, None)
    return scene


def gas_in_a_closed_box_stays(case):
    """A gas of one temperature that fills a planar box between planes of symmetry stays as it is: pressures
    on either side of a node cancel to round-off."""
    if not case.gas or case.axisymmetric or case.base.status == 2:
        return False
    run = ended(case, closed_box(case), "in a closed box")
    way = compare.largest((run.end.position - run.start.position) / case.cell)
    warmer = compare.largest(run.end.temperature - LEVEL) / LEVEL
    require(max(way, warmer) <= compare.ROUND_OFF, f"a gas in a closed box moves by {way:.3g} of a cell, "
            f"its temperature changes by {warmer:.3g}; allowed: {compare.ROUND_OFF:.3g}")
    return True


# --------------------------------------------------------------- steps of transport
def substeps_that_nothing_needs_change_nothing(case):
    """A step of the mechanics that conduction bears is not divided, whatever transport.substeps; the passes
    are others, and so are last digits."""
    if not case.conducts or case.at_rest or case.plain.status != 0:
        return False
    one = with_short_steps(case, case.brief)
    for name in ("substeps", "every"):
        one["transport"].pop(name, None)
    other = copy.deepcopy(one)
    other["transport"]["substeps"] = 5
    return has_the_answer(case, other, one, "with substeps")


def has_the_answer(case, scene, other, what):
    """The answer to the scene is that to the other one, to round-off."""
    base = type(case)(case.runner, case.schema, other)
    if base.plain.status != 0:
        return False
    result = ended(case, scene, what)
    return agrees(base, result, numpy.arange(len(result.end.id)), Motion(), what)


STEPS, PARTS = 4, 3


def substeps_are_steps(case):
    """In bodies at rest, with fluxes that do not change in time: a step that conduction divides by three
    is three steps, and one that it has waited for is one as long as these. Not judged: radiation,
    whose limit changes with the temperature."""
    given = str([given.get("fluxes", []) for given in case.scalars.values()])
    if not case.conducts or case.plain.status != 0 or "radiation" in given or "t*" in given or \
            case.conduction_rate == 0:
        return False
    alike = without_tables(alone(case.brief))
    alike["output"] = {"history": 1e6 * case.brief["time"]["end"]}
    for parts, name, step in ((PARTS, "substeps", (PARTS - 0.5) / case.conduction_rate),
                              (1, "every", 0.3 / case.conduction_rate)):
        slow = with_slow_waves(case, alike, 0.1 * min(case.cell) / (PARTS * step))
        one, other = copy.deepcopy(slow), copy.deepcopy(slow)
        end = slow["time"]["end"]
        if name == "substeps":  # long ones against short ones
            one["time"] = {"end": end, "step": step, "steps": STEPS}
            other["time"] = {"end": end, "step": step / parts, "steps": STEPS * parts}
        else:  # short ones that wait against long ones
            one["time"] = {"end": end, "step": step / PARTS, "steps": STEPS * PARTS}
            other["time"] = {"end": end, "step": step, "steps": STEPS}
        one["transport"][name] = PARTS
        what = f"with transport.{name} and with such steps"
        close_to(case, ended(case, one, what), ended(case, other, what), what)
    return True


# ---------------------------------------------------------------- between surfaces
def heat_between_bodies_is_counted(case):
    """Of bodies in contact, without other heat: what those of one field hold changes by what the history
    has between it and the others; with insulated surfaces not at all."""
    heat = SCALARS["temperature"]
    if heat not in case.scalars or "contact" not in case.scene or case.heats or \
            case.plain.status != 0 or has_table(case.scene, heat.capacity_table):
        return False
    scene = without_input(case.brief, conditions=True)
    run = case.runner.run(scene)
    if run.status != 0:
        return False
    groups = groups_of(scene)
    gained = numpy.zeros(len(groups))
    for name, values in run.history.items():
        if name.startswith("contact_") and name.endswith("_heat"):
            one, other = map(int, name.split("_")[1:3])
            gained[one] -= values[-1]
            gained[other] += values[-1]
    contents = []
    for state in (run.start, run.end):
        each = capacity_of(case, state, heat) * state.temperature
        contents.append([each[state.of_bodies(group)].sum() for group in groups])
    size = 1e-14 * run.end.step * (numpy.abs(contents).sum() + compare.largest(gained))
    off = compare.largest(contents[1] - numpy.array(contents[0]) - gained)
    require(off <= size, f"fields hold {off:.3g} more or less than they have got from others; allowed: "
            f"{size:.3g}")
    return True


def perfect_bonds_make_one_body(case):
    """Bodies that are bonded, with perfect heat between them, are bodies that share a field: without
    mechanics, and with it where no rigid body takes part. Not in the momentum form, which divides by
    the mass of a body's own field (solver/README.md): the velocity form takes its place."""
    if "contact" not in case.scene or set(case.scalars) != {SCALARS["temperature"]} or \
            case.plain.status != 0 or len(groups_of(case.scene)) < 2:
        return False
    moves = not any("rigid" in body for body in case.scene["bodies"])
    bonded = in_fixed_steps(case, copy.deepcopy(case.brief) if moves else alone(case.brief))
    bonded.get("method", {}).pop("form", None)
    bonded["contact"] = {name: value for name, value in bonded["contact"].items()
                         if name == "fields"} | {"law": "bonded", "heat": "perfect"}
    one = copy.deepcopy(bonded)
    del one["contact"]
    what = "bonded bodies with perfect heat, and one"
    close_to(case, ended(case, bonded, what), ended(case, one, what), what)
    return True


def perfect_cracks_are_none(case):
    """Without mechanics, a crack that lets all heat through is none."""
    if not case.cracks or set(case.scalars) != {SCALARS["temperature"]} or case.plain.status != 0:
        return False
    cracked = in_fixed_steps(case, alone(case.brief))
    for crack in cracked["cracks"]:
        crack.pop("conductance", None)
        crack["heat"] = "perfect"
    one = copy.deepcopy(cracked)
    del one["cracks"]
    what = "without cracks that let all heat through"
    close_to(case, ended(case, cracked, what), ended(case, one, what), what)
    return True
