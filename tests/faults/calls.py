"""Calls that concern files, as a program of `make VARIANT=faults` writes them down.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import dataclasses
import os
import re
import subprocess
import tempfile

SUFFIX = ".partial"  # of a file that is being written
LONGEST = 120  # seconds of a command before it counts as hanging
REASONS = {"ENOSPC": "No space left on device", "EIO": "Input/output error"}
HARMLESS = ("EINTR", "short")  # change nothing


def plain_name(path):
    """A name without numbers; of files that there are many of, the kind alone."""
    last = path.rsplit("/", 1)[-1]
    if re.fullmatch(r"touchstone-\w{6}", last):  # a temporary folder
        return "touchstone-?"
    name = re.sub(r"\d\d+", "#", last)
    if re.match(r"(particles|checkpoint|history|probes|run|scene|case|problem|reference|"
                r"checks\.jsonl|measurements|bench)[.-]", name):
        return name
    return re.sub(r"^[^.]+(?=\.)", "*", name)


@dataclasses.dataclass(frozen=True)
class Call:
    """One call: its number, its name, the fault it had, the faults it can have, its paths."""
    number: int
    name: str
    fault: str
    possible: tuple
    paths: tuple

    def site(self):
        """What it is done to, whatever the numbers in the names: `pwrite particles-#.hdf.partial`."""
        return " ".join([self.name, *(plain_name(path) for path in self.paths)])


@dataclasses.dataclass
class Outcome:
    """How a command ended. `status` is below 0 for a signal, None for a command that hangs."""
    status: int
    output: str
    errors: str
    calls: list

    def fired(self):
        """The calls that had a fault."""
        return [call for call in self.calls if call.fault != "-"]


def read_log(text, folder):
    """The calls of a log of a command that ran in the folder, in order."""
    found = []
    for line in text.splitlines():
        number, name, fault, possible, *paths = line.split("\t")
        possible = tuple(kind for kind in possible.split(",") if kind)
        paths = tuple(os.path.join(folder, path.removesuffix(" (deleted)")) for path in paths)
        found.append(Call(int(number), name, fault, possible, paths))
    return sorted(found, key=lambda call: call.number)


def run(command, folder, fault=None):
    """Runs a command in a folder, with a fault such as "EIO@17", and its calls written down."""
    with tempfile.TemporaryFile() as counter, \
            tempfile.TemporaryFile(buffering=0, mode="a+b") as log:
        environment = {**os.environ, "MPM_FAULT_COUNTER": str(counter.fileno()),
                       "MPM_FAULT_LOG": str(log.fileno()), "LC_ALL": "C"}
        if fault is not None:
            environment["MPM_FAULT"] = fault
        child = subprocess.Popen(command, cwd=folder, env=environment, text=True, errors="replace",
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, pass_fds=(counter.fileno(), log.fileno()),
                                 start_new_session=True)
        try:
            output, errors = child.communicate(timeout=LONGEST)
            status = child.returncode
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, 9)
            output, errors = child.communicate()
            status = None
        log.seek(0)
        return Outcome(status, output, errors, read_log(log.read().decode(errors="replace"), folder))


def choose(calls, kind, stride):
    """Numbers of the calls to fail: each stride-th, and the first of its name."""
    able = [call for call in calls if kind in call.possible]
    first = {}
    for call in able:
        first.setdefault(call.name, call.number)
    return sorted({*first.values(), *(call.number for call in able[stride // 2::stride])})


# ------------------------------------------------------------------------------ order

def disorder(calls):
    """What is wrong with the order of the calls, or None: what is written is synced before it gets
    its name; a checkpoint's name is brought to the disk before anything else happens."""
    dirty, synced = {}, set()
    waiting = None
    for call in calls:
        path = call.paths[0]
        if waiting is not None and call.name not in ("open", "close"):
            if call.name != "fsync" or path != os.path.dirname(waiting):
                return f"{waiting} has its new name, and no fsync of its folder follows, but {call.name}"
            waiting = None
        if call.name in ("write", "pwrite", "ftruncate", "create"):
            dirty[path] = call
            synced.discard(path)
        elif call.name == "fsync":
            dirty.pop(path, None)
            synced.add(path)
        elif call.name == "rename":
            if path in dirty:
                return f"rename {path} comes before its fsync"
            new = call.paths[1].rsplit("/", 1)[-1]
            if new == "checkpoint.h5":
                waiting = call.paths[1]
                history = os.path.dirname(waiting) + "/history.csv"
                if history in dirty:
                    return f"rename {path} comes before the fsync of {history}"
    return f"{waiting} has its new name, and no fsync of its folder follows" if waiting else None
