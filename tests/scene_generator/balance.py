"""Invariants: how runs end, energy, momentum, work. Each is a function of a case: it returns False where
the case is none for it, True where it holds, and raises Violation where it does not.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import itertools
import math
import re

import numpy

import compare
from case import Discarded, evaluate, require
from scalars import scalars_of
from transform import names_of

LOSSES = ("transfer_loss", "contact_loss")


# -------------------------------------------------------------------- how runs end
def runs_end_as_promised(case):
    """Exit 0 or 3, never a signal; what `mpm check` accepts is not refused by `mpm run`; a failed
    run leaves its last good state, which is finite."""
    base = case.base
    if base.status == 2:
        status, message = case.runner.check(case.scene)
        require(status == 2, f"mpm run: exit 2 after mpm check: exit {status}: {base.message}")
        raise Discarded(message)
    require(base.status in (0, 3), f"exit {base.status}: {base.message}")
    require(base.states, f"exit {base.status}, and nothing is written")
    for state in base.states:
        for name, values in state.fields.items():
            require(numpy.isfinite(values).all(),
                    f"{name} of step {state.step} is not finite, exit {base.status}")
    for name, values in base.history.items():
        if base.status == 3 and "_contour_" in name:
            values = values[:-1]  # a J integral may have no value there: that is why the run failed
        ended = base.history["step"][:len(values)] >= end_of_tip(base, name)
        require(numpy.isfinite(values[~ended]).all() and numpy.isnan(values[ended]).all(),
                f"history: {name} is not finite, or has values of a tip that has ended, exit "
                f"{base.status}")
    return True


def failing(case, after):
    """The brief scene with a source, or a body force where nothing conducts, that is no number after that
    time; None where every force would act across a plane of symmetry."""
    scene = case.brief
    no_number = f"0*sqrt({after!r}-t)"
    if case.conducts:
        given = next(iter(scalars_of(scene).values()))
        given["source"] = f"({given.get('source', 0)})+{no_number}"
        return scene
    planes = [boundary["region"]["line"] for boundary in case.scene.get("boundary", [])
              if boundary.get("symmetry")]
    free = [k for k in (1, 0) if not any(line["from"][k] == line["to"][k] for line in planes)]
    if not free:
        return None
    force = scene.setdefault("loads", {}).setdefault("body_force", [0, 0])
    force[free[0]] = f"({force[free[0]]})+{no_number}"
    return scene


def a_failed_run_leaves_the_step_before(case):
    """A body force, or a source, that is not a number from half of the run on ends it. What it leaves is
    what the run to that step gives, state and history, though its last steps are taken again from the
    last sort. Not judged: transport that waits, which takes place at the end of that run."""
    if case.plain.status != 0 or case.plain.end.step < 3 or case.waits:
        return False
    times = case.plain.history["time"]
    row = len(times) // 2
    scene = failing(case, float(0.5 * (times[row] + times[row + 1])))
    if scene is None:
        return False
    failed = case.runner.run(scene)
    require(failed.status == 3, f"with a load that is not a number: exit {failed.status}: "
            f"{failed.message}")
    scene["time"]["steps"] = failed.end.step
    good = case.runner.run(scene)
    require(good.status == 0, f"the same up to step {failed.end.step}: exit {good.status}: {good.message}")
    for name, values in good.end.fields.items():
        require(numpy.array_equal(values, failed.end.fields[name]),
                f"{name} after step {failed.end.step} differs where the run fails in the next one")
    for name, values in good.history.items():
        require(numpy.array_equal(values, failed.history[name], equal_nan=True),
                f"history: {name} differs where the run fails after step {failed.end.step}")
    return True


def end_of_tip(base, name):
    """Of a column of the history: the step from which it has no value, infinite for most."""
    column = re.fullmatch(r"crack_(\d+)_contour_(\d+)_[jk][12]", name)
    if column is None:
        return math.inf
    key = f"cracks.{column[1]}.j_integral.{column[2]}"
    return min((tip["step"] for tip in base.ended if tip["integral"] == key), default=math.inf)


BLOW_UP = 10.0  # times all energy put in: the solver's own limit


def driven_speed(case):
    """The largest component of the prescribed velocities up to each row of the history: of formulas at
    corners, edges and the middle of the grid, at some fifty times."""
    fields = [boundary.get("velocity", []) for boundary in case.scene.get("boundary", [])]
    fields += [body["rigid"].get("velocity", []) for body in case.scene["bodies"] if "rigid" in body]
    given = [value for field in fields for value in field if value != "free"]
    grid, names, times = case.scene["grid"], names_of(case.scene), case.base.history["time"]
    places = [[first + part * side * count for part in (0, 0.5, 1)] for first, side, count in
              zip(grid.get("origin", [0, 0]), grid["cell"], grid["cells"])]
    rows = numpy.unique(numpy.linspace(0, len(times) - 1, 50).astype(int))
    fastest = [max((abs(evaluate(value, t=times[row], **dict(zip(names, place))))
                    for value in given for place in itertools.product(*places)), default=0.0)
               for row in rows]
    return numpy.maximum.accumulate(fastest)[numpy.searchsorted(rows, range(len(times)))]


def no_blow_up_passes_for_a_result(case):
    """Exit 0: what the run holds and has dissipated has never passed ten times the energy put in;
    contact that has given more than it has taken, of all pairs together, holds none of it. Put in is
    energy at t = 0, by work, of expansion too, and by conditions that move nodes from the start, which
    strain a body before they work on it (of its mass at their speed, at most). Below 1e-10 of m c^2 it
    is round-off."""
    base = case.base
    if base.status != 0:
        return True  # it does not pass for a result
    history = base.history
    put_in = abs(history["total_energy"][0]) + history["mass"][0] * driven_speed(case) ** 2 + \
        numpy.abs(numpy.diff(history["external_work"], prepend=0.0)).cumsum()
    if "expansion_work" in history:  # of which the step leaves an error of first order
        put_in = put_in + numpy.abs(numpy.diff(history["expansion_work"], prepend=0.0)).cumsum()
    noise = 1e-10 * history["mass"][0] * case.wave ** 2
    contact = sum((values + history.get(name.replace("dissipated", "stored"), 0.0)
                   for name, values in history.items()
                   if re.fullmatch(r"contact_\d+_\d+_dissipated", name)), 0.0)
    held = history["total_energy"] + numpy.maximum(-contact, 0.0)
    ratio = held / (put_in + noise)
    row = int(ratio.argmax())
    require(ratio[row] <= BLOW_UP, f"exit 0, total energy {held[row]:.6g} at step "
            f"{history['step'][row]:.0f}: {ratio[row]:.3g} times all that was put in")
    return True


def losses(history):
    """What transfers and contact have lost, where the ledger knows it."""
    return sum((history[name] for name in LOSSES if name in history),
               numpy.zeros_like(history["time"]))


def the_ledger_closes_in_every_step(case):
    """d(total energy) + d(losses) + d(heat of plastic work) = d(external work). Round-off: of the energies that are
    summed, and of a strain energy, which comes from terms of the size of the modulus."""
    base = case.base
    if base.status != 0 or case.hides_losses:
        return False
    history = base.history
    held = history["total_energy"] + losses(history) + history.get("plastic_heat", 0.0)
    gap = numpy.abs(numpy.diff(held) - numpy.diff(history["external_work"]))
    size = numpy.maximum.accumulate(sum(numpy.abs(history[name])
                                        for name in compare.NUMBERS if name in history))[1:]
    allowed = 1e-12 * size + 1e-14 * history["mass"][0] * case.wave ** 2
    if not len(gap):
        return False
    row = int((gap / allowed).argmax())
    require(gap[row] <= allowed[row], f"step {history['step'][row + 1]:.0f}: energy and work differ by "
            f"{gap[row]:.3g} of {size[row]:.3g}")
    return True


# ------------------------------------------------------------------ forces, motion
def face_length(case, state, body, edge):
    """Length of a face of a rectangle that is filled with whole cells, or None."""
    region = next(entry for entry in case.scene["bodies"] if entry["name"] == body)
    box = region["region"].get("rectangle")
    if box is None or edge == "all":
        return None
    axis = 0 if edge in ("top", "bottom") else 1
    positions = numpy.unique(state.position[state.of_bodies([body])][:, axis].round(9))
    return len(positions) * case.cell[axis] / region.get("particles_per_cell", [2, 2])[axis]


def force_of_time(case, time):
    """The sum of all external forces at a time, or None where it depends on more than that."""
    start, thickness = case.base.start, case.scene.get("thickness", 1)
    mass = case.base.history["mass"][0]
    total = numpy.zeros(2)
    try:
        for axis, text in enumerate(case.loads.get("body_force", [0, 0])):
            total[axis] += mass * evaluate(text, t=time)
        faces = [(load, "ugimp") for load in case.loads.get("tractions", [])] + \
                [(load, None) for load in case.loads.get("particle_forces", [])]
        for load, shape in faces:
            length = face_length(case, start, load["body"], load["edge"])
            if length is None or load.get("frame", "global") == "edge" or case.axisymmetric or \
                    case.scene["geometry"] == "plane_stress" or \
                    shape not in (None, case.method["shape"]):
                return None
            total += [length * thickness * evaluate(text, t=time) for text in load["value"]]
    except NameError:  # a coordinate
        return None
    return total


def momentum_changes_by_external_forces(case):
    """Of bodies that nothing holds, in each step: d(momentum) = sum of the forces times the step. In
    axisymmetry along z. The momentum form does not keep it, nor do particles that see a part of their
    nodes only (visibility), and damping takes it. Round-off: internal forces of size m c^2 |F - 1|/h sum
    up to zero."""
    base = case.base
    damping = set(case.scene.get("damping", {})) - {"pic"}
    if base.status != 0 or case.rigid or case.scene.get("boundary") or damping or \
            case.method["form"] != "velocity" or case.method["cracks"] == "visibility":
        return False
    history = base.history
    if force_of_time(case, 0.0) is None:
        return False
    steps = numpy.diff(history["time"])
    forces = numpy.array([force_of_time(case, time) for time in history["time"][:-1]])
    worst = 0.0
    strain = compare.largest(base.end.deformation_gradient - [1, 0, 0, 1, 1])
    if case.couples:  # stresses of the first step are not from strains alone
        density = min(material["density"] for material in case.scene["materials"])
        strain += compare.largest(base.start.stress) / (density * case.wave ** 2)
    speed = math.sqrt(2 * history["kinetic_energy"].max() / history["mass"][0])
    allowed = 1e-13 * history["mass"][0] * (speed + case.wave * (strain + compare.FAINT))
    for axis in range(1 if case.axisymmetric else 0, 2):
        change = numpy.diff(history[f"momentum_{'xy'[axis]}"]) - forces[:, axis] * steps
        worst = max(worst, compare.largest(change))
    require(worst <= allowed, f"momentum changes by {worst:.3g} without a force; allowed: {allowed:.3g}")
    return True


def work_needs_motion(case):
    """Loads on faces that have become constant, on a body that is nearly at rest: what they do in the second
    half of the run, less what transfers lose, is at most the sum of the forces' sizes times the way
    that the fastest particle can have gone, which the kinetic energy bounds. Three times that, since
    an edge may be faster than its particle, and a hundredth of the energy held."""
    base, loads = case.base, case.loads.get("tractions", [])
    if base.status != 0 or case.hides_losses or case.rigid or not loads or \
            case.scene.get("boundary") or set(case.loads) != {"tractions"} or \
            not re.search(r"min\(t\*", str(loads)):
        return False
    history = base.history
    half = len(history["time"]) // 2
    held = history["strain_energy"][-1]
    kinetic = history["kinetic_energy"][half:]
    if kinetic.max() > 1e-4 * held:
        return False
    size = 0.0
    for load in loads:
        length = face_length(case, base.start, load["body"], load["edge"])
        if length is None:
            return False
        if case.axisymmetric:
            length = length ** 2 / 2 if load["edge"] in ("top", "bottom") else \
                length * base.start.position[:, 0].max()
        area = length * (1 if case.axisymmetric else case.scene.get("thickness", 1))
        size += area * sum(abs(evaluate(text, t=history["time"][-1])) for text in load["value"])
    lightest = base.start.mass.min()
    way = (numpy.sqrt(2 * kinetic[1:] / lightest) * numpy.diff(history["time"][half:])).sum()
    work = numpy.diff((history["external_work"] - losses(history))[[half, -1]])[0]
    allowed = 3 * size * way + 0.01 * held
    require(abs(work) <= allowed, f"constant loads do the work {work:.3g} on a body whose particles "
            f"move by less than {way:.2g}; allowed: {allowed:.3g}, strain energy {held:.3g}")
    return True
