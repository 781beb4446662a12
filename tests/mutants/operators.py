"""Mutants made by exchanging operators, constants and indices in sources.

Every place where one of the exchanges below fits is a mutant. There are thousands: a run takes a
sample, the same one for the same seed.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import difflib
import random
import re

from mutant_files import Mutant

# what is there, what replaces it; the first group is what is replaced
EXCHANGES = (
    (r"[\w\])] (\+) [\w(]", "-"),
    (r"[\w\])] (-) [\w(]", "+"),
    (r"[\w\])] (\*) [\w(]", "/"),
    (r"[\w\])] (/) [\w(]", "*"),
    (r" (\+=) ", "-="),
    (r" (-=) ", "+="),
    (r"[\w\])] (<) [\w(]", "<="),
    (r"[\w\])] (>) [\w(]", ">="),
    (r" (<=) ", "<"),
    (r" (>=) ", ">"),
    (r" (==) ", "!="),
    (r" (!=) ", "=="),
    (r" (&&) ", "||"),
    (r" (\|\|) ", "&&"),
    (r"\b(0\.5)\b", "1.0"),
    (r"\b(1\.0)\b", "2.0"),
    (r"\b(2\.0)\b", "1.0"),
    (r"\[(0)\]", "1"),
    (r"\[(1)\]", "0"),
    (r"\b(MPM_XY)\b", "MPM_YX"),
    (r"\b(MPM_SYM_XX)\b", "MPM_SYM_YY"),
    (r"\b(fmax)\(", "fmin"),
    (r"\b(fmin)\(", "fmax"),
    (r"\b(true)\b", "false"),
    (r"\b(false)\b", "true"),
)
# Messages, includes, comments and what only sizes memory are left alone.
PASSED_OVER = re.compile(r'^\s*(#|/?\*|//)|"|sizeof|MPM_TAKE|\balloc|assert|for \(.*= 0; .*\+\+\)')


def code_lines(text):
    """Numbers of the lines that are code: not in a comment."""
    inside = False
    for number, line in enumerate(text.splitlines()):
        starts, ends = line.rfind("/*"), line.rfind("*/")
        if not inside and starts < 0 and not PASSED_OVER.search(line):
            yield number, line
        if starts > ends:
            inside = True
        elif ends > starts:
            inside = False


def places(text):
    for number, line in code_lines(text):
        for pattern, new in EXCHANGES:
            for match in re.finditer(pattern, line):
                yield number, match.start(1), match.end(1), new


def make(path, text, place):
    number, first, end, new = place
    lines = text.splitlines(keepends=True)
    line = lines[number]
    changed = list(lines)
    changed[number] = line[:first] + new + line[end:]
    diff = "".join(difflib.unified_diff(lines, changed, f"a/{path}", f"b/{path}", n=1))
    return Mutant(f"{path}:{number + 1}:{first + 1}", "operator",
                  f"`{line[first:end]}` becomes `{new}` in `{line.strip()}`", path, diff)


def sample(root, paths, count, seed):
    """`count` mutants, spread evenly over all places of all files."""
    found = [(path, text, place)
             for path, text in ((p, (root / p).read_text(encoding="utf-8")) for p in sorted(paths))
             for place in places(text)]
    chosen = random.Random(seed).sample(found, min(count, len(found)))
    return [make(*one) for one in sorted(chosen, key=lambda one: (one[0], one[2]))], len(found)
