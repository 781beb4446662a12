"""A bar that is held at both ends vibrates in its first axial mode: the library from Python.

    python3 bar.py FOLDER

runs the bar to half a period with an observer, writes the results to FOLDER, reads them again, and
compares them with the exact mode and with what the observer saw.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import sys

import numpy

import touchstone

LENGTH, AMPLITUDE = 16.0, 1e-4


def build():
    """The scene by calls: what is no number or text is a list or a dict."""
    draft = touchstone.Draft("bar")
    draft.set("format", 1)
    draft.set("geometry", "plane_strain")
    draft.set("units", {"length": "mm", "mass": "g", "time": "ms"})
    draft.set("grid", {"cell": [1, 1], "cells": [int(LENGTH), 1]})
    draft.set("time.end", LENGTH)  # half a period of 2 L / c, with c = 1
    draft.set("method", {"shape": "ugimp", "stress_update": "usavg"})
    draft.set("materials.+", {"name": "bar", "law": "linear_elastic", "density": 1})
    draft.set("materials.bar.bulk", 0.6)
    draft.set("materials.bar.shear", 0.3)
    draft.set("bodies.+", {"name": "bar", "material": "bar", "region": {"rectangle": {
        "from": [0, 0], "to": [LENGTH, 1]}}, "velocity": [f"{AMPLITUDE}*sin(pi*x/{LENGTH})", 0]})
    draft.set("boundary", [
        {"region": {"all": True}, "velocity": ["free", 0]},
        {"region": {"line": {"from": [0, 0], "to": [0, 1]}}, "velocity": [0, "free"]},
        {"region": {"line": {"from": [LENGTH, 0], "to": [LENGTH, 1]}}, "velocity": [0, "free"]}])
    draft.set("output", {"history": 1, "snapshots": 4})
    return draft.build()


def amplitude(position, velocity):
    """Of the first mode in the particles' velocities, by least squares."""
    mode = numpy.sin(numpy.pi * position[:, 0] / LENGTH)
    return velocity[:, 0] @ mode / (mode @ mode)


def main(folder):
    seen = {}

    def observe(now):
        seen[now.time] = amplitude(now.field("position"), now.field("velocity"))

    build().run(folder, observers=[touchstone.Observer(observe, interval=4.0)], overwrite=True)

    results = touchstone.Results(folder)
    for index, time in enumerate(results.times):
        read = amplitude(results.field("position", index), results.field("velocity", index))
        exact = AMPLITUDE * numpy.cos(numpy.pi * time / LENGTH)
        print(f"time {time:5.2f}  amplitude {read:12.5e}  exact {exact:12.5e} {results.unit('velocity')}")
        assert read == seen[time], "snapshot and observer differ"
        assert abs(read - exact) < 0.02 * AMPLITUDE, "not the exact mode"
    kinetic = results.history["kinetic_energy"]
    print(f"kinetic energy at the end {kinetic[-1] / kinetic[0]:.4f} of that at the start")

    simulation = touchstone.Simulation(build())
    simulation.advance_to(LENGTH / 2)
    print(f"step by step: {simulation.step} steps, "
          f"largest stress {numpy.abs(simulation.field('stress')[:, 0]).max():.4e}")
    try:
        touchstone.Draft("bar").set("method.shape", "ugimpp")
    except touchstone.Error as error:
        print(f"status {error.status}: {error}")


if __name__ == "__main__":
    main(sys.argv[1])
