#!/usr/bin/python3
"""Runs of the suite that are killed go on to the same report: part of `make test-kill`.

    kill_suite.py --verify PROGRAM [--kills N] [--races N] [--seed N]

Kills `mpm-verify run` at random moments (SIGKILL; every fourth time SIGTERM) and lets it go on with
--resume until it ends; the report must be that of a run without interruption, byte by byte but for
times, and at no moment may the report before be gone. Then starts two runs into one folder at a time:
one must pass, and the other be refused with exit status 2, or run after it. The last line is
`N passed, N failed, N skipped`.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "slurm"))
from campaign import normalize  # pylint: disable=wrong-import-position

SELECTION = ("--case", "W1", "--variant", "*_five_grids")
KILLS_IN_A_ROW = 8


def start(verify, folder, *options):
    """A run into the folder."""
    return subprocess.Popen([verify, "run", "--jobs", "2", "--output", str(folder), *options],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def killed_run(verify, folder, seconds, most, chance):
    """Kills a run up to so many times and lets it end; kills, resumes, what is wrong or None."""
    kills = resumes = 0
    while True:
        going = (folder / ".run" / "run.json").exists() and kills > 0
        resumes += going
        run = start(verify, folder, *(("--resume",) if going else SELECTION))
        number = signal.SIGTERM if kills % 4 == 3 else signal.SIGKILL
        if kills < most:
            time.sleep(seconds * chance.random())
            run.send_signal(number)
        said = run.communicate()[0]
        if not (folder / "checks.jsonl").exists():
            return kills, resumes, "the report before is gone"
        if run.returncode not in (-number, 128 + number):
            wrong = None if run.returncode == 0 else f"exit {run.returncode}: {said}"
            return kills, resumes, wrong
        kills += 1


def race(verify, folder):
    """Two runs at a time; what is wrong, or None."""
    runs = [start(verify, folder, *SELECTION) for _ in range(2)]
    said = [run.communicate()[0] for run in runs]
    codes = sorted(run.returncode for run in runs)
    return None if codes in ([0, 2], [0, 0]) else f"exit {codes}: {said}"


def main():
    """Exit status: 0 all as it should be; 1 something is not."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--verify", required=True)
    parser.add_argument("--kills", type=int, default=16)
    parser.add_argument("--races", type=int, default=4)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    chance = random.Random(given.seed)
    passed = failed = killed = resumed = 0
    with tempfile.TemporaryDirectory(prefix="mpm-kill ") as scratch:
        whole, folder = pathlib.Path(scratch) / "whole", pathlib.Path(scratch) / "it's \"killed\""
        begun = time.monotonic()
        start(given.verify, whole, *SELECTION).communicate()
        seconds = time.monotonic() - begun
        expected = normalize(given.verify, whole)
        start(given.verify, folder, *SELECTION).communicate()
        while killed < given.kills and failed == 0:
            kills, resumes, wrong = killed_run(given.verify, folder, seconds,
                                               min(KILLS_IN_A_ROW, given.kills - killed), chance)
            killed, resumed = killed + kills, resumed + resumes
            found = {} if wrong else normalize(given.verify, folder)
            wrong = wrong or ", ".join(name for name in sorted(set(found) | set(expected))
                                       if found.get(name) != expected.get(name))
            passed, failed = passed + (not wrong), failed + bool(wrong)
            print(f"{'FAIL' if wrong else 'pass'} suite: {kills} kills, {resumes} resumes {wrong}",
                  flush=True)
        for _ in range(given.races):
            wrong = race(given.verify, folder)
            passed, failed = passed + (not wrong), failed + bool(wrong)
            if wrong:
                print(f"FAIL race: {wrong}", flush=True)
    print(f"{killed} kills, {resumed} resumes, {given.races} races of two runs of the suite")
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
