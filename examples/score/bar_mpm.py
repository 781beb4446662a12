#!/usr/bin/env python3
# A material point method in one dimension: points, hat functions on a grid, MUSL, FLIP.
#
#   bar_mpm.py BUNDLE RESULTS.csv [--cells N]     cases E3 (vibrating bar) and T4 (column at rest)
#
# It reads a bundle of `mpm-verify export` and writes results for `mpm-verify score`. It is right where
# points stay in their cells (E3), and shows what hat functions do where they leave them (T4): the
# gradient of a hat jumps at a node, and with it the force of a point that crosses.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import csv
import json
import math
import os

POINTS = 2  # in each cell


def modulus(material):
    """M = K + 4/3 G of uniaxial strain; Young's modulus and Poisson's ratio do as well."""
    if "bulk" in material:
        return material["bulk"] + 4 / 3 * material["shear"]
    e, nu = material["young"], material["poisson"]
    return e * (1 - nu) / ((1 + nu) * (1 - 2 * nu))


class Bar:
    """Points of a bar along one axis, of unit cross-section, on a grid that reaches beyond its end."""

    def __init__(self, length, cells, density, stiffness, velocity):
        self.h, self.stiffness, self.density = length / cells, stiffness, density
        self.nodes = cells + 3
        self.start = [(i + 0.5) * self.h / POINTS for i in range(POINTS * cells)]
        self.x = list(self.start)
        self.v = [velocity(x) for x in self.start]
        self.stretch = [1.0] * len(self.x)
        self.mass = density * self.h / POINTS
        self.step = 0.4 * self.h / math.sqrt(stiffness / density)

    def stress(self, p):
        # W = M/2 (l - 1)^2: the nominal stress is linear, and is Cauchy's as nothing strains sideways
        return self.stiffness * (self.stretch[p] - 1)

    def hat(self, p):
        """First node, weights and gradients of both nodes of a point's cell."""
        cell = int(self.x[p] // self.h)
        part = self.x[p] / self.h - cell
        return cell, (1 - part, part), (-1 / self.h, 1 / self.h)

    def momenta(self):
        mass, momentum = [0.0] * self.nodes, [0.0] * self.nodes
        for p in range(len(self.x)):
            cell, weight, _ = self.hat(p)
            for n in (0, 1):
                mass[cell + n] += weight[n] * self.mass
                momentum[cell + n] += weight[n] * self.mass * self.v[p]
        return mass, momentum

    def velocities(self, mass, momentum, held):
        return [0.0 if n in held or m < 1e-12 * self.mass else q / m
                for n, (m, q) in enumerate(zip(mass, momentum))]

    def advance(self, dt, held, gravity=0.0, damping=0.0):
        mass, momentum = self.momenta()
        force = [m * gravity for m in mass]
        for p in range(len(self.x)):
            cell, _, gradient = self.hat(p)
            # current volume times Cauchy stress: initial length, stretch, stress
            load = self.mass / self.density * self.stretch[p] * self.stress(p)
            for n in (0, 1):
                force[cell + n] -= gradient[n] * load
        old = self.velocities(mass, momentum, held)
        new = self.velocities(
            mass, [q + dt * (f - damping * q) for q, f in zip(momentum, force)], held)
        for p in range(len(self.x)):
            cell, weight, _ = self.hat(p)
            self.v[p] += sum(weight[n] * (new[cell + n] - old[cell + n]) for n in (0, 1))
            # damping also takes what of the points' velocity the grid does not carry
            carried = sum(weight[n] * new[cell + n] for n in (0, 1))
            self.v[p] += min(1.0, damping * dt) * (carried - self.v[p])
        mass, momentum = self.momenta()  # MUSL: strains follow the velocities that points have now
        grid = self.velocities(mass, momentum, held)
        for p in range(len(self.x)):
            cell, _, gradient = self.hat(p)
            self.stretch[p] *= 1 + dt * sum(gradient[n] * grid[cell + n] for n in (0, 1))
        for p in range(len(self.x)):
            cell, weight, _ = self.hat(p)
            self.x[p] += dt * sum(weight[n] * new[cell + n] for n in (0, 1))

    def run(self, span, **conditions):
        steps = max(1, math.ceil(span / self.step))
        for _ in range(steps):
            self.advance(span / steps, **conditions)


def vibrating_bar(bar, problem, cells):
    """E3: both ends held; a row for each point and instant."""
    span = problem["end"] / problem["instants"]
    for k in range(problem["instants"]):
        bar.run(span, held=(0, cells))
        for p in range(len(bar.x)):
            yield ((k + 1) * span, bar.start[p], bar.x[p] - bar.start[p], bar.v[p], bar.stress(p))


def column(bar, problem, cells):
    """T4: the foot held; gravity at once, damped until it rests."""
    bar.run(20.0, held=(0,), gravity=problem["problem"]["loads"]["body_force"][1], damping=5.0)
    for p in range(len(bar.x)):
        yield bar.start[p], bar.x[p] - bar.start[p], bar.stress(p)


CASES = {
    "E3": (0, vibrating_bar, lambda x: 1e-4 * math.pi / 16 * math.sin(math.pi * x / 16), 32,
           ["time [ms]", "initial_x [mm]", "displacement_x [mm]", "velocity_x [mm ms^-1]",
            "stress_xx [g mm^-1 ms^-2]"]),
    "T4": (1, column, lambda y: 0.0, 32,
           ["initial_y [m]", "displacement_y [m]", "stress_yy [kg m^-1 s^-2]"]),
}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bundle")
    parser.add_argument("results")
    parser.add_argument("--cells", type=int)
    given = parser.parse_args()
    with open(os.path.join(given.bundle, "problem.json"), encoding="utf-8") as file:
        problem = json.load(file)
    axis, solve, velocity, cells, names = CASES[problem["case"]]
    cells = given.cells or cells
    material = problem["problem"]["materials"][0]
    extent = problem["problem"]["bodies"][0]["region"]["rectangle"]
    bar = Bar(extent["to"][axis] - extent["from"][axis], cells, material["density"],
              modulus(material), velocity)
    with open(given.results, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        writer.writerows(solve(bar, problem, cells))


if __name__ == "__main__":
    main()
