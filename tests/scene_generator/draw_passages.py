"""Draws what passes between surfaces: functions (canvas, key) of the tables in meaning.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, short

def draw_conductance(canvas, key):
    """From none to one that leaves no difference."""
    return short(canvas.pick([0.1, 1, 0.01, 0, 100]) * canvas.scale(key.unit))


def draw_heat_between(canvas, key):
    """A law of heat between surfaces of bodies; `key` is contact, or its pairs."""
    kind = canvas.pick(["perfect", "conductance", "conductance", "insulated"])
    if kind != "conductance":
        return {"heat": kind}
    return {"heat": kind, "conductance": draw_conductance(canvas, key.child("conductance"))}


def draw_gap(canvas, key, entry, usual):
    """The gap that heat passes, where the pair's law and detection use one; `entry`: the pair."""
    detection = entry.get("detection", usual.get("detection"))
    if entry.get("heat", "insulated") == "insulated" or detection != "extent" or \
            entry["law"] not in ("stick", "frictionless", "friction") or not canvas.chance(40):
        return {}
    return {"heat_gap": short(canvas.pick([0.1, 0.5, 0, 1]) * min(canvas.cell))}


def draw_crack_heat(canvas, key):
    """Of a crack, in most scenes with heat."""
    return canvas.pick(key.choices[1:] + key.choices) if canvas.notes["heat"] and \
        canvas.chance(80) else ABSENT


def draw_crack_conductance(canvas, key):
    """Goes with heat: conductance."""
    if canvas.notes["group"].get("heat") != "conductance":
        return ABSENT
    return draw_conductance(canvas, key)
