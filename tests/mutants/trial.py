"""A trial: builds a mutant in a folder of its own, and runs unit tests and catalogue against it.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import json
import math
import os
import re
import resource
import shutil
import subprocess
import time

from mutant_files import Fault, ROOT

# What a mutant meets first: suites of unit tests, and variants of the catalogue, of up to so many
# seconds. Only one that is still alive meets what takes longer.
STAGES = ((0.2, 0.01), (0.6, 0.03), (1.5, 0.03), (3.0, 0.03), (3.0, 0.2), (math.inf, 0.2),
          (math.inf, 1.0), (math.inf, math.inf))
SOUND = ("pass", "skip", "expected-fail")
FAILED_TEST = re.compile(r"^\S+:\d+:[FE]:[^:]*:([^:]+):")


def inherited():
    """Without what a make that called has put there: trials are builds of their own. As many trials
    run side by side as there are processors: threads must not spin while they wait."""
    kept = {k: v for k, v in os.environ.items() if k not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    return {**kept, "OMP_WAIT_POLICY": "passive"}


def command(folder, words, limit, environment=None):
    """Output and status of a command; None for the status of one that was stopped at its limit."""
    try:
        done = subprocess.run(words, cwd=folder, timeout=limit, check=False, text=True,
                              errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env={**inherited(), **(environment or {})})
    except subprocess.TimeoutExpired:
        return "", None
    return done.stdout, done.returncode


def copy_sources(folder):
    names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, text=True,
                           stdout=subprocess.PIPE).stdout.split("\0")
    for name in filter(None, names):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)


def suites(folder):
    """By the names that Check knows them by."""
    texts = [path.read_text(encoding="utf-8") for path in sorted((folder / "tests").rglob("test_*.c"))]
    return [name for text in texts for name in re.findall(r'suite_create\("([\w ]+)"\)', text)]


def build(folder, jobs, limit):
    """The end of make's output if it failed, else ''. Warnings do not count: a mutant may leave
    something unused."""
    said, status = command(folder, ["make", f"-j{jobs}", "WERROR="], limit)
    if status == 0:
        said, status = command(folder, ["make", f"-j{jobs}", "WERROR=",
                                        "build/release/bin/mpm-tests"], limit)
    return "" if status == 0 else said[-2000:] or "stopped at its time limit"


def run_suite(folder, suite, limit):
    """Names of the tests that failed, or a word for a suite that did not end."""
    binaries = folder / "build/release/bin"
    said, status = command(folder, [binaries / "mpm-tests"], limit,
                           {"CK_RUN_SUITE": suite, "MPM_BIN": str(binaries),
                            "CK_DEFAULT_TIMEOUT": str(int(limit / 2))})
    if status is None:
        return ["(did not end)"]
    failed = sorted({m[1] for m in map(FAILED_TEST.match, said.splitlines()) if m})
    return failed or ([] if status == 0 else [f"(exit status {status})"])


def run_catalogue(folder, limit, jobs=1, only=None):
    """The lines of the checks, or a word for a run that left none."""
    output = folder / "build/reports/mutant"
    shutil.rmtree(output, ignore_errors=True)
    words = ["build/release/bin/mpm-verify", "run", "--jobs", str(jobs), "--output", str(output)]
    if only is not None:
        (folder / "build/only").write_text("".join(f"{pair}\n" for pair in only), encoding="utf-8")
        words += ["--only", "build/only"]
    said, status = command(folder, words, limit)
    try:
        lines = (output / "checks.jsonl").read_text(encoding="utf-8").splitlines()
        return [line for line in map(json.loads, lines) if line["kind"] == "check"], ""
    except (OSError, ValueError, KeyError):
        said = said.replace(f"{folder.resolve()}/", "").strip()[-200:]
        return [], "(did not end)" if status is None else f"(exit status {status}: {said})"


def processor_seconds():
    """Of the commands that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def words(*names):
    return {word for name in names for word in re.split(r"[\W_]+", name.lower()) if len(word) > 3}


def related(mutant, names):
    """The suites with a word of the mutant's name or file in their names, or the beginning of one."""
    own = words(mutant.name, mutant.path.rsplit("/", 1)[-1].split(".")[0])
    return [name for name in names if any(one.startswith(other) or other.startswith(one)
                                          for one in own for other in words(name))]


class Baseline:
    """The unchanged sources, built and run: what is green, and how long it takes."""

    def __init__(self, folder, jobs, say):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        copy_sources(folder)
        say("building the unchanged sources")
        fault = build(folder, jobs, 1800)
        if fault:
            raise Fault(f"the unchanged sources do not build:\n{fault}")
        self.suite_seconds = {}
        for suite in suites(folder):
            start = processor_seconds()
            failed = run_suite(folder, suite, 600)
            self.suite_seconds[suite] = processor_seconds() - start
            if failed:
                raise Fault(f"unchanged, suite {suite} fails: {', '.join(failed)}")
        say("running the catalogue")
        start = processor_seconds()
        checks, fault = run_catalogue(folder, 1800, jobs)
        used = processor_seconds() - start
        red = [c for c in checks if c["status"] not in SOUND]
        if fault or red:
            raise Fault(f"unchanged, the catalogue is red: {fault or red[0]}")
        self.check_count = len(checks)
        passed = {f"{c['case']}/{c['variant']}": c["seconds"] for c in checks}
        share = used / sum(passed.values())  # of the time that passed: the machine may be busy
        self.variant_seconds = {pair: share * seconds for pair, seconds in passed.items()}

    def stages(self, first=()):
        """Suites and CASE/VARIANTs of each stage, all of them once: those suites, then by time."""
        rest = {name: of for name, of in self.suite_seconds.items() if name not in first}
        limits = (0.0, *(limit for limit, _ in STAGES)), (0.0, *(limit for _, limit in STAGES))
        parts = [[[name for name, of in seconds.items() if low <= of < high]
                  for low, high in zip(limit, limit[1:])]
                 for seconds, limit in zip((rest, self.variant_seconds), limits)]
        return [(list(first), []), *zip(*parts)]


class Bench:
    """A copy of the baseline in which one mutant after the other is tried."""

    def __init__(self, baseline, folder):
        self.baseline = baseline
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(baseline.folder, folder)

    def restore(self):
        """Sources, objects and programs of the baseline, with their times, so that make is content."""
        for part in ("solver", "verification", "build/release"):
            for original in (self.baseline.folder / part).rglob("*"):
                copy = self.folder / original.relative_to(self.baseline.folder)
                if original.is_file() and self.differs(original, copy):
                    shutil.copy2(original, copy)

    @staticmethod
    def differs(original, copy):
        if not copy.exists():
            return True
        one, other = original.stat(), copy.stat()
        return one.st_mtime_ns != other.st_mtime_ns or one.st_size != other.st_size

    @staticmethod
    def limit(seconds):
        """Far from what a busy machine makes of it."""
        return 60.0 + 10.0 * seconds

    def suites_kill(self, names):
        killed = []
        for suite in names:
            limit = self.limit(self.baseline.suite_seconds[suite])
            killed += [f"{suite}/{test}" for test in run_suite(self.folder, suite, limit)]
        return killed

    def catalogue_kills(self, only):
        if not only:
            return []
        seconds = sum(self.baseline.variant_seconds[pair] for pair in only)
        checks, fault = run_catalogue(self.folder, self.limit(seconds), only=only)
        if fault:
            return [f"catalogue {fault}"]
        return [f"{c['case']}/{c['check']}[{c['variant']}]" for c in checks
                if c["status"] not in SOUND]

    def attempt(self, mutant, thorough):
        """What became of the mutant, as a dictionary. A thorough trial goes on after the first stage
        that finds it."""
        start = time.monotonic()
        patch = self.folder / "build/mutant.patch"
        patch.write_text(mutant.patch, encoding="utf-8")
        # the folder may lie within the repository, and is not of it
        said, status = command(self.folder, ["git", "apply", str(patch.resolve())], 60,
                               {"GIT_CEILING_DIRECTORIES": str(self.folder.resolve().parent)})
        if status != 0:
            raise Fault(f"{mutant.name}: the patch does not apply: {said}")
        result = {"name": mutant.name, "room": mutant.room, "kind": mutant.kind,
                  "what": mutant.what, "file": mutant.path, "patch": mutant.patch,
                  "equivalent": mutant.equivalent, "tests": [], "checks": [], "whole": False}
        fault = build(self.folder, 1, 1800)
        if fault:
            result["outcome"], result["fault"] = "not-built", fault
        else:
            self.try_all(result, related(mutant, self.baseline.suite_seconds), thorough)
            killed = result["tests"] or result["checks"]
            result["outcome"] = ("killed" if killed else
                                 "equivalent" if mutant.equivalent else "survived")
        self.restore()
        result["seconds"] = time.monotonic() - start
        return result

    def try_all(self, result, first, thorough):
        stages = self.baseline.stages(first)
        for number, (names, pairs) in enumerate(stages, 1):
            result["tests"] += self.suites_kill(names)
            result["checks"] += self.catalogue_kills(pairs)
            result["whole"] = number == len(stages)
            if not thorough and (result["tests"] or result["checks"]):
                break
