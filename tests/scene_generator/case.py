"""A scene that is judged: its runs, and what invariants need to know about it.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import math

import compare
from scales import Scales

BALANCE = "energy_balance"  # key of output: history has the losses that close the ledger


OF_CONTACT = ("contact", "friction", "separated", "touching", "detection")


def points_along(chain, parts=8):
    """Points along a chain, its segments in so many parts."""
    return [[a + (b - a) * k / parts for a, b in zip(one, other)]
            for one, other in zip(chain, chain[1:]) for k in range(parts + 1)]


class Violation(Exception):
    """An invariant does not hold: what was seen, what is allowed."""


class Discarded(Exception):
    """A scene that `mpm check` refuses."""


class Case(Scales):
    """A scene, its runs as they are needed, and what invariants need to know about it."""

    def __init__(self, runner, schema, scene):
        self.runner, self.schema, self.scene = runner, schema, copy.deepcopy(scene)
        self.made = {}
        if self.measures_losses:
            self.scene.setdefault("output", {}).setdefault(BALANCE, True)

    def once(self, name, make):
        """What `make` returns, made when it is first needed."""
        if name not in self.made:
            self.made[name] = make()
        return self.made[name]

    # ------------------------------------------------------------------------- runs
    @property
    def base(self):
        """The run of the scene as it is."""
        return self.once("base", lambda: self.runner.run(self.scene))

    @property
    def brief(self):
        """The scene with so few steps that round-off stays round-off."""
        scene = copy.deepcopy(self.scene)
        scene["time"]["steps"] = min(compare.STEPS, scene["time"].get("steps", compare.STEPS))
        scene["time"].pop("rest", None)
        return scene

    @property
    def plain(self):
        """The run of the brief scene."""
        if self.brief == self.scene:
            return self.base
        return self.once("plain", lambda: self.runner.run(self.brief))

    # -------------------------------------------------------------------- questions
    @property
    def measures_losses(self):
        """Can the scene measure what is lost between particles and nodes?"""
        return self.schema.child("output").child(BALANCE) is not None and not self.at_rest

    @property
    def hides_losses(self):
        """Has the scene been drawn without them?"""
        return self.at_rest or self.measures_losses and not self.scene["output"][BALANCE]

    @property
    def at_rest(self):
        """Has the scene no mechanics: are its materials without stress?"""
        return any(material["law"] == "none" for material in self.scene["materials"])

    @property
    def conducts(self):
        """Is there transport, of heat or a solvent?"""
        return bool(self.scalars)

    @property
    def heats(self):
        """Does deformation change temperatures?"""
        return self.scene.get("transport", {}).get("temperature", {}).get("heating", False)

    @property
    def gas(self):
        """Is a material a gas, which expands where nothing holds it?"""
        return any(material["law"] == "ideal_gas" for material in self.scene["materials"])

    @property
    def softens(self):
        """Is a material softened by the temperature that is conducted?"""
        return self.conducts and any(
            "melting_temperature" in material and "specific_heat" not in material
            for material in self.scene["materials"])

    @property
    def couples(self):
        """Do stresses follow a scalar?"""
        return self.gas or self.softens or any(material.get(scalar.expansion, 0) != 0 for scalar in self.scalars
                               for material in self.scene["materials"])

    @property
    def exchanges(self):
        """Does heat pass between surfaces?"""
        contact = self.scene.get("contact", {})
        return any(entry.get("heat", "insulated") != "insulated"
                   for entry in [contact, *contact.get("pairs", []), *self.cracks])

    @property
    def waits(self):
        """Has transport steps of its own?"""
        transport = self.scene.get("transport", {})
        return transport.get("every", 1) > 1 or transport.get("substeps", 1) > 1

    @property
    def method(self):
        """The method, with the defaults that matter here."""
        given = self.scene.get("method", {})
        transfer = given.get("transfer", {})
        return {"shape": given.get("shape", "ugimp"), "form": given.get("form", "velocity"),
                "stress_update": given.get("stress_update", "musl"),
                "extrapolate": given.get("extrapolate", True),
                "axis": given.get("axis", "truncated"), "cracks": given.get("cracks", "fields"),
                "kind": transfer.get("kind", "flip"),
                "fraction": transfer.get("fraction", 1), "order": transfer.get("order", 1)}

    @property
    def deformable(self):
        """The names of the bodies that are not rigid."""
        return [body["name"] for body in self.scene["bodies"] if "rigid" not in body]

    @property
    def least_overlap(self):
        """The least overlap of a particle's domain with the functions of a node in the brief run, as a
        fraction of a cell, from the node's mass: it grows with the square of the overlap, and with
        the overlap itself with classic functions. 1 where strains do not follow the velocities of the
        momentum update (compare.py)."""
        method = self.method
        if method["stress_update"] != "usl" and \
                (method["stress_update"] != "usavg" or method["extrapolate"]):
            return 1.0
        status, _, rows = self.runner.nodes(self.brief)
        if status != 0 or len(rows) == 0:
            return 1.0
        start = self.plain.start
        part = rows[:, 7].min() / start.mass[start.of_bodies(self.deformable)].min()
        return min(1.0, part if method["shape"] == "classic" else math.sqrt(part))

    @property
    def cracks(self):
        """The cracks of the scene."""
        return self.scene.get("cracks", [])

    @property
    def touching(self):
        """Is there contact, of cracks or of bodies?"""
        return "contact" in self.scene or any(crack.get("contact", "frictionless") != "none" for crack in self.cracks)

    @property
    def crowded(self):
        """Has the run nodes without contact, or nodes that may be between cracks of different kinds?

        Particles beyond different cracks may share a velocity field of a node, by which side of their
        crack they are on; such nodes have no contact and are counted in the history. Which they are
        depends on the directions of the cracks. A node between two cracks has two exchanges, one after
        the other, over and over: where their laws differ, what they end with depends on their order.
        """
        return without_contact(self.plain) or self.mixed

    @property
    def mixed(self):
        """Have two cracks within three cells of each other contact of different kinds?"""
        kinds = [[crack.get(name) for name in OF_CONTACT] for crack in self.cracks]
        places = [points_along(crack["points"]) for crack in self.cracks]
        return any(kinds[k] != kinds[j] and
                   min(math.dist(one, other) for one in places[k] for other in places[j]) <
                   3 * max(self.cell) for k in range(len(kinds)) for j in range(k))

    @property
    def loads(self):
        """The loads of the scene."""
        return self.scene.get("loads", {})

    @property
    def rigid(self):
        """Has the scene rigid bodies?"""
        return any("rigid" in body for body in self.scene["bodies"])


def without_contact(result):
    """Has a run nodes that lack contact since particles beyond two cracks share their field?"""
    return any(name.endswith("_nodes_without_contact") and values.max() > 0
               for name, values in result.history.items())


def evaluate(expression, **names):
    """The value of an expression of a scene."""
    if not isinstance(expression, str):
        return float(expression)
    functions = {"sin": math.sin, "min": min, "max": max, "pi": math.pi}
    return float(eval(expression.replace("^", "**"),  # our own text: numbers, names, operators
                      {"__builtins__": {}}, functions | names))


def require(holds, text):
    """Raises Violation with the text unless it holds."""
    if not holds:
        raise Violation(text)
