"""Differences between two answers to what should be one question, and how large they may be.

**Round-off.** Two runs that differ in the order of sums alone differ by about 1e-16 of each number
in each step: positions by the grid's extent over a cell more. In up to `STEPS` steps that comes to
some 1e-13, unless the scene itself makes it grow: a node that a particle just touches has a mass near
zero, and its velocity any relative error. So a difference above `ROUND_OFF` is held against the
answer of the *shaken* scene, in which all is the same but for `SHAKE`, a part of a cell by which the grid
lies elsewhere and of the density: round-off, `UNIT`, is smaller than that by SHAKE/UNIT, and so must
be its effect. `SLACK` is left for the worst direction and the number of steps. A fault that a tie
switches on is much larger than that.

**Overlaps.** A domain that reaches into a cell by d gives the node at its far side the mass d² and the
force d, so that its velocity is 1/d, and its strain rate, with the gradient d, does not become less
with d. Where the strain follows these velocities (USL, USAVG without extrapolation), a body's edge that
passes a node's line by round-off alone is strained as one that passes it by more, and d, which has
few digits or none, is in the result. So UNIT/d is allowed as well. MUSL extrapolates again from the
particles, whose velocities are bounded: there nothing is.

**Switches.** Contact is a decision at each node. Where the shaken scene moves as far as the
difference, the decision hangs by a thread, and nothing follows from it: `judged` is False.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy

import numpy

from scales import SCALARS

ROUND_OFF = 1e-9
STEPS = 20
SHAKE = 1e-9
UNIT = 1e-14
SLACK = 1e2
FAINT = 1e-3  # of the wave speed: velocities below are measured by this
NUMBERS = ("kinetic_energy", "strain_energy", "external_work", "total_energy",
           "damping_dissipation", "plastic_dissipation", "viscous_dissipation", "cohesive_stored", "cohesive_dissipated",
           "plastic_heat", "transfer_loss", "contact_loss", "contact_stored", "contact_dissipated")
COUPLED = ("expansion_work", "deformation_heat", "thermoelastic_energy")


class Difference:
    """The largest difference of two answers and where it is: positions in cells, velocities in
    parts of the largest one, deformation gradients, scalars, energies and sums of scalars as
    fractions of the largest one of each."""

    def __init__(self, parts):
        self.parts = parts
        self.where = max(parts, key=parts.get)
        self.size = parts[self.where]

    def __str__(self):
        return ", ".join(f"{name} {size:.2g}" for name, size in self.parts.items())


def largest(values):
    """The largest of the absolute values; infinite where one is not a number."""
    values = numpy.abs(values)
    return float(numpy.where(numpy.isnan(values), numpy.inf, values).max(initial=0.0))


def difference(one, other, order, motion, cell, wave):
    """Of result `other`, in the order of particles given, from result `one` after the motion."""
    first, second = one.end, other.end
    position = first.position @ motion.matrix.T + motion.shift
    velocity = motion.vector(first.velocity)
    speed = max(largest(first.velocity), FAINT * wave)
    parts = {
        "step": abs(first.step - second.step),
        "position": largest(second.position[order] - position) / min(cell),
        "velocity": largest(second.velocity[order] - velocity) / speed,
        "F": largest(second.deformation_gradient[order] -
                     motion.gradient(first.deformation_gradient)),
    }
    for scalar in SCALARS.values():
        if scalar.name in first.fields:
            parts |= difference_of_scalar(one, other, order, scalar, wave)
    mass = one.history["mass"][0]
    energy = max([largest(one.history[name]) for name in NUMBERS + COUPLED if name in one.history] +
                 [mass * (FAINT * wave) ** 2])
    parts["energies"] = max(abs(one.history[name][-1] - other.history[name][-1]) / energy
                            for name in NUMBERS + COUPLED if name in one.history)
    return Difference(parts)


def difference_of_scalar(one, other, order, scalar, wave):
    """Parts of a difference: of the particles' values and of sums of what they hold and have taken."""
    mine, theirs = one.end.fields[scalar.name], other.end.fields[scalar.name][order]
    level = largest(one.start.fields[scalar.name]) + largest(mine) or 1.0
    columns = [scalar.content, *scalar.flows]
    # Capacities are near wave^2, or 1: sums may cancel.
    content = one.history["mass"][0] * (wave ** 2 if scalar.name == "temperature" else 1)
    size = sum(largest(one.history[name]) for name in columns) + level * content
    return {scalar.name: largest(theirs - mine) / level, scalar.content: max(
        abs(one.history[name][-1] - other.history[name][-1]) / size for name in columns)}


def shaken(scene):
    """The scene with a grid that lies a little elsewhere, and a density that differs a little."""
    new = copy.deepcopy(scene)
    grid = new["grid"]
    origin = list(grid.get("origin", [0, 0]))
    first = 1 if scene["geometry"] == "axisymmetric" else 0  # r = 0 stays a node
    for axis in range(first, 2):
        origin[axis] += SHAKE * grid["cell"][axis] * (0.7 + 0.3 * axis)
    grid["origin"] = origin
    for material in new["materials"]:
        material["density"] *= 1 + SHAKE
    return new


def allowed(response, overlap=1.0):
    """How large a difference by round-off may be where SHAKE moves the answer by `response`, and
    particles overlap the functions of all nodes that they have by `overlap` of a cell or more."""
    return max(ROUND_OFF, SLACK * UNIT / SHAKE * response, SLACK * UNIT / overlap)
