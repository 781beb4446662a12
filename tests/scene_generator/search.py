#!/usr/bin/python3
"""Random scenes against invariants: `make test-scenes`.

    search.py --programs DIR [--seconds S | --scenes N] [--seed N] [--jobs N] [--invariant NAME]...
              [--situation NAME]... [--again N] [--shrink S] [--output DIR] [--fresh] [SCENE...]

Judges the regression scenes first (folder regression/), then draws new ones until the time is over,
or until there are as many as --scenes: these follow from the seed alone, whatever the machine and
the jobs. A scene that breaks an invariant is shrunk and written to the output folder; the invariant
is not evaluated again, unless --again allows so many finds. With SCENE: judges those scenes alone.
Exit status: 0 all invariants hold; 1 one does not; 2 bad usage. The last line is `N passed, N
failed, N skipped`: each invariant counts as one, and so does each regression scene.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import collections
import multiprocessing
import pathlib
import queue
import random
import re
import resource
import sys
import time
import traceback

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis.errors import HypothesisException

import draw
import invariants
import meaning
import run
from case import Case, Discarded, Violation
from plastic import is_plastic, plastic_work
from schema import read_schema

HERE = pathlib.Path(__file__).resolve().parent
TURNS = ["any", "plastic", "touching", "coupled", "exchanging", "any", "heated", "pressed", "plastic", "coupled",
         "touching", "exchanging", "any", "loaded", "heated", "plastic", "coupled", "any", "touching"]  # situations
BATCH = 20  # scenes drawn from one seed
AT_ONCE = 3  # of the invariants that cost runs of their own, judged on one scene
DISCARDED_MOST = 0.3  # part of the scenes drawn
YIELDS_LEAST = 0.4  # part of the scenes with plastic laws
DRAWN_LEAST = 25  # times after which a key of which no scene has been valid is a fault


def judge(name, case):
    """Does the invariant hold? False where the case is none for it."""
    try:
        return invariants.ALL[name](case)
    except run.Late as late:
        raise Violation(str(late)) from late


class Search:
    """One worker: takes batches of scenes until there are no more, draws and judges them. What it judges
    of a batch depends on the batch's seed alone, but for invariants that another batch has broken."""

    def __init__(self, arguments, start, shared):
        self.arguments = arguments
        self.runner = run.Runner(arguments.programs)
        self.schema, _ = read_schema(self.runner.mpm)
        self.start = start
        self.retired, self.messages, self.next_batch = shared
        self.judged = collections.Counter()
        self.of_batch = collections.Counter()  # invariants judged on the scenes of this batch
        self.number = 0  # the seed of this batch
        self.drawn, self.valid = collections.Counter(), collections.Counter()
        self.yielding = collections.Counter()  # valid scenes with a plastic law, and those that yield
        self.scenes = self.discarded = 0
        self.focus = None  # the invariant that a scene of this batch has broken
        self.found = None  # (length, text, message) of the smallest such scene
        self.shrink_until = 0.0

    def active(self, name):
        """Is the invariant selected, and not retired?"""
        asked = not self.arguments.invariant or name in self.arguments.invariant
        index = list(invariants.ALL).index(name)
        return asked and self.retired[index] < self.arguments.again

    @property
    def over(self):
        """Is the time over?"""
        return self.arguments.count is None and \
            time.monotonic() - self.start > self.arguments.seconds

    def take_batch(self):
        """The next batch that no worker has taken; None where there is none."""
        with self.next_batch.get_lock():
            batch = self.next_batch.value
            self.next_batch.value += 1
        wanted = self.arguments.count
        return None if self.over or wanted is not None and batch * BATCH >= wanted else batch

    def work(self):
        """Batches until there are no more."""
        names = [name for name in TURNS
                 if not self.arguments.situation or name in self.arguments.situation]
        try:
            while (batch := self.take_batch()) is not None:
                self.batch(names[batch % len(names)], self.arguments.seed + batch)
        except Exception:  # a fault of this program: the parent reports it
            self.messages.put(("fault", traceback.format_exc()))
        finally:
            self.runner.close()
            self.messages.put(("end", self.judged, self.drawn, self.valid, self.yielding, self.scenes,
                               self.discarded, self.runner.runs))

    def effort(self):
        """What has been done so far."""
        used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        return (f"after {time.monotonic() - self.start:.1f} s "
                f"({sum(u.ru_utime + u.ru_stime for u in used):.1f} s of a processor), "
                f"scene {self.scenes} of its worker")

    def batch(self, situation, number):
        """Some scenes from one seed; the first that breaks an invariant is shrunk."""
        self.focus = self.found = None
        self.of_batch.clear()
        self.number = number

        @seed(number)
        @settings(max_examples=BATCH, deadline=None, database=None,
                  phases=[Phase.generate, Phase.shrink], print_blob=False,
                  suppress_health_check=list(HealthCheck), report_multiple_bugs=False)
        @given(draw.scenes(self.schema, meaning, situation))
        def holds(scene):
            if self.focus is not None:
                self.again(scene)
            elif not self.over:
                self.first(scene)

        try:
            holds()
        except (Violation, HypothesisException):
            if self.found is None:
                raise
        if self.found is not None:
            _, text, message, effort, first = self.found
            self.messages.put(("found", self.focus, text, message, effort, number, situation, first))

    def first(self, scene):
        """Judges a new scene: by what costs nothing more, and by those invariants of the others
        that have judged least of this batch so far, from another one on in each batch."""
        self.scenes += 1
        keys = draw.keys_of(self.schema, scene)
        self.drawn.update(keys)
        case = Case(self.runner, self.schema, scene)
        always = [function.__name__ for function in invariants.ALWAYS]
        others = [function.__name__ for function in invariants.SOMETIMES]
        first = self.number * AT_ONCE % len(others)
        others = sorted(others[first:] + others[:first], key=lambda name: self.of_batch[name])
        asked = 0
        for name in always + others:
            if not self.active(name) and name != always[0] or asked == AT_ONCE:
                continue
            try:
                if not judge(name, case):
                    continue
            except Discarded:
                self.discarded += 1
                return
            except Violation as violation:
                self.judged[name] += 1
                if not self.active(name):
                    continue
                index = list(invariants.ALL).index(name)
                self.retired[index] += 1
                self.focus = name
                text = run.to_text(scene)
                self.found = (len(text), text, str(violation), self.effort(), text)
                self.shrink_until = time.monotonic() + self.arguments.shrink
                raise
            self.judged[name] += 1
            self.of_batch[name] += 1
            asked += name in others
        self.valid.update(keys)
        work = plastic_work(case.base.history) if is_plastic(case) else None
        if work is not None:
            self.yielding.update(plastic=1, yields=int(work[-1] > 0))

    def again(self, scene):
        """Does a smaller scene break the invariant as well?"""
        if time.monotonic() > self.shrink_until:
            return
        try:
            case = Case(self.runner, self.schema, scene)
            if case.base.status != 2 or self.focus == invariants.ALWAYS[0].__name__:
                judge(self.focus, case)
        except Discarded:
            return
        except Violation as violation:
            text = run.to_text(scene)
            if len(text) <= self.found[0]:
                self.found = (len(text), text, str(violation), *self.found[3:])
            raise


def named_in(text):
    """The invariants that the comment of a scene names: they must judge it."""
    comment = " ".join(line for line in text.splitlines() if line.startswith("#"))
    return [name for name in invariants.ALL if re.search(rf"\b{name}\b", comment)]


def judge_file(arguments, path):
    """Faults of one scene: (invariant, message)."""
    runner = run.Runner(arguments.programs)
    faults = []
    try:
        schema, _ = read_schema(runner.mpm)
        text = path.read_text(encoding="utf-8")
        case, named = Case(runner, schema, run.from_text(text)), named_in(text)
        for name in invariants.ALL:
            if arguments.invariant and name not in arguments.invariant:
                continue
            try:
                if not judge(name, case) and name in named:
                    faults.append((name, "does not judge this scene, though its comment names it"))
            except Discarded as discarded:
                faults.append((name, f"mpm check refuses it: {discarded}"))
                break
            except Violation as violation:
                faults.append((name, str(violation)))
    finally:
        runner.close()
    return faults


def judge_files(arguments, paths):
    """Judges scenes one after the other; how many hold, and how many do not."""
    failed = 0
    with multiprocessing.Pool(arguments.jobs) as pool:
        for path, faults in zip(paths, pool.starmap(judge_file,
                                                    [(arguments, path) for path in paths], 1)):
            for name, message in faults:
                print(f"FAIL {path.name}: {name}: {message}")
            failed += bool(faults)
    return len(paths) - failed, failed


def report_found(arguments, message, count):
    """Writes a scene that breaks an invariant and reports it."""
    _, name, text, what, effort, number, situation, first = message
    arguments.output.mkdir(parents=True, exist_ok=True)
    path = arguments.output / f"{name}-{count}.yaml"
    head = f"# Invariant: {name}\n# {what}\n# Found {effort}, seed {number}, situation {situation}.\n"
    path.write_text(head + text, encoding="utf-8")
    path.with_suffix(".drawn").write_text(head + first, encoding="utf-8")
    print(f"FAIL {name}: {effort} (seed {number}, {situation}): {what}\n     {path}", flush=True)


def search(arguments):
    """Draws scenes in parallel; what the workers counted, and how many finds of each invariant."""
    start = time.monotonic()
    retired = multiprocessing.Array("i", len(invariants.ALL))
    messages = multiprocessing.Queue()
    shared = (retired, messages, multiprocessing.Value("i", 0))
    workers = [multiprocessing.Process(target=lambda: Search(arguments, start, shared).work())
               for _ in range(arguments.jobs)]
    for worker in workers:
        worker.start()
    totals, finds, faults = None, collections.Counter(), 0
    left = len(workers)
    while left > 0:
        try:
            message = messages.get(timeout=5)
        except queue.Empty:
            if not any(worker.is_alive() for worker in workers):
                faults += 1
                break
            continue
        if message[0] == "found":
            finds[message[1]] += 1
            report_found(arguments, message, finds[message[1]])
        elif message[0] == "fault":
            faults += 1
            print(f"FAIL search: {message[1]}")
        else:
            left -= 1
            totals = message[1:] if totals is None else [a + b for a, b in zip(totals, message[1:])]
    for worker in workers:
        worker.join()
    return totals, finds, faults, time.monotonic() - start


def summarize(arguments, keys, outcome):
    """Prints what was judged; passed, failed and skipped invariants."""
    (judged, drawn, valid, yielding, scenes, discarded, runs), finds, faults, seconds = outcome
    names = [name for name in invariants.ALL
             if not arguments.invariant or name in arguments.invariant]
    passed = failed = skipped = 0
    for name in names:
        verdict = "FAIL" if finds[name] else "skip" if not judged[name] else "pass"
        passed, failed, skipped = (passed + (verdict == "pass"), failed + (verdict == "FAIL"),
                                   skipped + (verdict == "skip"))
        print(f"{verdict} {name}: {judged[name]} scenes")
    rate = discarded / max(1, scenes)
    print(f"{scenes} scenes drawn in {seconds:.0f} s, {discarded} refused by mpm check "
          f"({100 * rate:.1f} %), {runs} runs")
    if scenes >= 100 and rate > DISCARDED_MOST:
        print(f"FAIL search: more than {100 * DISCARDED_MOST:.0f} % of the scenes are refused")
        failed += 1
    print(f"{yielding['yields']} of {yielding['plastic']} scenes with plastic laws yield")
    if yielding["plastic"] >= 25 and yielding["yields"] < YIELDS_LEAST * yielding["plastic"]:
        print(f"FAIL search: fewer than {100 * YIELDS_LEAST:.0f} % of these yield")
        failed += 1
    wanted = draw.wanted_of(keys, meaning)
    never = [path for path in wanted if not valid[path]]
    print(f"{len(wanted) - len(never)} of {len(wanted)} keys and choices in valid scenes; "
          f"{len(meaning.LEFT_OUT)} keys left out on purpose"
          f"{'; none has ' + ', '.join(never) if never else ''}")
    for path in drawn:
        if drawn[path] >= DRAWN_LEAST and not valid[path] and not finds:
            print(f"FAIL search: {path} was drawn {drawn[path]} times, and no scene with it is valid")
            failed += 1
    return passed, failed + faults, skipped


def parse():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", metavar="SCENE", nargs="*", type=pathlib.Path)
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--scenes", type=int, dest="count",
                        help="draw so many scenes, in whole batches, however long that takes")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10 ** 6))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--invariant", action="append", choices=list(invariants.ALL))
    parser.add_argument("--situation", action="append", choices=sorted(set(TURNS)))
    parser.add_argument("--again", type=int, default=1)
    parser.add_argument("--shrink", type=float, default=30,
                        help="seconds for one scene, after which the smallest so far is taken (30)")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/scenes"))
    parser.add_argument("--fresh", action="store_true", help="leave the regression scenes out")
    arguments = parser.parse_args()
    arguments.programs = arguments.programs.resolve()
    return arguments


def main():
    """Regression scenes, then new ones."""
    arguments = parse()
    schema, keys = read_schema(str(arguments.programs / "mpm"))
    gaps = draw.uncovered(keys, meaning) or \
        [f"{path} is never drawn" for path in draw.never_drawn(schema, keys, meaning)]
    for gap in gaps:
        print(f"FAIL search: {gap}")
    regression = arguments.scenes or \
        ([] if arguments.fresh else sorted((HERE / "regression").glob("*.yaml")))
    passed, failed = judge_files(arguments, regression) if regression else (0, 0)
    failed += len(gaps)
    skipped = 0
    if regression:
        print(f"{passed} of {len(regression)} regression scenes hold", flush=True)
    if not arguments.scenes and not gaps:
        print(f"seed {arguments.seed}", flush=True)
        more = summarize(arguments, keys, search(arguments))
        passed, failed, skipped = passed + more[0], failed + more[1], skipped + more[2]
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
