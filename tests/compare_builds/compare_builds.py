#!/usr/bin/python3
"""Compares the results of two builds bit by bit.

    compare_builds.py OLD NEW [--part suite|scenes|random]... [--case GLOB] [--steps N] [--random N]
                      [--seed N] [--jobs N] [--output DIR]

OLD and NEW are folders with the programs `mpm` and `mpm-verify`. Three parts, all of them unless some
are selected:

suite   `mpm-verify run` with both programs: every quantity and every curve that a report shows.
        Quantities that count time or instructions are left out.
scenes  `mpm run` of each scene of the catalogue with the settings of each variant of the CI tier, of
        the regression scenes and of those of the benchmarks: every byte of histories, every dataset and
        attribute of snapshots but those that name the build. With --steps, so many steps of each.
random  `mpm run` of so many random scenes (tests/scene_generator), fast and reference kernels.

Results of OLD are stored in the output folder and used again as long as its program `mpm-verify` is the
same. Exit status: 0 the same bits; 1 a difference; 2 bad usage. The last line is
`N passed, N failed, N skipped`.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import fnmatch
import hashlib
import json
import multiprocessing
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "scene_generator"))

PARTS = ("suite", "scenes", "random")
COSTS = ("cpu_seconds", "seconds", "*instructions*", "*overhead*", "*_time")  # measured each time
BUILD = {"version", "revision", "compiler", "flags", "libraries"}  # attributes of snapshots
REFUSED = "both refuse it"
TIME_LIMIT = 600  # seconds for one run


class Differs(Exception):
    """Where two results differ."""


def require(same, text):
    """Raises Differs with the text unless `same`."""
    if not same:
        raise Differs(text)


# ---------------------------------------------------------------------------- files
def same_snapshots(old, new):
    """Every dataset and attribute of two HDF5 files, but for what names the build."""
    with h5py.File(old) as first, h5py.File(new) as second:
        names = [], []
        first.visit(names[0].append)
        second.visit(names[1].append)
        require(names[0] == names[1], f"{old.name}: other groups or datasets")
        for name in ["/"] + names[0]:
            one, other = first[name], second[name]
            require(set(one.attrs) == set(other.attrs), f"{old.name}: {name}: other attributes")
            for key in set(one.attrs) - BUILD:
                a, b = numpy.asarray(one.attrs[key]), numpy.asarray(other.attrs[key])
                require(a.dtype == b.dtype and a.tolist() == b.tolist(),
                        f"{old.name}: {name}: attribute {key}")
            if isinstance(one, h5py.Dataset):
                a, b = one[()], other[()]
                require(a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes(),
                        f"{old.name}: {name}")


def same_results(old, new):
    """Histories and snapshots of two results folders."""
    names = [sorted(path.name for path in folder.iterdir() if path.suffix in (".csv", ".hdf"))
             for folder in (old, new)]
    require(names[0] == names[1], f"files {names[0]} and {names[1]}")
    for name in names[0]:
        if name.endswith(".hdf"):
            same_snapshots(old / name, new / name)
        else:
            require((old / name).read_bytes() == (new / name).read_bytes(), name)


# ----------------------------------------------------------------------------- runs
def one_run(job):
    """Runs one scene with both programs; its name and what differs, or None."""
    name, scene, options, programs = job
    with tempfile.TemporaryDirectory(dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None) as top:
        folders, ends = [], []
        for k, program in enumerate(programs):
            folders.append(pathlib.Path(top) / str(k))
            try:
                done = subprocess.run(
                    [program, "run", scene, "--quiet", "--threads", "1", "--output", folders[k], *options],
                    capture_output=True, text=True, timeout=TIME_LIMIT, check=False)
            except subprocess.TimeoutExpired:
                return name, f"no end within {TIME_LIMIT} s"
            ends.append((done.returncode, done.stderr.replace(str(folders[k]), "")))
        if ends[0] != ends[1]:
            return name, f"exit {ends[0][0]} and {ends[1][0]}: {ends[0][1]!r} and {ends[1][1]!r}"
        if ends[0][0] not in (0, 3):
            return name, REFUSED
        try:
            same_results(*folders)
        except Differs as difference:
            return name, str(difference)
        return name, None


def variants_of(case, methods):
    """Names and settings of a case's variants of the CI tier."""
    found = [(v["name"], v.get("settings", [])) for v in case.get("variants", [])
             if v.get("tier", "ci") == "ci"]
    chosen = case.get("methods", {})

    def matches(name, key):
        return any(fnmatch.fnmatch(name, glob) for glob in chosen.get(key, []))

    found += [(m["name"], m.get("settings", [])) for m in methods
              if matches(m["name"], "names") and not matches(m["name"], "except")
              and not matches(m["name"], "full")]
    return found


def runs_of_scenes(programs, glob, steps):
    """One job for each scene of the tree and each variant's settings."""
    catalogue = ROOT / "verification" / "catalogue"
    methods = yaml.safe_load((catalogue / "methods.yaml").read_text())["methods"]
    for path in sorted(catalogue.glob("*/*/case.yaml")):
        case = yaml.safe_load(path.read_text())
        if not fnmatch.fnmatch(case["case"], glob):
            continue
        for scene in sorted(path.parent.glob("*.yaml")):
            if scene == path or "bodies" not in (yaml.safe_load(scene.read_text()) or {}):
                continue
            for variant, settings in variants_of(case, methods):
                options = [word for setting in settings + steps for word in ("--set", setting)]
                yield f"{case['case']}/{variant}/{scene.stem}", scene, options, programs
    if glob == "*":
        others = [*ROOT.glob("tests/scenes/good/*.yaml"),
                  *ROOT.glob("tests/scene_generator/regression/*.yaml"),
                  *ROOT.glob("benchmarks/scenes/*.yaml")]
        for scene in sorted(others):
            for kernels in ("auto", "reference"):
                options = ["--kernels", kernels, *(word for s in steps for word in ("--set", s))]
                if scene.parent.parent.name == "benchmarks":
                    options += ["--set", "time.steps=20"]
                yield f"{scene.parent.name}/{scene.stem}/{kernels}", scene, options, programs


def runs_of_random_scenes(programs, count, seed, folder):
    """Draws scenes as `make test-scenes` does; one job for each and each set of kernels."""
    import hypothesis

    import draw
    import meaning
    import run
    from schema import read_schema

    schema, _ = read_schema(programs[0])
    folder.mkdir(parents=True, exist_ok=True)
    scenes = []
    for situation in ("any", "pressed", "loaded"):
        share = count // 2 if situation == "any" else count // 4

        @hypothesis.seed(seed)
        @hypothesis.settings(max_examples=share, deadline=None, database=None,
                             phases=[hypothesis.Phase.generate],
                             suppress_health_check=list(hypothesis.HealthCheck))
        @hypothesis.given(draw.scenes(schema, meaning, situation))
        def note(scene):
            scenes.append(run.to_text(scene))

        note()
    for number, text in enumerate(scenes):
        path = folder / f"{number}.yaml"
        path.write_text(text)
        for kernels in ("auto", "reference"):
            yield f"random/{number}/{kernels}", path, ["--kernels", kernels], programs


def compare_runs(jobs, workers):
    """Runs all jobs; how many are the same, how many not, how many both refuse alike."""
    passed = failed = skipped = 0
    with multiprocessing.Pool(workers) as pool:
        for name, difference in pool.imap_unordered(one_run, jobs):
            if difference == REFUSED:
                skipped += 1
            elif difference is None:
                passed += 1
            else:
                print(f"FAIL {name}: {difference}", flush=True)
                failed += 1
    return passed, failed, skipped


# ---------------------------------------------------------------------------- suite
def run_suite(programs, output, arguments):
    """The catalogue with one build; results there are used again if it is the same program."""
    program = programs / "mpm-verify"
    print_of = hashlib.sha256(program.read_bytes()).hexdigest() + arguments.case
    mark = output / "program"
    if mark.exists() and mark.read_text() == print_of:
        return
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    with open(output / "log", "w", encoding="utf-8") as log:
        subprocess.run([program, "run", "--catalogue", ROOT / "verification" / "catalogue",
                        "--case", arguments.case, "--jobs", str(arguments.jobs),
                        "--output", output / "report"], stdout=log, stderr=log, check=False)
    mark.write_text(print_of)


def measurements_of(report):
    """Quantities of a report by case, variant and name; costs left out."""
    found = {}
    for line in (report / "measurements.jsonl").read_text().splitlines():
        row = json.loads(line, parse_constant=str)
        if row["kind"] == "measurement" and not any(fnmatch.fnmatch(row["quantity"], glob)
                                                    for glob in COSTS):
            found[row["case"], row["variant"], row["quantity"]] = (row["value"], row["reason"])
    return found


def compare_suite(arguments):
    """Quantities and curves of both builds' reports."""
    reports = []
    for name, programs in (("old", arguments.old), ("new", arguments.new)):
        run_suite(programs, arguments.output / name, arguments)
        reports.append(arguments.output / name / "report")
    old, new = map(measurements_of, reports)
    passed = failed = 0
    for key in sorted(old.keys() | new.keys()):
        same = repr(old.get(key)) == repr(new.get(key))
        if not same:
            print(f"FAIL {'/'.join(key)}: {old.get(key)} and {new.get(key)}")
        passed, failed = passed + same, failed + (not same)
    curves = [{path.relative_to(report): path for path in (report / "cases").rglob("data-*.dat")
               if not path.name.startswith("data-comparison")}  # these may be drawn over time
              for report in reports]
    for name in sorted(curves[0].keys() | curves[1].keys()):
        same = (name in curves[0] and name in curves[1] and
                curves[0][name].read_bytes() == curves[1][name].read_bytes())
        if not same:
            print(f"FAIL {name}")
        passed, failed = passed + same, failed + (not same)
    return passed, failed, 0


def parse():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", metavar="OLD", type=pathlib.Path)
    parser.add_argument("new", metavar="NEW", type=pathlib.Path)
    parser.add_argument("--part", action="append", choices=PARTS)
    parser.add_argument("--case", default="*", metavar="GLOB")
    parser.add_argument("--steps", type=int, metavar="N")
    parser.add_argument("--random", type=int, default=400, metavar="N")
    parser.add_argument("--seed", type=int, default=1, metavar="N")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/compare"))
    arguments = parser.parse_args()
    for folder in (arguments.old, arguments.new):
        if not (folder / "mpm").exists():
            parser.error(f"{folder}: no program mpm there")
    arguments.old, arguments.new = arguments.old.resolve(), arguments.new.resolve()
    arguments.output = arguments.output.resolve()
    return arguments


def main():
    """Compares the selected parts."""
    arguments = parse()
    programs = [str(folder / "mpm") for folder in (arguments.old, arguments.new)]
    passed = failed = skipped = 0
    for part in PARTS:
        if arguments.part and part not in arguments.part:
            continue
        if part == "suite":
            more = compare_suite(arguments)
        elif part == "scenes":
            more = compare_runs(runs_of_scenes(
                programs, arguments.case, [f"time.steps={arguments.steps}"] if arguments.steps else []),
                arguments.jobs)
        else:
            more = compare_runs(list(runs_of_random_scenes(
                programs, arguments.random, arguments.seed, arguments.output / "random")),
                arguments.jobs)
        print(f"{part}: {more[0]} the same, {more[1]} differ, {more[2]} refused by both", flush=True)
        passed, failed, skipped = passed + more[0], failed + more[1], skipped + more[2]
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
