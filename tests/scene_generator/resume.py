"""The invariant of runs that go on from a checkpoint. A function as in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy

from case import require

INTERVALS = 2.7  # of checkpoints in a run: two, the last one some time before its end


def a_resumed_run_changes_no_bit(case):
    """A run that goes on from its last checkpoint, with two threads, and from the one before, with one:
    the files of the run that left them. Not judged: runs that end before the second one."""
    time = case.base.history["time"][-1] if case.base.status in (0, 3) else 0
    if not time > 0:
        return False
    scene = copy.deepcopy(case.scene)
    scene.setdefault("output", {})["checkpoint"] = float(time / INTERVALS)
    whole = case.runner.run(scene, keep_bytes=True)
    if not case.runner.has("checkpoint-previous.h5"):
        return False
    for name, threads in (("checkpoint.h5", "2"), ("checkpoint-previous.h5", "1")):
        case.runner.keep_checkpoint(name)
        other = case.runner.resume("--threads", threads)
        require((other.status, other.message) == (whole.status, whole.message),
                f"{name}: exit {other.status}: {other.message}; without: exit {whole.status}")
        require(other.files.keys() == whole.files.keys(), f"{name}: other files")
        for file, content in whole.files.items():
            require(other.files[file] == content, f"{name}: {file} differs")
    return True
