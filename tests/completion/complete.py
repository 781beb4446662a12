#!/usr/bin/python3
"""Completion in a real shell under a pseudo-terminal: what is typed, Tab, and what the shell makes
of it.

usage: complete.py PROGRAMS bash|zsh|fish

SPDX-License-Identifier: GPL-3.0-or-later
"""

import fcntl
import os
import pathlib
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time

PROGRAMS = ("mpm", "mpm-verify", "mpm-bench")
SECONDS = 20
LEFT = "\x1b[D"  # the key
SCENE = """format: 1
geometry: plane_strain
grid: {cell: [1, 1], cells: [2, 2]}
time: {end: 1, step: 0.1, steps: 1}
materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 1, shear: 1}]
bodies: [{name: block, material: rubber, region: {rectangle: {from: [0, 0], to: [1, 1]}}}]
"""
READY = "ready-for-words"

# What is typed before Tab, what must then be on the screen, and what must not be; folder/, scene.yaml
# and notes.txt are in the current folder, and in "a b" the results of a run.
TYPED = (
    ("mpm sch", ["mpm schema"]),
    ("mpm run --over", ["--overwrite"]),
    ("mpm run --simd base", ["baseline"]),
    ("mpm check scen", ["scene.yaml"]),
    ("mpm run scene.yaml --output fol", ["folder"]),
    ("mpm completion fi", ["completion fish"]),
    ("mpm new ", ["bar", "contact", "penetration"]),
    ("mpm new pene", ["new penetration"]),
    ("mpm plot --field v", ["von_mises", "viscous_pressure"]),
    ("mpm plot --field stress.", ["stress.xx", "stress.rr"]),
    ("mpm plot a\\ b --field v", ["von_mises", "velocity.x", "volume"], ["viscous_pressure"]),
    ("mpm plot --field v 'a b'" + 6 * LEFT, ["von_mises", "volume"], ["viscous_pressure"], ["bash", "zsh"]),
    ("mpm plot folder --field v", ["von_mises", "viscous_pressure"]),
    ("mpm plot a\\ b --field stress.", ["stress.xx"], ["stress.rr", "no-word"]),
    ("mpm run scene.yaml -ofol", ["folder/"], [], ["zsh"]),
    ("mpm-verify expl", ["explain"]),
    ("mpm-verify run --tier fu", ["full"]),
    ("mpm-verify score fol", ["folder"]),
    ("mpm-verify help headr", ["headroom"]),
    ("mpm-verify export --case R1", ["R1b"]),
    ("mpm-verify explain D5", ["D5b", "D5c"]),
    ("mpm-bench run --group over", ["overhead"]),
    ("mpm-bench bud", ["budget"]),
    ("mpm-bench run --tier qu", ["quick"]),
    ("mpm-bench budget --func", ["--functions"]),
)
STARTS = {
    "bash": ["bash", "--norc", "--noprofile", "-i"],
    "zsh": ["zsh", "-f", "-i"],
    "fish": ["fish", "--no-config", "-i"],
}
SETTINGS = {
    "bash": "bind 'set enable-bracketed-paste off'; bind 'set bell-style none'; bind 'set show-all-if-ambiguous on'; PS1='> '; "
            "for p in {programs}; do source $p.bash; done",
    "zsh": "unsetopt zle_bracketed_paste 2>/dev/null; PS1='> '; autoload -Uz compinit; "
           "compinit -u -d ./dump; for p in {programs}; do source ./$p.zsh; done",
    "fish": "function fish_prompt; echo '> '; end; for p in {programs}; source $p.fish; end",
}


class Shell:
    """A shell on a pseudo-terminal in a folder."""

    def __init__(self, arguments, folder, path):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            own = {"PATH": path, "HOME": folder, "TERM": "xterm", "LC_ALL": "C.UTF-8",
                   "XDG_CONFIG_HOME": folder, "XDG_DATA_HOME": folder}
            os.execvpe(arguments[0], arguments, own)
        # without a size fish has no room for a list of several words
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self.screen = ""

    def type(self, text):
        os.write(self.terminal, text.encode())

    def wait(self, words):
        """Whether all words come to the screen, in any order, before the time is over."""
        end = time.monotonic() + SECONDS
        while not all(word in self.plain() for word in words):
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.terminal], [], [], left)[0]:
                return False
            try:
                self.screen += os.read(self.terminal, 4096).decode(errors="replace")
            except OSError:
                return False
        return True

    def plain(self):
        """The screen without what moves the cursor or colours."""
        text = re.sub(r"\x1b(\[[0-9;?]*[A-Za-z]|\][^\x07]*\x07|[()=>][A-Z0-9]?)", "", self.screen)
        return text.replace("\r", "").replace("\b", "")

    def end(self):
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)
        os.close(self.terminal)


def prepare(folder, programs, name):
    (folder / "folder").mkdir()
    (folder / "scene.yaml").write_text("")
    (folder / "notes.txt").write_text("")
    subprocess.run([f"{programs}/mpm", "run", "-", "--quiet", "-oa b"], cwd=folder, input=SCENE,
                   text=True, check=True)
    for program in PROGRAMS:
        made = subprocess.run([f"{programs}/{program}", "completion", name], check=True,
                              capture_output=True)
        (folder / f"{program}.{name}").write_bytes(made.stdout)


def start(folder, programs, name):
    shell = Shell(STARTS[name], str(folder), f"{programs}:/usr/local/bin:/usr/bin:/bin")
    shell.type(SETTINGS[name].format(programs=" ".join(PROGRAMS)) + f"; echo {READY[:5]}'{READY[5:]}'\n")
    if not shell.wait([READY]):
        sys.exit(f"{name} does not get ready:\n{shell.plain()}")
    return shell


def main():
    programs, name = os.path.abspath(sys.argv[1]), sys.argv[2]
    faults = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        prepare(folder, programs, name)
        for typed, words, absent, shells in (row + ([], list(STARTS))[len(row) - 2:] for row in TYPED):
            if name not in shells:
                continue
            shell = start(folder, programs, name)
            shell.screen = ""
            shell.type(typed + "\t")
            if not shell.wait(words):
                faults.append(f"{name}: {typed}<Tab>: no {words} in: {shell.plain()!r}")
            for word in absent:
                if word in shell.plain():
                    faults.append(f"{name}: {typed}<Tab>: {word} in: {shell.plain()!r}")
            shell.end()
    for fault in faults:
        print(fault)
    print(f"{name}: {len(TYPED)} completions, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
