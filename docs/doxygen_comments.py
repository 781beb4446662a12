"""Filter of `make docs`: the plain comments of a public header as comments of Doxygen.

A comment before a declaration, or after one in its line, documents it. Declarations that follow each
other without an empty line share the comment above the first one.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import re
import sys


def marked(line):
    """Comments that start in the line."""
    bare = line.lstrip()
    if bare.startswith("/* -"):
        return line  # a rule between sections
    if bare.startswith("/*"):
        return line.replace("/*", "/**", 1)
    return line.replace("/*", "/**<", 1)


def shared(block):
    """A block without empty lines at the outer level: several declarations share its comment."""
    text = "\n".join(block)
    ends = re.findall(r"^(?:\S.*|\s+.*\));", re.sub(r"/\*.*?\*/", "", text, flags=re.S), re.M)
    several = block[0].startswith("/**") and len(ends) > 1
    return ["/**@{*/", *block, "/**@}*/"] if several and "struct" not in block_kinds(text) else block


def block_kinds(text):
    """What a block defines beside functions."""
    return set(re.findall(r"^(struct|enum)\b[^;()]*\{", text, re.M))


def main(path):
    if not path.endswith(".h"):
        sys.stdout.write(open(path, encoding="utf-8").read())
        return
    lines = open(path, encoding="utf-8").read().split("\n")
    end = next(k for k, line in enumerate(lines) if line.endswith("*/"))
    print("/** @file")
    print("\n".join([lines[0].replace("/*", " *", 1), *lines[1 : end + 1]]))
    block, depth = [], 0
    for line in lines[end + 1 :]:
        depth += line.count("{") - line.count("}")
        if line.strip() == "" and depth == 0:
            print("\n".join(shared(block)) if block else "")
            print()
            block = []
        else:
            block.append(marked(line))
    print("\n".join(block))


main(sys.argv[1])
