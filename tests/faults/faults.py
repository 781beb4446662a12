#!/usr/bin/python3
"""Each call that concerns a file fails once: `make test-faults`.

    faults.py --programs FOLDER [--stride N] [--only SCENARIO] [--jobs N]

FOLDER has programs of `make VARIANT=faults`. Each scenario (scenarios.py) is a command. It is run
without faults, then again and again: each time one call is interrupted, or reads or writes half
(both must change nothing at all), or fails with ENOSPC or EIO, or all calls from one on do. Then the
command must end as promised (judge.py): with exit status 4 and a message that names the file and
the reason, nothing half-written under a final name; and the command that mends it must lead to the
files that there are without faults. Of all calls, every N-th is taken and the
first of each name. The order of the calls is checked too: what is synced before it is renamed.

Each run makes the same calls, but a program of the suite and the suite that has started it make
theirs beside each other: a number may be another call's in the next run, one that cannot have the
fault. The run without a fault shows which number the call has had, and that is tried next. A fault
that never happens is skipped; more of these than one in a hundred of a scenario are a failure.

The last line is `N passed, N failed, N skipped`: faults, and scenarios for their order.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import collections
import concurrent.futures
import pathlib
import shutil
import sys
import tempfile

import calls
import judge
import scenarios

KINDS = ("EINTR", "short", "ENOSPC", "EIO")
LASTING = ("ENOSPC", "EIO")  # from one call on
TIMES = 5  # that a fault is tried which did not happen
SKIPPED_MOST = 0.01  # of the faults of a scenario
FEWER = 3  # of these faults than of single ones


class Trial:
    """One scenario: what it does without faults, and with them."""

    def __init__(self, scenario, scratch):
        self.scenario, self.scratch = scenario, scratch / scenario.name
        self.scratch.mkdir()
        self.start = self.scratch / "start"
        self.start.mkdir()
        scenario.prepare(self.start)
        self.before = judge.files(self.start)
        self.plain = calls.run(scenario.command, self.fresh("plain"))
        again = calls.run(scenario.command, self.fresh("again"))
        self.judge = judge.Judge(self.plain, judge.files(self.scratch / "plain"),
                                 judge.files(self.scratch / "again"), scenario.timed)
        same = self.sites(again) == self.sites(self.plain)
        self.wrong = None if same else "two runs make different calls"
        if self.plain.status not in (0, 1):
            self.wrong = f"exit {self.plain.status}: {self.plain.errors.strip()}"
        self.wrong = self.wrong or calls.disorder(self.plain.calls)

    @staticmethod
    def sites(outcome):
        """How many calls there are of each site; programs of the suite run beside it."""
        return collections.Counter(call.site() for call in outcome.calls)

    def fresh(self, name):
        """A folder as it is before the command."""
        folder = self.scratch / name
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.start, folder, symlinks=True)
        return folder

    def faults(self, stride):
        """The faults to try: kind, number of the call, whether it lasts."""
        chosen = []
        for kind in KINDS:
            numbers = calls.choose(self.plain.calls, kind, stride)
            chosen += [(kind, number, False) for number in numbers]
            if kind in LASTING:
                chosen += [(kind, number, True) for number in numbers[::FEWER]]
        return chosen

    def site(self, number):
        """Of the call with that number."""
        return self.plain.calls[number - 1].site()

    def number_in(self, outcome, number):
        """That a call had in another run: the same one of those of its site."""
        site = self.site(number)
        before = sum(call.site() == site for call in self.plain.calls[:number - 1])
        same = [call.number for call in outcome.calls if call.site() == site]
        return same[before] if before < len(same) else number

    def one(self, kind, number, lasting):
        """Runs with a fault, mends it; returns the site that had it, None if none had, and what is
        wrong, or None."""
        tried = number
        for _ in range(TIMES):
            folder = self.fresh(f"{kind}-{number}{'-on' if lasting else ''}")
            outcome = calls.run(self.scenario.command, folder,
                                f"{kind}@{tried}{'+' if lasting else ''}")
            if outcome.fired():
                break
            tried = self.number_in(outcome, number)
        else:
            shutil.rmtree(folder)
            return None, None
        wrong = self.judge.of_fault(outcome, kind, judge.files(folder), self.before, lasting)
        if wrong is None and kind not in calls.HARMLESS:
            mended = calls.run(self.scenario.mend(folder), folder)
            wrong = self.judge.unlike(mended, judge.files(folder))
            wrong = wrong and f"mended afterwards: {wrong}"
        if wrong is None:
            shutil.rmtree(folder)
        return outcome.fired()[0].site(), wrong


def try_all(trial, stride, jobs):
    """Tries the faults of a scenario; returns counts by site, what is wrong, what was skipped."""
    counts, wrong, skipped = collections.Counter(), [], []
    name = trial.scenario.name
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        chosen = trial.faults(stride)
        for (kind, number, lasting), (site, one) in zip(
                chosen, pool.map(lambda f: trial.one(*f), chosen)):
            fault = f"{kind}{' from' if lasting else ' at'} call {number}{' on' if lasting else ''}"
            if site is None:
                skipped.append(f"skip {name}: {fault}, {trial.site(number)}: it did not happen in "
                               f"{TIMES} runs, in which programs beside each other took turns "
                               "otherwise")
                continue
            counts[site] += 1
            if one is not None:
                wrong.append(f"FAIL {name}: {fault}, {site}: {one}")
    if len(skipped) > max(1, SKIPPED_MOST * len(chosen)):
        wrong.append(f"FAIL {name}: {len(skipped)} of {len(chosen)} faults did not happen")
    return counts, wrong, skipped


def all_scenarios(programs):
    """Those of the programs that are there."""
    return (scenarios.of_solver(str(programs / "mpm")) +
            scenarios.of_suite(str(programs / "mpm-verify"), str(programs / "mpm")) +
            scenarios.of_benchmarks(str(programs / "mpm-bench")))


def main():
    """Exit status: 0 all as it should be; 1 something is not; 2 bad usage."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", required=True, type=pathlib.Path)
    parser.add_argument("--stride", type=int, default=1)
    parser.add_argument("--only", action="append")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for what failed")
    given = parser.parse_args()
    memory = pathlib.Path("/dev/shm")  # where a sync costs nothing
    passed, failed, left, total = 0, 0, 0, collections.Counter()
    with tempfile.TemporaryDirectory(prefix="mpm-faults-",
                                     dir=memory if memory.is_dir() else None) as scratch:
        for scenario in all_scenarios(given.programs.resolve()):
            if given.only and scenario.name not in given.only:
                continue
            trial = Trial(scenario, pathlib.Path(scratch))
            counts, wrong, skipped = \
                (collections.Counter(), [f"FAIL {scenario.name}: {trial.wrong}"], []) \
                if trial.wrong else try_all(trial, given.stride * scenario.weight, given.jobs)
            faults = sum(counts.values())
            print("\n".join([*wrong, *skipped, f"{scenario.name}: {len(trial.plain.calls)} calls, "
                             f"{faults} faults at {len(counts)} sites, {len(wrong)} wrong, "
                             f"{len(skipped)} skipped"]), flush=True)
            passed += faults + 1 - len(wrong)
            failed += len(wrong)
            left += len(skipped)
            total += counts
        if given.keep is not None:
            shutil.copytree(scratch, given.keep, dirs_exist_ok=True)
    for site, count in sorted(total.items()):
        print(f"{count:6} {site}")
    print(f"{sum(total.values())} faults at {len(total)} sites")
    print(f"{passed} passed, {failed} failed, {left} skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
