"""Invariants: conditions at the nodes, rest, the time step. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import math

import numpy

import compare
import transform
from case import Violation, evaluate, require
from scalars import scalars_of, still, with_values, without_input
from scales import SCALARS, wave_speed
from transform import Motion


# ----------------------------------------------------------------------- conditions
LAST_DIGITS = 1e-14


def nodes_of(region, positions, cell):
    """Which nodes a boundary takes."""
    if "all" in region:
        return numpy.ones(len(positions), dtype=bool)
    ends = region.get("line") or region["rectangle"]
    corners = numpy.array([ends["from"], ends["to"]], dtype=float)
    slack = 1e-6 * numpy.array(cell)
    return ((positions >= corners.min(axis=0) - slack) &
            (positions <= corners.max(axis=0) + slack)).all(axis=1)


def lies_on(case, plane, axis):
    """Are all points of a crack on the plane x_axis = plane?"""
    return any(all(abs(point[axis] - plane) <= 1e-6 * min(case.cell) for point in crack["points"])
               for crack in case.cracks)


def prescribed(case):
    """Conditions of the scene: region, component, expression. A plane of symmetry that a crack lies on
    gives none: surfaces of that crack are free there."""
    found = []
    if case.axisymmetric and case.method["axis"] == "truncated":
        found.append(({"line": {"from": [0, -math.inf], "to": [0, math.inf]}}, 0, 0))
    for boundary in case.scene.get("boundary", []):
        drives = boundary.get("velocity")
        if drives is None:
            ends = boundary["region"]["line"]
            normal = int(ends["from"][0] != ends["to"][0])
            if not lies_on(case, ends["from"][normal], normal):
                drives = [0 if k == normal else "free" for k in range(2)]
        found += [(boundary["region"], k, drive) for k, drive in enumerate(drives or [])
                  if drive != "free"]
    return found


def inside_planes(case, places):
    """Which places are on the bodies' side of all planes of symmetry, or on them: others are images."""
    inside = numpy.ones(len(places), dtype=bool)
    middle = case.plain.start.position.mean(axis=0)
    for boundary in case.scene.get("boundary", []):
        line = boundary["region"].get("line")
        if not boundary.get("symmetry") or line is None:
            continue
        axis = 0 if line["from"][0] == line["to"][0] else 1
        plane = line["from"][axis]
        inside &= (places[:, axis] - plane) * (middle[axis] - plane) >= -1e-9
    return inside


def conditions_hold_at_every_node(case):
    """In every step nodes with mass, in each of their velocity fields, move particles with the velocity that
    a boundary gives them, at the end of the step or, with midpoint, in the mean; none goes across a plane of
    symmetry that no crack lies on, whose additional fields would be free there (symmetry.h); v_r = 0
    at r = 0 with functions that are cut off there. Nodes beyond a plane follow those they are images
    of. Some units of the last digit of velocities and of
    accelerations times the step are left."""
    conditions = prescribed(case)
    if not conditions or case.plain.status != 0:
        return False
    status, message, rows = case.runner.nodes(case.brief)
    require(status == 0, f"mpm-nodes: exit {status}: {message}")
    names = transform.names_of(case.scene)
    midpoint = case.scene.get("method", {}).get("position_update") == "midpoint"
    judged = False
    for region, component, drive in conditions:
        for row in rows[nodes_of(region, rows[:, 3:5], case.cell) &
                        inside_planes(case, rows[:, 3:5])]:
            if case.axisymmetric and component == 0 and row[3] < 0:
                continue  # v_r at r < 0 is what method.axis_nodes states
            place = {names[0]: row[3], names[1]: row[4]}
            wanted = evaluate(drive, t=row[1], **place)
            if midpoint:
                wanted = 0.5 * (wanted + evaluate(drive, t=row[1] - row[2], **place))
            judged = True
            require(abs(row[5 + component] - wanted) <= LAST_DIGITS * (abs(wanted) + case.wave),
                    f"step {row[0]:.0f}: node ({row[3]:g}, {row[4]:g}) moves with v_{names[component]} = "
                    f"{row[5 + component]:.6g}, not {wanted:.6g}")
    return judged


def has_adhesion(case):
    """Has contact adhesion, which closes gaps, those of round-off too?"""
    contact = case.scene.get("contact", {})
    return any(entry.get("adhesion", 0) > 0 for entry in [contact, *contact.get("pairs", [])])


def an_unloaded_body_stays_at_rest(case):
    """Without motion and loads nothing happens, to the last bit. Where stresses follow scalars, these
    are all 0, in materials that are free of stress then, and gases without pressure, as all fluids are
    then. Not judged: adhesion, which holds surfaces together that are apart by round-off."""
    if has_adhesion(case):
        return False
    if case.plain.status != 0:
        return False
    scene = still(case.brief)
    for material in scene["materials"]:
        if "start_pressure" in material:
            material["start_pressure"] = 0
    if case.couples:
        scene = without_input(with_values(scene, lambda _: 0))
    result = case.runner.run(scene)
    require(result.status in (0, 2), f"at rest: exit {result.status}: {result.message}")
    if result.status == 2:
        return False
    start, end = result.start, result.end
    require((end.velocity == 0).all(),
            f"velocity {compare.largest(end.velocity):.3g} of a body at rest")
    require((end.position == start.position).all(), "particles of a body at rest have moved")
    require((end.deformation_gradient == start.deformation_gradient).all(),
            "F of a body at rest has changed")
    return True


# ------------------------------------------------------------------------ time step
def smooth_contact(contact, softest, slowest):
    """Contact with laws that are smooth in the step: interfaces alike in all directions, whose vibrations
    the step resolves, where there are no others, and else all bonded. (Bodies that are bonded to a
    third one, and not to each other, are one where that has any mass: not smooth.) Heat passes with a
    conductance, which the step resolves too."""
    entries = [contact, *contact.get("pairs", [])]
    alike = {entry.get("law", "none") for entry in entries} <= {"none", "interface"}
    made = []
    for entry in entries:
        made.append({name: entry[name] for name in ("fields", "law", "of") if name in entry})
        if entry.get("law", "none") == "none":
            continue
        made[-1]["law"] = "interface" if alike else "bonded"
        if alike:
            stiffness = min(entry["tension"], softest)
            made[-1] |= {"tension": stiffness, "shear": stiffness, "normal": "average"}
        if "heat" in entry:
            made[-1] |= {"heat": "conductance",
                         "conductance": min(entry.get("conductance", slowest), slowest)}
    return made[0] | ({"pairs": made[1:]} if len(made) > 1 else {})


def smooth(scene):
    """The scene without what is not smooth in the time step: cracks, which a line from a particle to a
    node crosses or not, contact that opens and closes, and mixtures of velocities, which take out
    energy in each step, or of temperatures, among them held ones beside heat of deformation, which
    particles take in each step (docs/heat.md)."""
    new = copy.deepcopy(scene)
    new.pop("cracks", None)
    if "contact" in new:
        softest = 0.1 * min(material["density"] * wave_speed(material) ** 2
                            for material in new["materials"]) / max(new["grid"]["cell"])
        heat = SCALARS["temperature"]
        slowest = 0.1 * min((heat.capacity_per_volume(material) if heat.has_capacity(material)
                             else material["density"]) * wave_speed(material)
                            for material in new["materials"])
        new["contact"] = smooth_contact(new["contact"], softest, slowest)
    for name in ("cracks", "transfer", "form"):
        new["method"].pop(name, None)
    new.get("damping", {}).pop("pic", None)
    for name in ("substeps", "every"):
        new.get("transport", {}).pop(name, None)
    for given in scalars_of(new).values():
        given.pop("transfer", None), given.pop("order", None)
        if given.get("heating"):
            given.pop("conditions", None)
    return new


OF_STATE = ("position", "velocity", "F", "temperature", "concentration")


def half_the_step_halves_the_error(case):
    """Fixed steps dt, dt/2, dt/4 to one time: the second change of the answer is three quarters of the
    first or less, where half would be all but for terms of other orders, or it is below 1e-7. Where two
    terms cancel in the first change, the third one, with dt/8, is held against the second. What is
    added once a step instead of once a time changes as much again, or more; a term that is wrong by
    less than the rest of the change is not seen. Without classic functions, which feel every cell
    border, and without what is not smooth in the step (see smooth)."""
    if case.plain.status != 0 or case.method["shape"] == "classic":
        return False
    speed = case.wave + compare.largest(case.base.start.velocity)
    changes, answer = [], None
    for parts in (1, 2, 4, 8):
        scene = smooth(case.brief)
        scene["time"] = {"end": scene["time"]["end"], "steps": 4 * parts,
                         "step": 0.1 / max(speed / min(case.cell), case.conduction_rate) / parts}
        next_answer = case.runner.run(scene)
        require(next_answer.status == 0,
                f"with steps of {scene['time']['step']:.3g}: {next_answer.message}")
        if answer is not None:
            order = numpy.arange(len(answer.start.id))
            changes.append(compare.difference(answer, next_answer, order, Motion(), case.cell,
                                              case.wave).parts)
        answer = next_answer
        if len(changes) > 1 and all(changes[-1][name] <= max(0.75 * changes[-2][name], 1e-7)
                                    for name in OF_STATE if name in changes[-1]):
            return True
    raise Violation("changes of the answer as the step is halved again and again: " + "; ".join(
        f"{name} " + ", ".join(f"{change[name]:.3g}" for change in changes)
        for name in OF_STATE if name in changes[-1]))
