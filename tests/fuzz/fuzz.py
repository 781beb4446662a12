#!/usr/bin/python3
"""Runs the harnesses of libFuzzer (see README.md beside this file).

    fuzz.py check CC                                can CC build them? If not: why, and exit 1
    fuzz.py run --seconds N [--jobs N] [--only T]   each over its corpus, then so long with new inputs
    fuzz.py merge [--only T]                        new inputs that reach more go to the corpus, and
                                                    inputs of the corpus that reach nothing more leave

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build" / "fuzz"

# An input that takes longer or more memory is a finding. Inputs of a corpus are shorter.
LIMITS = ["-timeout=20", "-rss_limit_mb=1024", "-max_len=16384"]
CORPUS_LENGTH = 5000


def targets():
    names = (path.stem[len("fuzz_"):] for path in HERE.glob("fuzz_*.c"))
    return sorted(set(names) - {"runs"})


def why_not(compiler):
    """Why the compiler cannot link a harness; None if it can."""
    source = "int LLVMFuzzerTestOneInput(void) { return 0; }\n"
    flags = ["-fsanitize=fuzzer,address,undefined", "-x", "c", "-", "-o", "/dev/null"]
    try:
        made = subprocess.run([*compiler.split(), *flags], input=source, text=True,
                              capture_output=True, check=False)
    except OSError:
        return f"there is no {compiler}"
    if made.returncode == 0:
        return None
    return f"{compiler} has no runtime of libFuzzer (Debian: libclang-rt-dev): " \
           + made.stderr.strip().split("\n")[0]


def words_of_schema(schema, words):
    """Keys, choices and defaults of `mpm schema`, at any depth."""
    if isinstance(schema, dict):
        for key, value in schema.items():
            if isinstance(value, dict):
                words.add(key)
            words_of_schema(value, words)
    elif isinstance(schema, list):
        for value in schema:
            words_of_schema(value, words)
    elif isinstance(schema, str) and re.fullmatch(r"[a-z0-9_]{2,40}", schema):
        words.add(schema)


def dictionary(target):
    """A file of words that inputs are made of, or None."""
    own = HERE / "dictionaries" / f"{target}.dict"
    if target != "scene":
        return own if own.exists() else None
    words = set()
    schema = subprocess.run([BUILD / "bin" / "mpm", "schema", "--list"], capture_output=True, check=True)
    words_of_schema(json.loads(schema.stdout), words)
    made = BUILD / "scene.dict"
    made.write_text("".join(f'"{word}: "\n"{word}"\n' for word in sorted(words))
                    + own.read_text())
    return made


def start(target, arguments, folder):
    program = BUILD / "bin" / f"fuzz-{target}"
    done = subprocess.run([program, *arguments], cwd=ROOT, stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False,
                          env=dict(os.environ, TMPDIR=folder))
    return done.returncode, done.stderr.decode(errors="replace")


def numbers(log):
    """Executions and edges that the log of a harness has."""
    executed = re.findall(r"^stat::number_of_executed_units: (\d+)", log, re.M)
    edges = re.findall(r"\bcov: (\d+)", log)
    return (int(executed[-1]) if executed else 0), (int(edges[-1]) if edges else 0)


def fuzz(target, seconds, scratch):
    """A line about the target, and whether nothing was found."""
    corpus, new = HERE / "corpus" / target, BUILD / "new" / target
    findings = BUILD / "findings"
    for folder in (new, findings, scratch / target):
        folder.mkdir(parents=True, exist_ok=True)
    arguments = [*LIMITS, f"-artifact_prefix={findings}/{target}-", "-print_final_stats=1"]
    words = dictionary(target)
    if words is not None:
        arguments.append(f"-dict={words}")
    # The seeds first, one by one, so that one that fails is reported whatever comes next.
    seeds = sorted(corpus.glob("*"))
    status, log = start(target, [*arguments, "-runs=0", corpus], scratch / target)
    executed, edges = numbers(log)
    if status == 0 and seconds > 0:
        status, log = start(target, [*arguments, f"-max_total_time={seconds}", new, corpus],
                            scratch / target)
        executed, edges = numbers(log)
    (BUILD / f"{target}.log").write_text(log)
    line = f"{target:<11} {executed:>9} executions, {edges:>6} edges, {len(seeds):>3} seeds"
    if status == 0:
        return line, True
    found = re.findall(r"Test unit written to (\S+)", log)
    reason = re.findall(r"^(?:.*runtime error: .*|==\d+== ?ERROR: .*|fuzz: .*|.*\*\* .*)$", log, re.M)
    return f"{line}\nFAIL {target}: {' '.join(found)} {reason[0] if reason else log[-400:]}", False


def run(arguments):
    passed = failed = 0
    wanted = arguments.only or targets()
    shared = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(prefix="touchstone-fuzz-", dir=shared) as folder, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        jobs = [pool.submit(fuzz, target, arguments.seconds, pathlib.Path(folder))
                for target in wanted]
        for job in jobs:
            line, sound = job.result()
            print(line, flush=True)
            passed += sound
            failed += not sound
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


def chosen(control):
    """Of the control file of a merge: inputs that reach all edges, few and small."""
    lines = control.read_text().split("\n")
    count = int(lines[0])
    files = [pathlib.Path(line) for line in lines[2:2 + count]]
    edges = {}
    for line in lines[2 + count:]:
        if line.startswith("COV "):
            number, *reached = map(int, line.split()[1:])
            # An input has the edges that none before it had: they add up to all.
            edges[files[number]] = set(reached)
    missing = set().union(*edges.values())
    kept = []
    while missing:
        best = max(edges, key=lambda f: (len(edges[f] & missing) / (200 + f.stat().st_size), f.name))
        missing -= edges[best]
        kept.append(best)
    return kept


def merge(arguments):
    for target in arguments.only or targets():
        corpus, new = HERE / "corpus" / target, BUILD / "new" / target
        corpus.mkdir(parents=True, exist_ok=True)
        new.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="touchstone-fuzz-") as folder:
            here = pathlib.Path(folder)
            small = [path for path in [*corpus.iterdir(), *new.iterdir()]
                     if path.stat().st_size <= CORPUS_LENGTH]
            for name in ("all", "merged", "kept"):
                (here / name).mkdir()
            for path in small:
                shutil.copy(path, here / "all" / path.name)
            status, log = start(target, [*LIMITS, "-merge=1",
                                         f"-merge_control_file={here}/control",
                                         here / "merged", here / "all"], folder)
            if status != 0:
                print(log[-2000:], file=sys.stderr)
                return 1
            for path in chosen(here / "control"):
                shutil.copy(path, here / "kept" / path.name)
            for path in corpus.iterdir():
                if re.fullmatch(r"[0-9a-f]{40}", path.name): # others were named by hand: they stay
                    path.unlink()
            for path in (here / "kept").iterdir():
                shutil.move(path, corpus / path.name)
        files = list(corpus.glob("*"))
        print(f"{target}: {len(files)} inputs, {sum(f.stat().st_size for f in files)} bytes")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("check").add_argument("compiler")
    for name in ("run", "merge"):
        command = commands.add_parser(name)
        command.add_argument("--only", action="append", choices=targets())
        if name == "run":
            command.add_argument("--seconds", type=int, default=60)
            command.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    if arguments.command == "check":
        reason = why_not(arguments.compiler)
        if reason is not None:
            print(f"fuzzing is skipped: {reason}\n0 passed, 0 failed, {len(targets())} skipped")
        return 0 if reason is None else 1
    return {"run": run, "merge": merge}[arguments.command](arguments)


if __name__ == "__main__":
    sys.exit(main())
