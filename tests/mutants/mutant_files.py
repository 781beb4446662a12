"""Mutants: small planted bugs, as patches.

A curated mutant is a file curated/<name>.patch: lines `Kind:`, `What:` and, for one that no test can
tell from the original, `Equivalent:` with the reason; then a diff of one source file.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import dataclasses
import fnmatch
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CURATED = HERE / "curated"
ROOMS = ("solver/base", "solver/model", "solver/method", "solver/simulation", "solver/io",
         "solver/cli", "verification/exact", "verification/measures", "verification/programs",
         "verification/suite", "verification/score", "verification/study")
FEWEST = 60
KINDS = ("wrong sign", "lost term", "lost rule", "swapped index", "stale field", "wrong time level",
         "missing truncation", "missing condition", "unlocked race", "wrong norm", "oracle typo",
         "wrong constant", "accuracy", "operator")


class Fault(Exception):
    """Something that the person who called has to put right."""


@dataclasses.dataclass
class Mutant:
    name: str
    kind: str
    what: str
    path: str  # of the source file that it changes
    patch: str
    equivalent: str = ""  # the reason

    @property
    def room(self):
        """solver/<room> or verification/<room>, whatever folders are below it."""
        return "/".join(self.path.split("/")[:2])


def read_header(name, text):
    header = {}
    for line in text.split("\n\n", 1)[0].splitlines():
        key, colon, value = line.partition(": ")
        if not colon or key not in ("Kind", "What", "Equivalent") or key in header:
            raise Fault(f"{name}: line {line!r}; allowed: Kind:, What:, Equivalent:, each once")
        header[key] = value.strip()
    for key in ("Kind", "What"):
        if not header.get(key):
            raise Fault(f"{name}: no {key}:")
    if header["Kind"] not in KINDS:
        raise Fault(f"{name}: Kind: {header['Kind']}; allowed: {', '.join(KINDS)}")
    return header


def read_curated(path):
    text = path.read_text(encoding="utf-8")
    header = read_header(path.name, text)
    files = re.findall(r"^\+\+\+ b/(\S+)$", text, re.MULTILINE)
    if len(files) != 1:
        raise Fault(f"{path.name}: changes {len(files)} files; allowed: one")
    return Mutant(path.stem, header["Kind"], header["What"], files[0], text,
                  header.get("Equivalent", ""))


def all_curated(glob="*"):
    chosen = [read_curated(p) for p in sorted(CURATED.glob("*.patch"))
              if fnmatch.fnmatch(p.stem, glob)]
    if not chosen:
        raise Fault(f"no mutant matches {glob!r}")
    return chosen
