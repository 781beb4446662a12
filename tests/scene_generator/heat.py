"""Invariants of transport, of heat and of a solvent. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import itertools
import math

import numpy

import compare
from case import evaluate, require
from images import agrees
from motion import LAST_DIGITS, inside_planes, nodes_of
from scalars import (alone, has_table, scalars_of, with_tables_higher, with_values, without_input,
                     without_scalars, without_tables)
from transform import Motion, names_of

LEVEL = 7.3  # of scalars that a scene is given, of the size of temperatures that it has


# ------------------------------------------------------------------------ balance
def heat_stored_is_heat_taken_in(case):
    """Heat and solvent, in each row of the history: what particles hold is what they began with, and what
    nodes with a prescribed value, the source and the edges have given, and deformation. What a scene
    does not have gives nothing, to the last bit. Round-off: of these sums, and of as many steps."""
    history = case.base.history
    if not case.conducts or case.base.status != 0:
        return False
    for scalar, keys in case.scalars.items():
        for name, key in zip(scalar.flows, ("conditions", "source", "fluxes")):
            require(keys.get(key) or not history[name].any(),
                    f"{name} of a scene without {key} is {compare.largest(history[name]):.3g}")
        given = list(scalar.flows)
        if scalar.name == "temperature" and case.heats:
            given.append("deformation_heat")
        gap = numpy.abs(history[scalar.content] - history[scalar.content][0] -
                        sum(history[name] for name in given))
        gross = sum(numpy.abs(numpy.diff(history[name], prepend=0.0)).cumsum() for name in given)
        allowed = 1e-14 * (gross + numpy.abs(history[scalar.content]) +
                           content_of_sizes(case, scalar)) * numpy.sqrt(1 + history["step"])
        row = int((gap / numpy.maximum(allowed, 1e-300)).argmax())
        require(gap[row] <= allowed[row], f"{scalar.content}: stored and taken in differ by "
                f"{gap[row]:.3g} at step {history['step'][row]:.0f}; allowed: {allowed[row]:.3g}")
    return True


def capacity_of(case, state, scalar):
    """The capacity of each particle; of a table the largest."""
    materials = {material["name"]: material for material in case.scene["materials"]}
    capacities = {body["name"]: scalar.capacity_per_volume(materials[body["material"]], max) /
                  materials[body["material"]]["density"] if "material" in body else 0.0
                  for body in case.scene["bodies"]}
    return state.mass * numpy.array([capacities[state.body_names[k]] for k in state.body])


def content_of_sizes(case, scalar):
    """Sum of c m |v| at the start and the end."""
    return sum((capacity_of(case, state, scalar) * numpy.abs(state.fields[scalar.name])).sum()
               for state in (case.base.start, case.base.end))


def values_around(case, text):
    """Values of an expression at corners, edges and the middle of the grid, and ten times of the run."""
    grid, names = case.scene["grid"], names_of(case.scene)
    places = [[first + part * side * count for part in numpy.linspace(0, 1, 41)] for
              first, side, count in zip(grid.get("origin", [0, 0]), grid["cell"], grid["cells"])]
    times = numpy.linspace(0, case.base.history["time"][-1], 10)
    if not isinstance(text, str):
        return [text]
    return [evaluate(text, t=time, **dict(zip(names, place)))
            for time in times for place in itertools.product(*places)]


def temperatures_stay_between(case):
    """Without a source, given fluxes and heat of deformation, scalars stay within those of the start, the
    conditions and the surroundings. The nodes' do; a particle's own with FLIP may differ from the nodes'
    by as much as it did before, and follow them: twice the range more on either side."""
    if case.base.status != 0:
        return False
    judged = False
    for scalar, given in case.scalars.items():
        fluxes = given.get("fluxes", [])
        if "source" in given or any("value" in flux for flux in fluxes) or \
                scalar.name == "temperature" and case.heats:
            continue
        start = case.base.start
        found = list(start.fields[scalar.name][start.of_bodies(case.deformable)])
        for condition in given.get("conditions", []):
            found += values_around(case, condition["value"])
        for flux in fluxes:
            found += values_around(case, (flux.get("convection") or flux["radiation"])["ambient"])
        low, high = min(found), max(found)
        slack = 2 * (high - low) + 1e-9 * max(abs(low), abs(high))
        history = case.base.history
        lowest = history[scalar.name + "_min"].min()
        highest = history[scalar.name + "_max"].max()
        require(low - slack <= lowest and highest <= high + slack,
                f"{scalar.name} between {lowest:.6g} and {highest:.6g}, where the start, the conditions "
                f"and the surroundings have {low:.6g} to {high:.6g}")
        judged = True
    return judged


def prescribed_temperatures_hold(case):
    """At the start of each step nodes with a prescribed value have it where gradients are taken. Not
    judged: transport with steps of its own, whose times mpm-nodes does not print."""
    if not any("conditions" in given for given in case.scalars.values()) or \
            case.plain.status != 0 or case.waits:
        return False
    status, message, rows = case.runner.nodes(case.brief)
    require(status == 0, f"mpm-nodes: exit {status}: {message}")
    rows = rows[inside_planes(case, rows[:, 3:5])]
    judged = False
    for scalar, given in case.scalars.items():
        column = {"temperature": 8, "concentration": 9}[scalar.name]
        for condition in given.get("conditions", []):
            for row in rows[nodes_of(condition["region"], rows[:, 3:5], case.cell)]:
                wanted = evaluate(condition["value"], t=row[1] - row[2],
                                  **dict(zip(names_of(case.scene), row[3:5])))
                judged = True
                require(abs(row[column] - wanted) <= 1e2 * LAST_DIGITS * (abs(wanted) + LEVEL),
                        f"step {row[0]:.0f}: node ({row[3]:g}, {row[4]:g}) has the {scalar.name} "
                        f"{row[column]:.6g}, not {wanted:.6g}")
    return judged


# --------------------------------------------------------------- changes of values
def radiates(case):
    """Is the scene not linear in temperature?"""
    return any("radiation" in flux for flux in case.fluxes)


def ended(case, scene, what, *options):
    """The result of a scene that must run as the brief one does."""
    other = case.runner.run(scene, *options)
    require(other.status == 0, f"{what}: exit {other.status}: {other.message}")
    return other


def same_motion(one, other, what):
    """Bits of both results' motion."""
    for name in ("position", "velocity", "deformation_gradient", "stress"):
        require((one.end.fields[name] == other.end.fields[name]).all(),
                f"{what}: {name} differs")


def close(one, other, size, what):
    """Arrays of a scalar, up to the round-off of steps with numbers of such a size."""
    off = compare.largest(one - other)
    require(off <= compare.ROUND_OFF * size, f"{what}: a scalar differs by {off:.3g}; allowed: "
            f"{compare.ROUND_OFF * size:.3g}")


def close_to(case, one, other, what, shift=0.0):
    """Scalars of both results, those of the other one less a shift."""
    inside = one.end.of_bodies(case.deformable)
    for scalar in case.scalars:
        mine, theirs = one.end.fields[scalar.name], other.end.fields[scalar.name] - shift
        size = compare.largest(mine) + compare.largest(one.start.fields[scalar.name]) + abs(shift)
        close(theirs[inside], mine[inside], size, what)


def temperatures_have_no_zero(case):
    """A scene without what depends on absolute temperatures, radiation, gases, softening and heat of
    deformation, and all scalars higher by a constant, of tables too: the answer is. Not judged with
    stresses: enthalpy of a capacity that varies, which is more by another sum."""
    if not case.conducts or radiates(case) or case.gas or case.softens or case.heats or \
            case.plain.status != 0 or case.couples and has_table(case.scene, "heat_capacity_table"):
        return False
    what = "scalars higher by a constant"
    higher = with_values(case.brief, lambda text: f"({text})+{LEVEL}")
    other = ended(case, with_tables_higher(higher, LEVEL), what)
    one = case.plain
    if case.couples:  # round-off of a scalar moves bodies
        for scalar in case.scalars:
            level = LEVEL * capacity_of(case, one.start, scalar).sum()
            other.end.fields[scalar.name][one.end.of_bodies(case.deformable)] -= LEVEL
            other.history[scalar.content] -= level
        return agrees(case, other, numpy.arange(len(one.end.id)), Motion(), what)
    same_motion(one, other, what)
    close_to(case, one, other, what, LEVEL)
    return True


def one_temperature_stays(case):
    """Bodies, conditions and surroundings of one value, without a source, given fluxes and heat of
    deformation: it stays, whatever moves."""
    if not case.conducts or case.heats or case.plain.status != 0:
        return False
    scene = without_input(with_values(case.brief, lambda _: LEVEL))
    end = ended(case, scene, "with one value").end
    for scalar in case.scalars:
        close(end.fields[scalar.name][end.of_bodies(case.deformable)], LEVEL, LEVEL, "with one value")
    return True


def surroundings_warm_what_is_colder(case):
    """Bodies of one value, and surroundings that are higher by 1: heat flows in, and not more than they
    need to become as warm. At the longest stable step an edge may swing, and give back less than it took."""
    if not case.conducts or case.heats or case.plain.status != 0:
        return False
    scene = without_input(with_values(case.brief, lambda _: LEVEL))
    warmed = []
    for name in ("substeps", "every"):
        scene["transport"].pop(name, None)
    for scalar, given in scalars_of(scene).items():
        given.pop("conditions", None)
        for flux in given.get("fluxes", []):
            (flux.get("convection") or flux["radiation"])["ambient"] = LEVEL + 1
        warmed += [scalar] if given.get("fluxes") else []
    if not warmed:
        return False
    run = ended(case, scene, "with warm surroundings")
    for scalar in warmed:
        gained = numpy.diff(run.history["edge_" + scalar.flow])
        room = capacity_of(case, run.start, scalar).sum()
        require(gained[0] > 0 and gained.min() > -gained.max() and 0 < gained.sum() < room,
                f"warm surroundings give {gained.min():.3g} to {gained.max():.3g} in a step, "
                f"{gained.sum():.3g} in all, to bodies that could take {room:.3g}")
    return True


# ------------------------------------------------------------------------- at rest
def in_fixed_steps(case, scene, parts=0.4):
    """The scene with a step that conduction bears, and waves that are as slow as it is made below."""
    scene["time"] = {"end": scene["time"]["end"], "steps": scene["time"]["steps"],
                     "step": parts / max(case.conduction_rate, case.wave / min(case.cell))}
    return scene


def with_slow_waves(case, scene, speed=None):
    """A scene without mechanics with bodies that waves pass slowly, at rest."""
    new = copy.deepcopy(scene)
    new["method"] = dict(new.get("method", {}), stress_update="musl")
    slowest = 0.1 * min(material["density"] for material in new["materials"]) * \
        (speed or case.wave) ** 2
    for material in new["materials"]:
        material |= {"law": "neo_hookean", "bulk": slowest, "shear": slowest}
    return new


def heat_alone_is_heat_in_a_body_at_rest(case):
    """The scene without mechanics has the temperatures of the one in which bodies are at rest."""
    if not case.conducts or case.plain.status != 0:
        return False
    one = in_fixed_steps(case, alone(case.brief))
    without = ended(case, one, "without mechanics")
    beside = ended(case, with_slow_waves(case, one), "at rest")
    for scalar in case.scalars:
        start, end = without.start.fields[scalar.name], without.end.fields[scalar.name]
        close(beside.end.fields[scalar.name], end, compare.largest(start) + compare.largest(end),
              "without mechanics and in bodies at rest")
    return True


def an_even_source_warms_evenly(case):
    """Insulated bodies at rest with one temperature and one capacity per volume: a source warms each of
    their particles at the rate s / (rho c), up to the end of the run, also where transport waits."""
    if not case.conducts or case.plain.status != 0:
        return False
    scene = without_tables(alone(with_values(case.brief, lambda _: LEVEL)))
    step = 0.4 / (case.conduction_rate * capacity_ratio(case) + case.wave / min(case.cell))
    scene["time"] = {"end": scene["time"]["end"], "steps": scene["time"]["steps"], "step": step}
    for scalar, given in scalars_of(scene).items():
        capacity = scalar.capacity_per_volume(scene["materials"][0])
        for material in scene["materials"]:
            material[scalar.capacity] *= capacity / scalar.capacity_per_volume(material)
        given.pop("fluxes", None), given.pop("conditions", None)
        given["source"] = capacity * LEVEL / (step * scene["time"]["steps"])
    waits = with_slow_waves(case, scene, 0.1 * min(case.cell) / step)
    waits["transport"] |= {"every": 3, "substeps": 2}
    for one, what in ((scene, "with an even source"), (waits, "and with transport that waits")):
        end = ended(case, one, what).end
        for scalar in case.scalars:
            close(end.fields[scalar.name], 2 * LEVEL, LEVEL, what)
    return True


def capacity_ratio(case):
    """The largest capacity per volume over the smallest, of the scalar for which that is more."""
    capacities = [[scalar.capacity_per_volume(material, of) for of in (min, max) for material in case.scene["materials"]]
                  for scalar in case.scalars]
    return max(max(each) / min(each) for each in capacities)


def a_held_gradient_stays(case):
    """All nodes held at one gradient, along z in axisymmetry and along planes of symmetry: bodies at rest
    have it already, whatever they conduct."""
    if not case.conducts or case.plain.status != 0:
        return False
    names, grid = names_of(case.scene), case.scene["grid"]
    slopes = [0 if case.axisymmetric else 0.3, -0.2]
    for boundary in case.scene.get("boundary", []):
        if "symmetry" in boundary:
            ends = boundary["region"]["line"]
            slopes[int(ends["from"][0] != ends["to"][0])] = 0
    field = f"{LEVEL}" + "".join(f"+({slope})*({name}-({first}))" for slope, name, first in
                                 zip(slopes, names, grid.get("origin", [0, 0])))
    scene = in_fixed_steps(case, without_tables(alone(case.brief)))
    for scalar, given in scalars_of(scene).items():
        for body in scene["bodies"]:
            body.pop(scalar.name, None)
        given.pop("fluxes", None), given.pop("source", None)
        given |= {"start": field, "conditions": [{"region": {"all": True}, "value": field}]}
    run = ended(case, scene, "with a held gradient")
    for scalar in case.scalars:
        start = run.start.fields[scalar.name]
        close(run.end.fields[scalar.name], start, compare.largest(start), "with a held gradient")
    return True


# ------------------------------------------------------------ what must not matter
def with_short_steps(case, scene):
    """The scene with steps that waves and conduction bear."""
    speed = case.wave + compare.largest(case.base.start.velocity)
    step = 0.2 * min(min(case.cell) / speed, 1 / max(case.conduction_rate, 1e-9))
    scene["time"] = {"end": scene["time"]["end"], "steps": scene["time"]["steps"], "step": step}
    return scene


def heat_moves_nothing(case):
    """Where stresses follow no scalar, the motion is the same to the last bit without transport. Where
    fast kernels lack something of the transport, both runs are the reference kernels'."""
    if not case.conducts or case.at_rest or case.couples or case.plain.status != 0:
        return False
    what = "without transport"
    for kernels in ("auto", "reference"):
        one = case.runner.run(with_short_steps(case, case.brief), "--kernels", kernels)
        if one.status != 0:
            return False
        without = without_scalars(with_short_steps(case, case.brief))
        other = ended(case, without, what, "--kernels", kernels)
        if one.kernels == other.kernels:
            break
    same_motion(one, other, what)
    return True


def tensors_in_other_words(case):
    """A number k is the tensor of k and k; the other axis at 90 degrees more is the same tensor."""
    if not case.conducts or case.plain.status != 0:
        return False
    scene = case.brief
    for material in scene["materials"]:
        for scalar in case.scalars:
            if scalar.one_table in material:
                continue
            if scalar.one in material:
                material[scalar.two] = 2 * [material.pop(scalar.one)]
                material[scalar.angle] = 17
            else:
                material[scalar.two].reverse()
                angle = material.get(scalar.angle, 0)
                material[scalar.angle] = angle - math.copysign(90, angle)
    what = "with tensors in other words"
    other = ended(case, scene, what)
    if case.couples:
        return agrees(case, other, numpy.arange(len(case.plain.end.id)), Motion(), what)
    same_motion(case.plain, other, what)
    close_to(case, case.plain, other, what)
    return True
