#!/usr/bin/env python3
"""Plants small bugs and shows which test or check finds each.

    mutants.py check                      do all curated mutants apply, and is every room there?
    mutants.py run [--only GLOB]          try curated mutants
    mutants.py run --operators N          try N mutants made by exchanging operators

See README.md beside this file. Exit status: 0 all is well; 1 a mutant that is not equivalent
survives and the score is below what is required, or one declared equivalent is not; 2 bad usage.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import queue
import subprocess
import sys
import time

import operators
import table
import trial
from mutant_files import FEWEST, Fault, ROOMS, ROOT, all_curated

ASKED = 95.0  # percent


def say(text):
    print(text, flush=True)


def check(_):
    mutants, stale = all_curated(), []
    for mutant in mutants:
        done = subprocess.run(["git", "apply", "--check", "-"], cwd=ROOT, input=mutant.patch,
                              text=True, stderr=subprocess.PIPE, check=False)
        if done.returncode != 0:
            stale.append(f"{mutant.name}: does not apply: {done.stderr.strip()}")
    if stale:
        raise Fault("\n".join(stale))
    missing = [room for room in ROOMS if room not in {m.room for m in mutants}]
    if missing or len(mutants) < FEWEST:
        raise Fault(f"{len(mutants)} mutants, none in {missing or 'no room'}; allowed: "
                    f"{FEWEST} or more, in every room")
    say(f"{len(mutants)} mutants apply, in {len(ROOMS)} rooms")
    return 0


def chosen(arguments):
    if arguments.operators == 0:
        return all_curated(arguments.only)
    paths = [str(p.relative_to(ROOT)) for p in ROOT.glob(arguments.files)
             if p.suffix in (".c", ".h")]
    sample, places = operators.sample(ROOT, paths, arguments.operators, arguments.seed)
    if not sample:
        raise Fault(f"--files {arguments.files!r}: no source with a place for a mutant")
    say(f"{len(sample)} of {places} places in {len(paths)} files, seed {arguments.seed}")
    return sample


def revision_of_sources():
    return subprocess.run(["git", "describe", "--always", "--dirty", "--abbrev=12"], cwd=ROOT,
                          text=True, stdout=subprocess.PIPE, check=False).stdout.strip()


def already_tried(path, mutants, revision):
    """Results of an interrupted run: of the same sources, of mutants as they are now. Its last line
    may have been cut."""
    if not path.exists():
        return []
    patches = {m.name: m.patch for m in mutants}
    results = []
    for line in path.read_text(encoding="utf-8").splitlines():
        try:
            result = json.loads(line)
        except ValueError:
            continue
        if result["revision"] == revision and patches.get(result["name"]) == result["patch"]:
            results.append(result)
    return results


def try_all(arguments, mutants, log, revision):
    """Yields results as they come."""
    folder = arguments.output
    baseline = trial.Baseline(folder / "unchanged", arguments.jobs, say)
    say(f"unchanged: {len(baseline.suite_seconds)} suites, {baseline.check_count} checks")
    for number, (suites, pairs) in enumerate(baseline.stages()[1:], 1):  # first: a mutant's own
        say(f"stage {number}: {len(suites)} suites, {len(pairs)} variants, "
            f"{sum(baseline.suite_seconds[s] for s in suites):.0f} + "
            f"{sum(baseline.variant_seconds[p] for p in pairs):.0f} s")
    benches = queue.Queue()
    for k in range(arguments.jobs):
        benches.put(trial.Bench(baseline, folder / f"bench-{k}"))

    def attempt(mutant):
        bench = benches.get()
        try:
            return bench.attempt(mutant, arguments.thorough)
        finally:
            benches.put(bench)

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool, log.open("a") as lines:
        for done in concurrent.futures.as_completed([pool.submit(attempt, m) for m in mutants]):
            result = {**done.result(), "revision": revision}
            lines.write(json.dumps(result) + "\n")
            lines.flush()
            yield result


def report(result, number, count):
    killers = ", ".join(sorted(table.columns_of(result))[:6])
    say(f"{number:4}/{count} {result['outcome']:10} {result['seconds']:4.0f} s  "
        f"{result['name']}: {killers or result['what']}")


def verdict(results):
    wrong = [r["name"] for r in results if r["equivalent"] and r["outcome"] == "killed"]
    unbuilt = [r["name"] for r in results if r["outcome"] == "not-built" and r["kind"] != "operator"]
    survivors = [r["name"] for r in results if r["outcome"] == "survived"]
    reached = table.score(results)
    for what, names in (("survived", survivors), ("declared equivalent, and killed", wrong),
                        ("not built", unbuilt)):
        if names:
            say(f"{what}: {', '.join(names)}")
    say(f"score {reached:.1f} %; required {ASKED:g} %")
    return 1 if wrong or unbuilt or reached < ASKED else 0


def run(arguments):
    mutants = chosen(arguments)
    arguments.output.mkdir(parents=True, exist_ok=True)
    log = arguments.output / "results.jsonl"
    if not arguments.resume:
        log.unlink(missing_ok=True)
    start = time.monotonic()
    revision = revision_of_sources()
    results = already_tried(log, mutants, revision)
    say(f"{len(results)} of {len(mutants)} have been tried")
    names = {r["name"] for r in results}
    left = [m for m in mutants if m.name not in names]
    if left:
        for result in try_all(arguments, left, log, revision):
            results.append(result)
            report(result, len(results), len(mutants))
    about = {"revision": revision, "seconds": time.monotonic() - start, "jobs": arguments.jobs,
             "set": "operators" if arguments.operators else "curated", "seed": arguments.seed}
    table.write_all(arguments.output, about, results)
    say(f"{arguments.output}/mutants.md")
    return verdict(results)


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("check").set_defaults(run=check)
    runs = commands.add_parser("run")
    runs.set_defaults(run=run)
    runs.add_argument("--only", default="*", metavar="GLOB", help="names of curated mutants")
    runs.add_argument("--operators", type=int, default=0, metavar="N", help="how many of those")
    runs.add_argument("--files", default="solver/**/*", metavar="GLOB", help="where operators are")
    runs.add_argument("--seed", type=int, default=1, help="of the sample of operators")
    runs.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N")
    runs.add_argument("--thorough", action="store_true",
                      help="all tests and checks for each, also after it is found")
    runs.add_argument("--output", type=pathlib.Path, default=ROOT / "build/mutants", metavar="DIR")
    runs.add_argument("--resume", action="store_true", help="keep what an interrupted run has found")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    try:
        return arguments.run(arguments)
    except Fault as fault:
        print(f"mutants: {fault}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
