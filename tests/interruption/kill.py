#!/usr/bin/python3
"""Runs that are killed at random moments go on to the same bytes: `make test-kill`.

    kill.py --mpm PROGRAM [--kills N] [--races N] [--seed N] SCENE...

Kills runs with SIGKILL, or ends some with SIGTERM, while they step, write checkpoints, snapshots or
results, and lets them go on with --resume, or start anew where there is no checkpoint yet, until
they end; their files must be those of a run without interruption. Then starts two runs into one
folder at a time: one of them must end well, with those files, and the other with exit status 2, or
they must have run one after the other. The last line is `N passed, N failed, N skipped`: scenes and
races.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SETTINGS = ("output.checkpoint_seconds=0.01",)  # seconds: a kill often meets a checkpoint
KILLS_IN_A_ROW = 12  # of one run, before it may end
SIGNALS = (signal.SIGKILL, signal.SIGKILL, signal.SIGTERM)
ENDED = (-signal.SIGKILL, -signal.SIGTERM, 128 + signal.SIGTERM)  # before SIGTERM is awaited, too


def command(mpm, scene, folder, *options):
    """A run of the scene into the folder."""
    settings = [part for setting in SETTINGS for part in ("--set", setting)]
    return [mpm, "run", "--quiet", "--output", str(folder), *settings, *options, str(scene)]


def results(folder):
    """The files of a run by name: but for run.json, which has times, and checkpoints."""
    return {path.name: path.read_bytes() for path in folder.iterdir()
            if path.name not in ("run.json", "run.lock") and not path.name.startswith("checkpoint")}


def has_checkpoint(folder):
    """Is there one to go on from?"""
    return (folder / "checkpoint.h5").exists() or (folder / "checkpoint-previous.h5").exists()


class Reference:
    """A run without interruption: its files, and how long it takes."""

    def __init__(self, mpm, scene, folder):
        start = time.monotonic()
        done = subprocess.run(command(mpm, scene, folder), capture_output=True, text=True,
                              check=False)
        self.seconds = time.monotonic() - start
        self.status, self.message = done.returncode, done.stderr
        self.files = results(folder) if done.returncode in (0, 3) else {}


class Kills:
    """Kills of runs of one scene, counted."""

    def __init__(self, mpm, scene, reference, folder, chance):
        self.mpm, self.scene, self.reference = mpm, scene, reference
        self.folder, self.chance = folder, chance
        self.killed = self.asked = self.resumed = 0

    def one_run(self, most):
        """Kills a run up to so many times, lets it end; returns what is wrong, or None."""
        shutil.rmtree(self.folder, ignore_errors=True)
        for kill in range(most + 1):
            resumes = has_checkpoint(self.folder)
            self.resumed += resumes
            option = "--resume" if resumes else "--overwrite"
            threads = str(self.chance.choice((1, 2, 3)))
            run = subprocess.Popen(command(self.mpm, self.scene, self.folder, option,
                                           "--threads", threads), stderr=subprocess.PIPE, text=True)
            if kill < most:
                time.sleep(self.reference.seconds * self.chance.random())
                run.send_signal(self.chance.choice(SIGNALS))
            message = run.communicate()[1]
            if run.returncode not in ENDED:
                break
            self.killed += 1
            self.asked += run.returncode == 128 + signal.SIGTERM
        if run.returncode != self.reference.status:
            return f"exit {run.returncode}: {message.strip()}"
        found = results(self.folder)
        if found.keys() != self.reference.files.keys():
            return f"other files: {sorted(found.keys() ^ self.reference.files.keys())}"
        other = [name for name, content in found.items() if content != self.reference.files[name]]
        return f"other bytes: {other}" if other else None


def race(mpm, scene, reference, folder, overwrite):
    """Two runs into one folder at a time; returns what is wrong, or None."""
    shutil.rmtree(folder, ignore_errors=True)
    options = ("--overwrite",) if overwrite else ()
    runs = [subprocess.Popen(command(mpm, scene, folder, *options), stderr=subprocess.PIPE,
                             text=True) for _ in range(2)]
    messages = [run.communicate()[1].strip() for run in runs]
    codes = sorted(run.returncode for run in runs)
    if codes != sorted([reference.status, 2]) and not (overwrite and codes == [reference.status] * 2):
        return f"exit {codes}: {messages}"
    if results(folder) != reference.files:
        return "other files than those of one run"
    return "a lock is left" if (folder / "run.lock").exists() else None


def main():
    """Exit status: 0 all as it should be; 1 something is not; 2 bad usage."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mpm", required=True)
    parser.add_argument("--kills", type=int, default=60)
    parser.add_argument("--races", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    given = parser.parse_args()
    chance = random.Random(given.seed)
    failures = passed = killed = asked = resumed = 0
    memory = pathlib.Path("/dev/shm")  # where a sync costs nothing
    where = memory if os.access(memory, os.W_OK) else None
    with tempfile.TemporaryDirectory(prefix="mpm-kill-", dir=where) as scratch:
        scratch = pathlib.Path(scratch)
        references = [Reference(given.mpm, scene, scratch / f"whole-{k}")
                      for k, scene in enumerate(given.scenes)]
        for k, (scene, reference) in enumerate(zip(given.scenes, references)):
            if not reference.files:
                print(f"FAIL {scene}: exit {reference.status}: {reference.message.strip()}")
                failures += 1
                continue
            kills = Kills(given.mpm, scene, reference, scratch / "killed", chance)
            wrong = None
            share = (given.kills * (k + 1)) // len(references) - killed
            while kills.killed < share and wrong is None:
                wrong = kills.one_run(min(KILLS_IN_A_ROW, share - kills.killed))
            killed += kills.killed
            asked += kills.asked
            resumed += kills.resumed
            failures += wrong is not None
            passed += wrong is None
            print(f"{'FAIL' if wrong else 'pass'} {scene}: {kills.killed} kills, {kills.resumed} "
                  f"resumes{': ' + wrong if wrong else ''}", flush=True)
        for number in range(given.races):
            k = number % len(references)
            wrong = race(given.mpm, given.scenes[k], references[k], scratch / "race",
                         number % 2 == 1)
            failures += wrong is not None
            passed += wrong is None
            if wrong is not None:
                print(f"FAIL race of {given.scenes[k]}: {wrong}", flush=True)
    print(f"{killed} kills, {asked} of them SIGTERM, {resumed} resumes, {given.races} races of two runs")
    print(f"{passed} passed, {failures} failed, 0 skipped")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
