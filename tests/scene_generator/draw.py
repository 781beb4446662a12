"""Draws scenes: Hypothesis strategies made from the schema.

`draw_scene` walks through the schema and draws a value for each key from its kind, range, choices
and unit: a key that is new in the schema is drawn automatically. The tables of `meaning.py`
apply where a key has a meaning that its kind does not state, such as a region that must lie in
the grid, and list the keys that are left out, with the reason.

All lengths, times and masses are near 1: a cell, the time of a wave through a cell, a cell's mass.
Numbers are short and come from integers, so that Hypothesis shrinks them to simple ones.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math
import random

from hypothesis import strategies as st

from scales import Scales
from schema import unit_exponents, visit

ABSENT = object()  # of a key that a scene does not have
MODULI, OTHER_PAIR = {"bulk", "shear"}, {"young", "poisson"}


def short(value):
    """The number with six digits, an integer where it is one."""
    value = float(f"{value:.6g}")
    return int(value) if value == int(value) and abs(value) < 1e15 else value


class Canvas(Scales):
    """What a scene in the making offers to the draws: choices made so far, and scales. `draw` gives an
    integer between two."""

    def __init__(self, draw, situation, laws):
        self.draw = draw
        self.laws = laws  # required or not, by law and parameter
        self.situation = situation
        self.scene = {}
        self.path = []  # positions in lists on the way to the key in hand
        self.notes = {}  # what meanings remember: geometry of bodies, of cracks

    # -------------------------------------------------------------- primitive draws
    def integer(self, low, high):
        """An integer from low to high; shrinks to low."""
        return self.draw(low, high)

    def chance(self, percent):
        """True in so many percent of draws; shrinks to False."""
        return self.integer(0, 99) >= 100 - percent

    def pick(self, options):
        """One of the options; shrinks to the first."""
        return options[self.integer(0, len(options) - 1)]

    def number(self, low, high, parts=8):
        """A number between low and high, both possible; shrinks to low."""
        return short(low + (high - low) * self.integer(0, parts) / parts)

    # ------------------------------------------------------------------------- laws
    def law_requires(self, key):
        """Of a parameter of laws: does the material's law require it? None: it does not have it."""
        return self.laws[self.notes["group"]["law"]].get(key.name)

    def is_parameter(self, key):
        """Is the key a parameter of laws?"""
        return key.path.startswith("materials[].") and key.name in set().union(*self.laws.values())

    def without_pair(self, entry):
        """The material without the other pair of moduli, which is drawn first, if its law has none."""
        law = self.laws.get(entry.get("law"))
        if law is not None and law.keys() & MODULI != MODULI:
            return {name: value for name, value in entry.items() if name not in OTHER_PAIR}
        return entry

    # ----------------------------------------------------------------------- scales
    def scale(self, unit):
        """The natural size of a quantity with that unit."""
        length = min(self.cell)
        speed, density = 1, 1  # while materials are drawn
        if "materials" in self.scene:
            speed = self.wave
            density = max(material["density"] for material in self.scene["materials"])
        sizes = {"length": length, "time": length / speed, "mass": density * length ** 3,
                 "temperature": 1}
        return math.prod(sizes[name] ** power for name, power in unit_exponents(unit).items())

    def expression(self, unit, part, place=True, time=True):
        """An expression of coordinates and t of at most `part` times the natural size. Products and no
        quotients: muParser folds constants, and a power of two in a product changes no digit."""
        size = self.scale(unit) * part
        form = self.integer(0, 3)
        value = short(size * self.pick([1, 0.5, -0.5, -1]))
        if form == 1 and time:
            return f"{value}*(t*{short(0.1 / self.scale('time'))})"
        if form == 2 and place:
            names = ["r", "z"] if self.axisymmetric else ["x", "y"]
            axis = self.integer(0, 1)
            centre = self.notes["centre"][axis]
            return f"{short(value / self.cell[axis] / 8)}*({names[axis]}-({short(centre)}))"
        if form == 3 and time:
            return f"{value}*sin(t*{short(0.2 / self.scale('time'))})"
        return value


# ------------------------------------------------------------------ by kind alone
OPTIONAL = 30  # percent of scenes that have an optional key which no table knows


def draw_number(canvas, key):
    """A number in the key's range, of the natural size of its unit."""
    low, high = key.low, key.high
    if low is not None and high is not None and high <= 1e6 * max(abs(low), 1e-3):
        first, last = int(key.low_open), 8 - int(key.high_open)
        return short(low + (high - low) * canvas.integer(first, last) / 8)
    size = canvas.scale(key.unit) * 2.0 ** canvas.integer(-3, 2)
    if low is None:
        return short(size * canvas.pick([1, -1]))
    if not key.low_open and canvas.chance(20):
        return short(low)
    return short(low + size if high is None else min(low + size, high))


def draw_integer(canvas, key):
    """One of the lowest integers in the key's range."""
    low = int(key.low if key.low is not None else 0)
    high = int(min(key.high, low + 3)) if key.high is not None else low + 3
    return canvas.integer(low, high)


def draw_value(canvas, key, left_out):
    """A value of a key that is no group and no list, from its kind alone; none of the choices left out."""
    if key.choices is not None:
        return canvas.pick([choice for choice in key.choices
                            if f"{key.path}={choice}" not in left_out])
    kinds = {
        "number": lambda: draw_number(canvas, key),
        "integer": lambda: draw_integer(canvas, key),
        "boolean": lambda: canvas.pick([False, True]),
        "expression": lambda: canvas.expression(key.unit, 0.05),
        "drive": lambda: "free" if canvas.chance(40) else canvas.expression(key.unit, 0.05),
        "text": lambda: canvas.pick(["scene", "\u00fcber 1"]),
        "name": lambda: canvas.pick(["a", "b c"]),
    }
    if key.value == "law":
        raise AssertionError("laws are choices")
    one = kinds[key.value]
    if key.shape == "pair":
        return [one(), one()]
    if key.shape == "points":
        return [[one(), one()] for _ in range(max(2, int(key.low)))]
    return one()


def draw_key(canvas, key, tables):
    """A value of the key, or ABSENT."""
    if key.path in tables.LEFT_OUT or canvas.notes["still"] and key.path in tables.OF_MOTION:
        return ABSENT
    wanted = {None: True, "planar": "geometry" in canvas.scene and not canvas.axisymmetric,
              "axisymmetric": "geometry" in canvas.scene and canvas.axisymmetric}
    if not wanted[key.geometry]:
        return ABSENT
    required = key.required
    if canvas.is_parameter(key):
        required = canvas.law_requires(key)
        if required is None:
            return ABSENT
    if key.path in tables.MEANING:
        return tables.MEANING[key.path](canvas, key)
    if key.shape == "list":
        count = (tables.COUNT[key.path](canvas) if key.path in tables.COUNT
                 else canvas.integer(int(key.required), 2))
        entries = []
        for position in range(count):
            canvas.path.append(position)
            canvas.notes[key.path] = entries
            entries.append(draw_group(canvas, key, tables))
            if key.path == "materials":
                entries[-1] = canvas.without_pair(entries[-1])
            canvas.path.pop()
        return entries if entries or key.required else ABSENT
    if key.shape == "group":
        if not (key.required or key.path in tables.ALWAYS or canvas.chance(OPTIONAL)):
            return ABSENT
        group = draw_group(canvas, key, tables)
        return group if group or key.required else ABSENT
    if not required and not canvas.chance(OPTIONAL):
        return ABSENT
    return draw_value(canvas, key, tables.LEFT_OUT)


def draw_group(canvas, key, tables):
    """A mapping with the key's children, those in the tables' order first. Children that are
    drawn later see what has been drawn in canvas.notes["group"]."""
    first = [child for name in tables.FIRST.get(key.path, ())
             for child in key.children if child.name == name]
    group = canvas.scene if key.path == "" else {}
    for child in first + [child for child in key.children if child not in first]:
        outer, canvas.notes["group"] = canvas.notes.get("group"), group
        value = draw_key(canvas, child, tables)
        canvas.notes["group"] = outer
        if value is not ABSENT:
            group[child.name] = value
    return group


def draw_scene(integer, schema, tables, situation):
    """A scene of a situation that the tables know; integer(low, high) makes its choices."""
    canvas = Canvas(integer, situation, schema.laws)
    tables.prepare(canvas)
    scene = draw_group(canvas, schema, tables)
    return {key.name: scene[key.name] for key in schema.children if key.name in scene}


@st.composite
def scenes(draw, schema, tables, situation):
    """The same, as a strategy of Hypothesis."""
    return draw_scene(lambda low, high: draw(st.integers(low, high)), schema, tables, situation)


TRIES = 6000  # scenes; one to three thousand have all there is


def never_drawn(schema, keys, tables):
    """Keys, and choices as path=choice, that no function draws: those that are in none of many scenes
    of the most general situations, drawn by a generator of fixed seed."""
    source = random.Random(1)
    left = set(wanted_of(keys, tables))
    for number in range(TRIES):
        situation = tables.GENERAL[number % len(tables.GENERAL)]
        left -= keys_of(schema, draw_scene(source.randint, schema, tables, situation))
        if not left:
            break
    return sorted(left)


def keys_of(schema, scene):
    """Paths of the keys that a scene has, choices as path=choice."""
    found = set()

    def note(key, value):
        found.add(key.path)
        if key.choices is not None:
            found.add(f"{key.path}={value}")
        return value

    visit(schema, scene, note)
    return found


def wanted_of(keys, tables):
    """The keys that should be drawn, those that are no groups, and their choices as path=choice."""
    wanted = []
    for path, key in keys.items():
        if key.shape not in ("group", "list") and path not in tables.LEFT_OUT and \
                not path.startswith(tuple(name + end for name in tables.LEFT_OUT
                                          for end in (".", "[]."))):
            wanted += [path, *(f"{path}={choice}" for choice in key.choices or [])]
    return [path for path in wanted if path not in tables.LEFT_OUT]


def uncovered(keys, tables):
    """Faults of the tables against the schema: keys that they name and the schema lacks, and
    keys that neither a table nor their kind lets draw."""
    faults = []
    named = [*tables.LEFT_OUT, *tables.MEANING, *tables.COUNT, *tables.COVERED,
             *tables.OF_MOTION]
    for path in named:
        if path.split("=")[0] not in keys:
            faults.append(f"{path} is in a table of meaning.py, and not in the schema")
    for path in keys:
        parents = [other for other in tables.MEANING
                   if path.startswith((other + ".", other + "[]."))]
        if parents and path not in tables.COVERED and path not in tables.LEFT_OUT and \
                not path.startswith(tables.OPEN):
            faults.append(f"{path} is new within {parents[0]}, which meaning.py draws as a whole: "
                          "draw it there and name it in COVERED, or give a reason in LEFT_OUT")
    return faults
