"""Invariant: strain energy and cohesive energies against the work of their tractions. As in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy

import compare
from case import BALANCE, OF_CONTACT, require
from motion import smooth

STEPS, COURANT = 16, 0.2  # of the first run; each further one has twice the steps
ALLOWED = 0.05  # of the energy stored; seen in 150 scenes: up to 0.023
BENT = 0.5  # of the change by half the step: what squares of the step leave
LARGEST_CHANGE = 0.2  # of the energy stored: beyond, two runs do not give the limit
FAINT = 1e-10  # of the mass times the square of the wave speed: energies below are round-off


def without_losses(case):
    """The scene without what takes energy however short the step is: contact, mixtures of velocities,
    a thermostat. Cracks stay where one is cohesive. Interfaces between bodies
    are taken out too: the jump of the particles' displacement at a node is not what its velocities
    have added up to, and energy and work differ by a part of first order in the cell."""
    scene = smooth(case.scene)
    scene.pop("contact", None)
    scene.get("damping", {}).pop("thermostat", None)
    if "grid" not in scene.get("damping", {}):
        scene.get("damping", {}).pop("grid_form", None)
    if any("cohesive" in crack for crack in case.cracks):
        scene["cracks"] = [{name: value for name, value in crack.items() if name not in OF_CONTACT}
                           for crack in copy.deepcopy(case.cracks)]
        for crack in scene["cracks"]:
            crack["contact"] = "none"
    scene["output"] = {name: value for name, value in scene["output"].items()
                       if name in ("history", BALANCE)}
    return scene


def loss(case, parts):
    """What transfers have lost after steps of which each is 1/parts of the first run's, and the
    largest change of the energies that stresses and cohesive tractions store or dissipate; None
    where the run fails."""
    scene = without_losses(case)
    speed = case.wave + compare.largest(case.base.start.velocity)
    scene["time"] = {"end": scene["time"]["end"], "steps": STEPS * parts,
                     "step": COURANT * min(case.cell) / speed / parts}
    result = case.runner.run(scene)
    if result.status != 0:
        return None
    history = result.history
    change = history["strain_energy"] - history["strain_energy"][0]
    for name in ("cohesive_stored", "cohesive_dissipated", "plastic_dissipation", "plastic_heat"):
        change = change + history.get(name, 0.0)
    stored = compare.largest(change) + compare.largest(history.get("expansion_work", 0.0))
    return history["transfer_loss"][-1], stored


def energies_are_the_work_of_tractions(case):
    """The loss by transfers has the work of stresses and cohesive tractions less the change of their
    energies. It goes to zero with the step where nothing else takes energy: with FLIP particles get
    what nodes have, and the work of a step is the change of the energies, both but for squares of the
    step. A wrong energy leaves its error: the limit is 2 loss(dt/2) - loss(dt), but for squares of the
    step, which two more halvings may make small. Not judged: conditions and rigid bodies, whose impact takes energy."""
    if case.base.status != 0 or case.hides_losses or case.rigid or any(
            "velocity" in boundary for boundary in case.scene.get("boundary", [])):
        return False
    losses, stored = [], 0.0
    for parts in (1, 2, 4, 8):
        run = loss(case, parts)
        if run is None:
            return False
        losses.append(run[0])
        stored = run[1]
        if len(losses) == 1:
            continue
        if stored < FAINT * case.base.history["mass"][0] * case.wave ** 2:
            return False
        change = losses[-1] - losses[-2]
        limit = losses[-1] + change
        if abs(change) <= LARGEST_CHANGE * stored and \
                abs(limit) <= ALLOWED * stored + BENT * abs(change):
            return True
    require(abs(change) > LARGEST_CHANGE * stored, "transfer losses as the step is halved again and again: " +
            ", ".join(f"{value:.4g}" for value in losses) + f"; they go to {limit:.4g}, not to 0; "
            f"energy stored: {stored:.4g}")
    return False
