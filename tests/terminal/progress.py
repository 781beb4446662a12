#!/usr/bin/python3
"""What programs print on terminals: a line of progress stays within the columns, whatever their
number; no colours with NO_COLOR, and no commands for the cursor on a terminal that has none.

usage: progress.py PROGRAMS

SPDX-License-Identifier: GPL-3.0-or-later
"""

import fcntl
import os
import pty
import re
import struct
import sys
import tempfile
import termios

SCENE = """format: 1
title: A block at rest
geometry: plane_strain
grid: {cell: [1, 1], cells: [2, 2]}
time: {end: 1, step: 0.01}
materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 1, shear: 1}]
bodies: [{name: block, material: rubber, region: {rectangle: {from: [0, 0], to: [1, 1]}}}]
"""
COMMANDS = (
    ["mpm", "run", "scene.yaml", "--overwrite"],
    ["mpm-verify", "run", "--case", "H1", "--variant", "ugimp", "--output", "report"],
)
WIDTHS = (2, 10, 20, 40, 80, 200)


def printed(words, columns, settings):
    """What a command prints on a terminal of so many columns."""
    ready, go = os.pipe()
    process, terminal = pty.fork()
    if process == 0:
        os.read(ready, 1)
        own = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        os.execvpe(words[0], words, {**own, "TERM": "xterm", **settings})
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    os.write(go, b"x")
    text = b""
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:
            break
        if not part:
            break
        text += part
    status = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    for file in (ready, go, terminal):
        os.close(file)
    if status != 0:
        sys.exit(f"{words}: exit status {status}: {text.decode()}")
    return text.decode()


def drawn(text):
    """Lines of progress: what is between a return of the cursor and what follows, without commands."""
    parts = re.split(r"[\r\n]+", re.sub(r"\x1b\[[0-9;]*m", "", text))
    return [part.replace("\x1b[K", "") for part in parts
            if re.search(r"^(\x1b\[K)?(\[[#.]*\] )?( *\d+ %  |\d+ of )", part)]


def faults_of(words):
    """What is wrong with the output of a command on terminals of all kinds."""
    program = words[0]
    for columns in WIDTHS:
        lines = drawn(printed(words, columns, {}))
        if columns >= 20 and not lines:
            yield f"{program}, {columns} columns: no progress"
        if columns == 200 and not any("#" in line or "." in line.split("]")[0] for line in lines):
            yield f"{program}, {columns} columns: no bar: {lines}"
        for line in lines:
            if len(line) >= columns:
                yield f"{program}, {columns} columns: {len(line)} characters: {line!r}"
    if "\x1b" in printed(words, 80, {"TERM": "dumb"}):
        yield f"{program}: commands for a terminal that has none"
    if "\x1b[3" in printed(words, 80, {"NO_COLOR": "1"}):
        yield f"{program}: colours with NO_COLOR"
    if program == "mpm-verify" and "\x1b[3" not in printed(words, 80, {"NO_COLOR": ""}):
        yield f"{program}: no colours with an empty NO_COLOR"


def main():
    programs, root = os.path.abspath(sys.argv[1]), os.getcwd()
    os.environ["PATH"] = f"{programs}:{os.environ['PATH']}"
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("scene.yaml", "w", encoding="utf-8") as scene:
            scene.write(SCENE)
        for words in COMMANDS:
            catalogue = ["--catalogue", f"{root}/verification/catalogue"]
            faults += faults_of(words + (catalogue if words[0] == "mpm-verify" else []))
        os.chdir(root)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
