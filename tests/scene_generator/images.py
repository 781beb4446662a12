"""Invariants: the same scene, seen another way, has the same answer. Functions as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math

import numpy

import compare
import transform
from case import require, without_contact
from transform import Motion

PER_THREAD = 4096  # particles of deformable bodies that a further thread is used for, threads.c
PARTICLES = 2.2 * PER_THREAD  # more than three threads' at bodies with round edges as well
STEPS_OF_LARGE = 4
OF_ROOTS = 1e-9  # an exchange of heat has square roots of capacities: no power of two passes those


# ------------------------------------------------- the same scene, seen another way
def same_answer(case, scene, motion=Motion(), options=(), what="the other run"):
    """The answer to the brief scene, moved, is that to the other scene, to round-off."""
    one = case.plain
    if one.status != 0:
        return False
    other = case.runner.run(scene, *options)
    require(other.status == 0, f"{what}: exit {other.status}: {other.message}")
    if without_contact(other):
        return False
    order = transform.matched(one.start, other.start, motion)
    require(order is not None, f"{what}: other particles at t = 0")
    return agrees(case, other, order, motion, what)


def agrees(case, other, order, motion, what):
    """The result `other`, its particles in the order given, is that of the brief scene, moved."""
    one = case.plain
    off = compare.difference(one, other, order, motion, case.cell, case.wave)
    if off.size <= compare.ROUND_OFF:
        return True
    response = case.once("response", lambda: shaken_response(case))
    if response is None:
        return False  # the scene is about to fail: nothing is known about round-off
    if case.touching and response >= 0.1 * off.size:
        return False  # a decision of contact hangs by a thread
    overlap = case.once("overlap", lambda: case.least_overlap)
    allowed = compare.allowed(response, overlap)
    require(off.size <= allowed, f"{what} differs: {off}; allowed: {allowed:.2g} (a shake of 1e-9 "
            f"moves the answer by {response:.2g}; the least overlap is {overlap:.2g} of a cell)")
    return True


def shaken_response(case):
    """How far the answer moves when the scene is shaken; None where it fails then."""
    one, other = case.plain, case.runner.run(compare.shaken(case.brief))
    if other.status != 0 or len(other.start.id) != len(one.start.id):
        return None
    order = numpy.arange(len(one.start.id))
    return compare.difference(one, other, order, Motion(), case.cell, case.wave).size


def moved_by_whole_cells(case):
    """A scene that lies elsewhere has the same answer there; in axisymmetry along z."""
    grid = case.scene["grid"]
    shift = [0 if case.axisymmetric else 3 * grid["cell"][0], -5 * grid["cell"][1]]
    motion = Motion(shift=shift)
    return same_answer(case, transform.moved(case.schema, case.brief, motion), motion,
                       what="the scene moved by whole cells")


def mirrored_along_x(case):
    """The mirror image of a planar scene has the mirror image of its answer."""
    if case.axisymmetric or case.crowded:
        return False
    motion = Motion(matrix=[[-1, 0], [0, 1]])
    return same_answer(case, transform.moved(case.schema, case.brief, motion), motion,
                       what="the mirror image in x")


def mirrored_along_y(case):
    """The same along y or z."""
    if case.crowded:
        return False
    motion = Motion(matrix=[[1, 0], [0, -1]])
    return same_answer(case, transform.moved(case.schema, case.brief, motion), motion,
                       what="the mirror image in y or z")


def turned_by_a_right_angle(case):
    """A planar scene turned by 90 degrees has the turned answer."""
    if case.axisymmetric or case.crowded:
        return False
    motion = Motion(matrix=[[0, -1], [1, 0]])
    return same_answer(case, transform.moved(case.schema, case.brief, motion), motion,
                       what="the scene turned by 90 degrees")


def bodies_in_another_order(case):
    """The order of bodies in the scene does not matter."""
    if len(case.scene["bodies"]) < 2:
        return False
    return same_answer(case, transform.with_bodies_reversed(case.schema, case.brief),
                       what="the scene with its bodies in the other order")


def fields_in_another_order(case):
    """Neither does that of velocity fields: of materials, or bodies, and of the pairs and both of each."""
    if "contact" not in case.scene:
        return False
    return same_answer(case, transform.with_fields_reversed(case.schema, case.brief),
                       what="the scene with its velocity fields in the other order")


def cracks_in_another_order(case):
    """Neither does that of cracks, nor the direction in which their points are given."""
    if not case.cracks or case.crowded or any("propagation" in integral for crack in case.cracks
                              for integral in crack.get("j_integral", [])):
        return False
    return same_answer(case, transform.with_cracks_reversed(case.schema, case.brief),
                       what="the scene with its cracks in the other order and direction")


def fast_kernels_are_the_reference(case):
    """Both sets of kernels give the same answer to round-off."""
    if case.plain.status != 0 or case.plain.kernels != "fast":
        return False
    return same_answer(case, case.brief, options=("--kernels", "reference"),
                       what="the run with reference kernels")


# ----------------------------------------------------------------------- same bits
def same_bits(one, other, scales, what, slack=0.0):
    """Fields of the last states, those of the other one over their scales, are the same bits, or differ by
    that part of the largest."""
    require(other.status == one.status, f"{what}: exit {other.status}: {other.message}")
    for name, scale in scales.items():
        if name not in one.end.fields:
            continue  # of scenes with heat, or of those with motion
        mine, theirs = one.end.fields[name], other.end.fields[name] / scale
        size = compare.largest(mine) or 1.0
        require(mine.shape == theirs.shape and compare.largest(mine - theirs) <= slack * size,
                f"{what}: {name} differs by {compare.largest(mine - theirs) / size:.2g} of the largest"
                if mine.shape == theirs.shape else f"{what}: other particles")
    require(one.end.step == other.end.step, f"{what}: {other.end.step} steps, not {one.end.step}")


def other_units_change_no_digit(case):
    """Units of which one is so many powers of two of the other: the same bits, scaled."""
    if case.plain.status != 0:
        return False
    length, mass, time, temperature = 2.0 ** -3, 2.0 ** 5, 2.0 ** 4, 2.0 ** -6
    other = case.runner.run(transform.in_units(case.schema, case.brief, length, mass, time,
                                               temperature))
    same_bits(case.plain, other, {"position": length, "velocity": length / time,
                                  "deformation_gradient": 1.0, "mass": mass,
                                  "stress": mass / (length * time ** 2),
                                  "temperature": temperature, "concentration": 1.0}, "in other units",
              OF_ROOTS * case.exchanges)
    return True


def thickness_scales_sums_alone(case):
    """Twice the thickness: the same motion to the last bit. A thermostat knows energies, a sum."""
    if case.plain.status != 0 or case.axisymmetric or "thermostat" in case.scene.get("damping", {}):
        return False
    scene = case.brief
    scene["thickness"] = 2 * scene.get("thickness", 1)
    same_bits(case.plain, case.runner.run(scene),
              {"position": 1, "velocity": 1, "deformation_gradient": 1, "stress": 1, "mass": 2,
               "temperature": 1, "concentration": 1}, "twice as thick", OF_ROOTS * case.exchanges)
    return True


def refinement_is_a_finer_grid(case):
    """A grid of larger cells that are divided is the grid of smaller ones."""
    grid = case.scene["grid"]
    if case.plain.status != 0 or any(count % 2 for count in grid["cells"]):
        return False
    scene = case.brief
    scene["grid"] = dict(grid, cell=[2 * side for side in grid["cell"]],
                         cells=[count // 2 for count in grid["cells"]],
                         refine=2 * grid.get("refine", 1))
    same_bits(case.plain, case.runner.run(scene),
              {"position": 1, "velocity": 1, "deformation_gradient": 1, "temperature": 1,
               "concentration": 1}, "as a refined grid")
    return True


def deformable(case, result):
    """The number of particles of deformable bodies at the start of a run."""
    return int(result.start.of_bodies(case.deformable).sum())


def large(case):
    """The brief scene on a grid so much finer that it has work for three threads, a few steps of it."""
    scene = case.brief
    grid = scene["grid"]
    finer = math.ceil(math.sqrt(PARTICLES / max(1, deformable(case, case.plain))))
    grid["refine"] = finer * grid.get("refine", 1)
    scene["time"]["steps"] = min(STEPS_OF_LARGE, scene["time"].get("steps", STEPS_OF_LARGE))
    return scene


def threads_and_instructions_change_no_bit(case):
    """The scene on a finer grid, with 1 and 3 threads, which do have work, and with 2 and the
    least instructions: the same files. Not judged: scenes that are none on a finer grid."""
    if case.plain.status != 0:
        return False
    scene = large(case)
    first = case.runner.run(scene, keep_bytes=True)
    if first.status != 0 or deformable(case, first) <= 2 * PER_THREAD:
        return False
    for options in (("--threads", "3"), ("--threads", "2", "--simd", "baseline")):
        if first.kernels != "fast":
            options = options[:2]
        what = " ".join(options)
        other = case.runner.run(scene, *options, keep_bytes=True)
        require(other.status == 0, f"{what}: exit {other.status}: {other.message}")
        require(other.threads > 1, f"{what}: one thread alone")
        for name, content in first.files.items():
            require(other.files.get(name) == content, f"{what}: {name} differs")
    return True
