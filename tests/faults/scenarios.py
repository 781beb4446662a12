"""Commands that are run with faults: what is there before, what they write, what mends it after.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import pathlib
import shutil

from calls import run

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CASE = "H/H6"  # a quick one
DRAWN = "H/H4"  # one with a figure
SCORED = "T/T1b"  # one with a bundle
SHORT = ("--set", "time.steps=1")


class Scenario:
    """A command that writes to `out` in a folder of its own. `weight`: how many times fewer faults
    it gets than others, for what it costs. `timed`: its results have times."""

    def __init__(self, name, command, prepare=None, mend=None, weight=1, timed=False):
        self.name, self.command, self.weight, self.timed = name, command, weight, timed
        self.prepare = prepare or (lambda folder: None)
        self.mend = mend or (lambda folder: command)  # the command that has to end well afterwards


def mpm_run(mpm, *options):
    """A run of the scene."""
    return [mpm, "run", "--quiet", "--threads", "1", "--output", "out", *options,
            str(HERE / "scene.yaml")]


def has_checkpoint(folder):
    """Is there one to go on from?"""
    return any((folder / "out" / name).exists()
               for name in ("checkpoint.h5", "checkpoint-previous.h5"))


def finished(mpm, folder):
    """The results of a run."""
    run(mpm_run(mpm), folder)
    return folder / "out"


def interrupted(mpm, folder):
    """Leaves a run that the disk has ended after its second checkpoint."""
    calls = run(mpm_run(mpm), folder).calls
    names = [call.number for call in calls
             if call.name == "rename" and call.paths[1].endswith("/checkpoint.h5")]
    later = [call.number for call in calls if call.number > names[1] and call.name == "pwrite"
             and call.paths[0].endswith("/history.csv")]
    shutil.rmtree(folder / "out")
    run(mpm_run(mpm), folder, f"ENOSPC@{later[0]}")


def of_solver(mpm):
    """mpm: run anew, over old results, and resumed; a scene to begin with; pictures."""
    def mend(folder):
        return mpm_run(mpm, "--resume" if has_checkpoint(folder) else "--overwrite")

    def anew(folder):
        (folder / "out/bar.yaml").unlink(missing_ok=True)  # it is never overwritten
        return [mpm, "new", "bar", "--output", "out/bar.yaml"]

    return [
        Scenario("run", mpm_run(mpm), mend=mend),
        Scenario("overwrite", mpm_run(mpm, "--overwrite"),
                 prepare=lambda folder: run(mpm_run(mpm, "--set", "time.end=0.05"), folder)),
        Scenario("resume", mpm_run(mpm, "--resume"), mend=mend,
                 prepare=lambda folder: interrupted(mpm, folder)),
        Scenario("new", [mpm, "new", "bar", "--output", "out/bar.yaml"], mend=anew,
                 prepare=lambda folder: (folder / "out").mkdir()),
        Scenario("plot", [mpm, "plot", "run", "--output", "out"],
                 prepare=lambda folder: shutil.move(finished(mpm, folder), folder / "run")),
    ]


def catalogue(folder, case):
    """A catalogue of one case."""
    home = folder / "catalogue"
    shutil.copytree(ROOT / "verification/catalogue" / case, home / case)
    shutil.copy(ROOT / "verification/catalogue/methods.yaml", home)


def of_suite(verify, mpm):
    """mpm-verify: cases run, a report with a figure, bundles written and scored."""
    suite = [verify, "run", "--jobs", "1", "--catalogue", "catalogue", "--output", "out"]
    export = [verify, "export", "--catalogue", "catalogue", "--output"]
    score = [verify, "score", "bundle/" + SCORED.rsplit("/", 1)[-1], "results", "--name", "other",
             "--output", "out"]
    study = [verify, "study", "scene.yaml", "--refine", "1,2", "--measure", "kinetic_energy",
             "--measure", "displacement_x:at@25,5=finest", "--jobs", "1", "--output", "out"]

    def reported(folder):
        catalogue(folder, DRAWN)
        run(suite, folder)

    def with_pages(folder):
        reported(folder)
        (folder / "api").mkdir()
        for name in ("index", "other"):
            (folder / f"api/{name}.html").write_text(
                '<html><head><meta name="generator" content="Doxygen"></head></html>\n')

    def exported(folder):
        catalogue(folder, SCORED)
        run([*export, "bundle"], folder)
        (folder / "results").mkdir()

    def with_table(folder):
        exported(folder)
        shutil.copy(folder / score[2] / "reference.csv", folder / "results")

    def with_snapshots(folder):
        exported(folder)
        run([mpm, "run", "--quiet", "--output", "run", *SHORT,
             str(folder / "catalogue" / SCORED / "scene.yaml")], folder)
        for snapshot in sorted((folder / "run").glob("*.hdf")):
            shutil.copy(snapshot, folder / "results")

    def studied(folder):
        shutil.copy(HERE / "scene.yaml", folder)

    return [
        Scenario("study", study, prepare=studied, weight=16, timed=True),
        Scenario("verify", suite, prepare=lambda folder: catalogue(folder, CASE),
                 weight=4, timed=True),
        Scenario("verify-over", suite, prepare=reported, weight=8, timed=True),
        Scenario("report", [verify, "report", "out"], prepare=reported, weight=2),
        Scenario("report-api", [verify, "report", "out", "--api", "api"], prepare=with_pages),
        Scenario("export", [*export, "out"], prepare=lambda folder: catalogue(folder, SCORED)),
        Scenario("score", score, prepare=with_table),
        Scenario("score-hdf5", score, prepare=with_snapshots),
    ]


def small_blocks(folder):
    """The scenes of mpm-bench, with a 25th of their particles, so that no timing is long."""
    home = folder / "benchmarks/scenes"
    shutil.copytree(ROOT / "benchmarks/scenes", home)
    for scene in home.glob("*.yaml"):
        scene.write_text(scene.read_text().replace("cell: [1, 1], cells: [5, 5]",
                                                   "cell: [5, 5], cells: [1, 1]"))


def of_benchmarks(bench):
    """mpm-bench: the quickest group, and the report of it."""
    measure = [bench, "run", "--group", "limit", "--tier", "quick", "--output", "out"]

    def measured(folder):
        small_blocks(folder)
        run(measure, folder)

    return [
        Scenario("bench", measure, prepare=small_blocks, weight=8, timed=True),
        Scenario("bench-report", [bench, "report", "out"], prepare=measured, weight=2),
    ]
