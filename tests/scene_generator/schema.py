"""The schema of scenes, as `mpm schema --list` prints it.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import json
import re
import subprocess


class Key:
    """One key: `path` as in the table ("bodies[].name"), its last `name`, and its entry in the schema."""

    def __init__(self, row):
        self.path = row["key"]
        self.name = re.split(r"[.\[\]]+", self.path)[-1]
        self.shape = row["shape"]
        self.value = row["value"]
        self.geometry = row["geometry"]
        self.required = row["required"]
        self.unit = row["unit"]
        self.low, self.high = row["low"], row["high"]
        self.low_open, self.high_open = row["low_open"], row["high_open"]
        self.choices = row["choices"]
        self.children = []

    @property
    def inner(self):
        """What the paths of its children begin with."""
        return self.path + ("[]." if self.shape == "list" else ".")

    def child(self, name):
        """The child of that name, or None."""
        return next((key for key in self.children if key.name == name), None)


def unit_exponents(unit):
    """{"length": 1, "time": -2} of "length/time^2", and of "length/(time^2 temperature)"; {} of ""."""
    exponents = {}
    for sign, part in zip((1, -1), (unit.split("/") + [""])[:2]):
        for name, power in re.findall(r"(length|mass|time|temperature)(?:\^(\d+))?", part):
            exponents[name] = exponents.get(name, 0) + sign * int(power or 1)
    return exponents


def read_schema(mpm):
    """The root of the schema of the program `mpm`, and all keys by path."""
    text = subprocess.run([mpm, "schema", "--list"], check=True, capture_output=True).stdout
    schema = json.loads(text)
    rows = schema["keys"]
    root = Key({"key": "", "shape": "group", "value": None, "geometry": None, "required": True,
                "unit": "", "low": None, "high": None, "low_open": False, "high_open": False,
                "choices": None})
    keys = {row["key"]: Key(row) for row in rows}
    for key in keys.values():
        parent = key.path[:-len(key.name)].rstrip(".").removesuffix("[]")
        (keys[parent] if parent else root).children.append(key)
    root.laws = {law["law"]: {own["key"]: own["required"] for own in law["parameters"]}
                 for law in schema.get("laws", [])}
    return root, keys


def visit(schema, scene, change):
    """A copy of the scene in which each value has become change(key, value). Groups and lists are
    passed on to their entries; pairs, points and single values come to `change` as a whole."""
    def copy(key, value):
        if key.shape == "group":
            if not isinstance(value, dict):
                return value  # `region: all`
            return {name: copy(key.child(name), entry) for name, entry in value.items()}
        if key.shape == "list":
            return [{name: copy(key.child(name), entry) for name, entry in item.items()}
                    for item in value]
        return change(key, value)
    return {name: copy(schema.child(name), value) for name, value in scene.items()}
