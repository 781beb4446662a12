"""Invariants of heat conduction. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import itertools
import math

import numpy

import compare
from case import evaluate, require
from meaning import OF_MOTION
from motion import LAST_DIGITS, inside_planes, nodes_of, still
from transform import names_of

LEVEL = 7.3  # of temperatures that a scene is given, of the size of those that it has


# ------------------------------------------------------------------------ balance
def heat_stored_is_heat_taken_in(case):
    """In each row of the history: what particles hold is what they began with, and what nodes with a
    prescribed temperature, the source and the edges have given. What a scene does not have gives
    nothing, to the last bit. Round-off: of these sums, and of as many steps."""
    history = case.base.history
    if case.heat is None or case.base.status != 0:
        return False
    given = ("boundary_heat", "source_heat", "edge_heat")
    for name, key in zip(given, ("conditions", "source", "fluxes")):
        require(case.heat.get(key) or not history[name].any(),
                f"{name} of a scene without {key} is {compare.largest(history[name]):.3g}")
    gap = numpy.abs(history["thermal_energy"] - history["thermal_energy"][0] -
                    sum(history[name] for name in given))
    gross = sum(numpy.abs(numpy.diff(history[name], prepend=0.0)).cumsum() for name in given)
    allowed = 1e-14 * (gross + numpy.abs(history["thermal_energy"]) + content_of_sizes(case)) * \
        numpy.sqrt(1 + history["step"])
    row = int((gap / numpy.maximum(allowed, 1e-300)).argmax())
    require(gap[row] <= allowed[row], f"heat stored and taken in differ by {gap[row]:.3g} at step "
            f"{history['step'][row]:.0f}; allowed: {allowed[row]:.3g}")
    return True


def capacity_of(case, state):
    """The heat capacity of each particle."""
    materials = {material["name"]: material for material in case.scene["materials"]}
    capacities = {body["name"]: materials[body["material"]]["heat_capacity"]
                  if "material" in body else 0.0 for body in case.scene["bodies"]}
    return state.mass * numpy.array([capacities[state.body_names[k]] for k in state.body])


def content_of_sizes(case):
    """Sum of c m |T| at the start and the end."""
    return sum((capacity_of(case, state) * numpy.abs(state.temperature)).sum()
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
    """Without a source and given fluxes, temperatures stay within those of the start, the conditions and
    the surroundings. The nodes' do; a particle's own with FLIP may differ from the nodes' by as much
    as it did before, and follow them: twice the range more on either side."""
    if case.heat is None or case.base.status != 0 or "source" in case.heat or \
            any("value" in flux for flux in case.fluxes):
        return False
    found = list(case.base.start.temperature[case.base.start.of_bodies(case.deformable)])
    for condition in case.heat.get("conditions", []):
        found += values_around(case, condition["value"])
    for flux in case.fluxes:
        found += values_around(case, (flux.get("convection") or flux["radiation"])["ambient"])
    low, high = min(found), max(found)
    slack = 2 * (high - low) + 1e-9 * max(abs(low), abs(high))
    history = case.base.history
    lowest, highest = history["temperature_min"].min(), history["temperature_max"].max()
    require(low - slack <= lowest and highest <= high + slack,
            f"temperatures between {lowest:.6g} and {highest:.6g}, where the start, the conditions and "
            f"the surroundings have {low:.6g} to {high:.6g}")
    return True


def prescribed_temperatures_hold(case):
    """At the start of each step nodes with a prescribed temperature have it where gradients are taken."""
    conditions = case.heat.get("conditions", []) if case.heat is not None else []
    if not conditions or case.plain.status != 0:
        return False
    status, message, rows = case.runner.nodes(case.brief)
    require(status == 0, f"mpm-nodes: exit {status}: {message}")
    rows = rows[inside_planes(case, rows[:, 3:5])]
    judged = False
    for condition in conditions:
        for row in rows[nodes_of(condition["region"], rows[:, 3:5], case.cell)]:
            wanted = evaluate(condition["value"], t=row[1] - row[2],
                              **dict(zip(names_of(case.scene), row[3:5])))
            judged = True
            require(abs(row[8] - wanted) <= 1e2 * LAST_DIGITS * (abs(wanted) + LEVEL),
                    f"step {row[0]:.0f}: node ({row[3]:g}, {row[4]:g}) has the temperature "
                    f"{row[8]:.6g}, not {wanted:.6g}")
    return judged


# ----------------------------------------------------------- changes of temperature
def with_temperatures(scene, change):
    """The brief scene with each temperature changed: start, bodies', conditions', surroundings'."""
    new = copy.deepcopy(scene)
    heat = new["transport"]["temperature"]
    heat["start"] = change(heat.get("start", 0))
    entries = [(body, "temperature") for body in new["bodies"]]
    entries += [(condition, "value") for condition in heat.get("conditions", [])]
    entries += [(flux[kind], "ambient") for flux in heat.get("fluxes", [])
                for kind in ("convection", "radiation") if kind in flux]
    for entry, name in entries:
        if name in entry:
            entry[name] = change(entry[name])
    return new


def radiates(case):
    """Is the scene not linear in temperature?"""
    return any("radiation" in flux for flux in case.fluxes)


def ended(case, scene, what):
    """The result of a scene that must run as the brief one does."""
    other = case.runner.run(scene)
    require(other.status == 0, f"{what}: exit {other.status}: {other.message}")
    return other


def same_motion(one, other, what):
    """Bits of both results' motion."""
    for name in ("position", "velocity", "deformation_gradient", "stress"):
        require((one.end.fields[name] == other.end.fields[name]).all(),
                f"{what}: {name} differs")


def close(one, other, size, what):
    """Arrays of temperatures, up to the round-off of steps with numbers of such a size."""
    off = compare.largest(one - other)
    require(off <= compare.ROUND_OFF * size, f"{what}: temperatures differ by {off:.3g}; allowed: "
            f"{compare.ROUND_OFF * size:.3g}")


def temperatures_have_no_zero(case):
    """A scene without radiation, all temperatures higher by a constant: the answer is."""
    if case.heat is None or radiates(case) or case.plain.status != 0:
        return False
    what = "temperatures higher by a constant"
    other = ended(case, with_temperatures(case.brief, lambda text: f"({text})+{LEVEL}"), what)
    one = case.plain
    same_motion(one, other, what)
    size = compare.largest(one.end.temperature) + compare.largest(one.start.temperature) + LEVEL
    inside = one.end.of_bodies(case.deformable)
    close((other.end.temperature - LEVEL)[inside], one.end.temperature[inside], size, what)
    return True


def one_temperature_stays(case):
    """Bodies, conditions and surroundings of one temperature, without a source and given fluxes: it
    stays, whatever moves."""
    if case.heat is None or case.plain.status != 0:
        return False
    scene = with_temperatures(case.brief, lambda _: LEVEL)
    heat = scene["transport"]["temperature"]
    heat.pop("source", None)
    heat["fluxes"] = [flux for flux in heat.get("fluxes", []) if "value" not in flux]
    end = ended(case, scene, "with one temperature").end
    close(end.temperature[end.of_bodies(case.deformable)], LEVEL, LEVEL, "with one temperature")
    return True


def surroundings_warm_what_is_colder(case):
    """Bodies of one temperature, and surroundings that are warmer by 1: heat flows in, and not more than they
    need to become as warm. At the longest stable step an edge may swing, and give back less than it took."""
    if case.heat is None or case.plain.status != 0:
        return False
    scene = with_temperatures(case.brief, lambda _: LEVEL)
    heat = scene["transport"]["temperature"]
    heat.pop("source", None), heat.pop("conditions", None)
    heat["fluxes"] = [flux for flux in heat.get("fluxes", []) if "value" not in flux]
    for flux in heat["fluxes"]:
        (flux.get("convection") or flux["radiation"])["ambient"] = LEVEL + 1
    if not heat["fluxes"]:
        return False
    run = ended(case, scene, "with warm surroundings")
    gained = numpy.diff(run.history["edge_heat"])
    room = capacity_of(case, run.start).sum()
    require(gained[0] > 0 and gained.min() > -gained.max() and 0 < gained.sum() < room,
            f"warm surroundings give {gained.min():.3g} to {gained.max():.3g} in a step, "
            f"{gained.sum():.3g} in all, to bodies that could take {room:.3g}")
    return True


# ------------------------------------------------------------------------- at rest
def alone(scene):
    """The scene without mechanics."""
    new = still(scene)
    for path in OF_MOTION:
        section, _, name = path.partition(".")
        if "[]" in section:
            continue
        if name:
            new.get(section, {}).pop(name, None)
        else:
            new.pop(section, None)
    for material in new["materials"]:
        for name in set(material) - {"name", "density"} - OF_HEAT:
            del material[name]
        material["law"] = "none"
    new["bodies"] = [body for body in new["bodies"] if "rigid" not in body]
    new["boundary"] = [boundary for boundary in new.get("boundary", []) if "symmetry" in boundary]
    if not new["boundary"]:
        del new["boundary"]
    return new


OF_HEAT = {"heat_capacity", "conductivity", "principal_conductivities", "conductivity_angle"}


def in_fixed_steps(case, scene, parts=0.4):
    """The scene with a step that conduction bears, and waves that are as slow as it is made below."""
    scene["time"] = {"end": scene["time"]["end"], "steps": scene["time"]["steps"],
                     "step": parts / max(case.conduction_rate, case.wave / min(case.cell))}
    return scene


def heat_alone_is_heat_in_a_body_at_rest(case):
    """The scene without mechanics has the temperatures of the one in which bodies are at rest."""
    if case.heat is None or case.plain.status != 0:
        return False
    one = in_fixed_steps(case, alone(case.brief))
    other = copy.deepcopy(one)
    other["method"] = dict(one.get("method", {}), stress_update="musl")
    slowest = min(material["density"] for material in other["materials"]) * case.wave ** 2
    for material in other["materials"]:
        material |= {"law": "neo_hookean", "bulk": 0.1 * slowest, "shear": 0.1 * slowest}
    without, beside = ended(case, one, "without mechanics"), ended(case, other, "at rest")
    size = compare.largest(without.end.temperature) + compare.largest(without.start.temperature)
    close(without.end.temperature, beside.end.temperature, size,
          "without mechanics and in bodies at rest")
    return True


def an_even_source_warms_evenly(case):
    """Insulated bodies at rest with one temperature and one capacity per volume: a source warms each of
    their particles at the rate s / (rho c)."""
    if case.heat is None or case.plain.status != 0:
        return False
    scene = in_fixed_steps(case, alone(with_temperatures(case.brief, lambda _: LEVEL)))
    first = scene["materials"][0]
    capacity = first["density"] * first["heat_capacity"]
    for material in scene["materials"]:
        material["heat_capacity"] = capacity / material["density"]
    step = 0.4 / (case.conduction_rate * max(1, capacity_ratio(case)) + case.wave / min(case.cell))
    scene["time"]["step"] = step
    heat = scene["transport"]["temperature"]
    heat.pop("fluxes", None), heat.pop("conditions", None)
    heat["source"] = capacity * LEVEL / (step * scene["time"]["steps"])
    end = ended(case, scene, "with an even source").end
    close(end.temperature, 2 * LEVEL, LEVEL, "with an even source")
    return True


def capacity_ratio(case):
    """The first capacity per volume, or the largest, over the smallest."""
    capacities = [material["density"] * material["heat_capacity"] for material in case.scene["materials"]]
    return max(capacities) / min(capacities)


def a_held_gradient_stays(case):
    """All nodes held at one gradient, along z in axisymmetry and along planes of symmetry: bodies at rest
    have it already, whatever they conduct."""
    if case.heat is None or case.plain.status != 0:
        return False
    names, grid = names_of(case.scene), case.scene["grid"]
    slopes = [0 if case.axisymmetric else 0.3, -0.2]
    for boundary in case.scene.get("boundary", []):
        if "symmetry" in boundary:
            ends = boundary["region"]["line"]
            slopes[int(ends["from"][0] != ends["to"][0])] = 0
    field = f"{LEVEL}" + "".join(f"+({slope})*({name}-({first}))" for slope, name, first in
                                 zip(slopes, names, grid.get("origin", [0, 0])))
    scene = in_fixed_steps(case, alone(with_temperatures(case.brief, lambda _: field)))
    heat = scene["transport"]["temperature"]
    heat.pop("fluxes", None), heat.pop("source", None)
    heat["conditions"] = [{"region": {"all": True}, "value": field}]
    run = ended(case, scene, "with a held gradient")
    size = compare.largest(run.start.temperature)
    close(run.end.temperature, run.start.temperature, size, "with a held gradient")
    return True


# ------------------------------------------------------------ what must not matter
def heat_moves_nothing(case):
    """The motion is the same to the last bit without heat."""
    if case.heat is None or case.at_rest or case.plain.status != 0:
        return False
    speed = case.wave + compare.largest(case.base.start.velocity)
    with_it, without = case.brief, case.brief
    step = 0.2 * min(min(case.cell) / speed, 1 / max(case.conduction_rate, 1e-9))
    for scene in (with_it, without):
        scene["time"] = {"end": scene["time"]["end"], "steps": scene["time"]["steps"], "step": step}
    del without["transport"]
    for body in without["bodies"]:
        body.pop("temperature", None)
    for material in without["materials"]:
        for name in OF_HEAT:
            material.pop(name, None)
    one = case.runner.run(with_it)
    if one.status != 0:
        return False
    same_motion(one, ended(case, without, "without heat"), "without heat")
    return True


def tensors_in_other_words(case):
    """A number k is the tensor of k and k; the other axis at 90 degrees more is the same tensor."""
    if case.heat is None or case.plain.status != 0:
        return False
    scene = case.brief
    for material in scene["materials"]:
        if "conductivity" in material:
            material["principal_conductivities"] = 2 * [material.pop("conductivity")]
            material["conductivity_angle"] = 17
        else:
            material["principal_conductivities"].reverse()
            angle = material.get("conductivity_angle", 0)
            material["conductivity_angle"] = angle - math.copysign(90, angle)
    other = ended(case, scene, "with tensors in other words")
    same_motion(case.plain, other, "with tensors in other words")
    size = compare.largest(case.plain.end.temperature) + compare.largest(case.plain.start.temperature)
    close(other.end.temperature, case.plain.end.temperature, size, "with tensors in other words")
    return True
