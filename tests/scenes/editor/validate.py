#!/usr/bin/python3
"""JSON Schema of scenes, as `mpm schema --json` prints it, against all scenes of the tree: it accepts
each that is read, and refuses each mistake that it can express.

usage: validate.py MPM

SPDX-License-Identifier: GPL-3.0-or-later
"""

import json
import pathlib
import re
import subprocess
import sys

import jsonschema
import yaml

# What the first line of a malformed scene promises, where one key is wrong by itself.
EXPRESSIBLE = re.compile(
    r"unknown (key|choice|law)|not a (number|boolean|list|mapping|pair|single value)|not an integer|"
    r"out of range|the key is required|not for this geometry|wrong number of (points|entries)|"
    r"one entry is needed at least|cannot be free|no name")
# Those that it cannot, although their message sounds like it.
OTHERS = {
    "courant_above_one": "time.allow_unstable decides",
    "expression_not_a_number": "a formula has a value where it is used alone",
    "number_overflow": "a parser makes infinity of it, which is a number",
}


class Loader(yaml.SafeLoader):
    """Numbers as YAML 1.2 has them, and editors: 1e-3 is one, yes is a text, 2026-01-01 too."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in (
        ("bool", r"true|false", "tf"),
        ("null", r"~|null|", ["~", "n", ""]),
        ("int", r"[-+]?[0-9]+", "-+0123456789"),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789")):
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), list(first))
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))


def load(path):
    """The document, or None where it is none that an editor would check."""
    try:
        return yaml.load(path.read_text(encoding="utf-8"), Loader)
    except (yaml.YAMLError, UnicodeDecodeError, ValueError):
        return None


def is_scene(document):
    return isinstance(document, dict) and {"geometry", "grid", "bodies"} <= document.keys()


def main():
    schema = json.loads(subprocess.run([sys.argv[1], "schema", "--json"], check=True,
                                       capture_output=True).stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    faults, accepted, refused = [], 0, 0
    root = pathlib.Path(".")
    bad = root / "tests/scenes/bad"
    for folder in ("verification", "benchmarks", "tests", "examples", "docs"):
        for path in sorted((root / folder).rglob("*.yaml")):
            document = load(path)
            if bad in path.parents or "fuzz" in path.parts or not is_scene(document):
                continue
            accepted += 1
            faults += [f"{path}: refused: {error.json_path}: {error.message[:120]}"
                       for error in validator.iter_errors(document)]
    for path in sorted(bad.glob("*.yaml")):
        promise = path.read_text(encoding="utf-8", errors="replace").split("\n", 1)[0]
        if not EXPRESSIBLE.search(promise):
            continue
        accepts = validator.is_valid(load(path))
        refused += not accepts
        if accepts and path.stem not in OTHERS:
            faults.append(f"{path}: accepted, although: {promise}")
        if not accepts and path.stem in OTHERS:
            faults.append(f"{path}: refused, which OTHERS denies")
    for fault in faults:
        print(fault)
    print(f"{accepted} scenes accepted, {refused} malformed ones refused, {len(faults)} faults")
    return 1 if faults or accepted < 250 or refused < 80 else 0


if __name__ == "__main__":
    sys.exit(main())
