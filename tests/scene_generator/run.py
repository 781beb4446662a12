"""Runs scenes with the program `mpm` and reads what it writes.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import csv
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile

import h5py
import numpy

PROCESSOR_LIMIT = 60  # seconds of processor time: a small scene takes some hundredths
TIME_LIMIT = 1200  # seconds on the clock, for a program that waits for ever


class Late(Exception):
    """A program that has used up its processor time, or that waits for ever."""


def limit_processor():
    """In the child: ends it by SIGXCPU when its processor time is used up."""
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_LIMIT, PROCESSOR_LIMIT + 1))


class State:
    """One snapshot: arrays of all particles, sorted by body and by id within it."""

    def __init__(self, path):
        with h5py.File(path) as file:
            group = file["mpm"]
            self.time, self.step = float(group.attrs["time"]), int(group.attrs["step"])
            self.body_names = [str(name) for name in group.attrs["body_names"]]
            particles = group["particles"]
            self.fields = {name: particles[name][()] for name in particles}

    def __getattr__(self, name):
        try:
            return self.__dict__["fields"][name]
        except KeyError:
            raise AttributeError(name) from None

    def of_bodies(self, names):
        """Which particles belong to the bodies of these names."""
        return numpy.isin(self.body, [k for k, n in enumerate(self.body_names) if n in names])


class Result:
    """What a run left: exit status, message, history by column, snapshots in order."""

    def __init__(self, status, message):
        self.status, self.message = status, message
        self.history, self.states, self.kernels, self.threads = {}, [], None, 0
        self.files, self.ended = {}, []

    def read(self, folder, keep_bytes):
        """Reads the results in the folder."""
        with open(folder / "history.csv", newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
        table = numpy.array([[float(cell) for cell in row] for row in rows[1:]])
        self.history = {name: table[:, k] for k, name in enumerate(rows[0])}
        snapshots = sorted(folder.glob("particles-*.hdf"))
        self.states = [State(path) for path in snapshots]
        record = json.loads((folder / "run.json").read_text())
        self.ended = record["ended_tips"]
        self.kernels, self.threads = record["kernels"], record["provenance"]["threads"]
        if keep_bytes:
            self.files = {path.name: path.read_bytes()
                          for path in [folder / "history.csv", *snapshots]}

    @property
    def start(self):
        """The state at t = 0."""
        return self.states[0]

    @property
    def end(self):
        """The last state."""
        return self.states[-1]


def to_text(scene):
    """The scene as YAML that is JSON as well, a section on each line."""
    lines = []
    for name, value in scene.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            entries = ",\n  ".join(json.dumps(entry) for entry in value)
            lines.append(f"{json.dumps(name)}: [\n  {entries}]")
        else:
            lines.append(f"{json.dumps(name)}: {json.dumps(value)}")
    return "{" + ",\n".join(lines) + "}\n"


def from_text(text):
    """The scene of such a text; lines that begin with # are comments."""
    return json.loads("\n".join(line for line in text.splitlines()
                                if not line.lstrip().startswith("#")))


class Runner:
    """Runs scenes in a scratch folder of its own, one at a time."""

    def __init__(self, programs):
        self.mpm = str(programs / "mpm")
        self.probe = str(programs / "mpm-nodes")
        memory = pathlib.Path("/dev/shm")
        self.folder = pathlib.Path(tempfile.mkdtemp(
            prefix="scenes-", dir=memory if os.access(memory, os.W_OK) else None))
        self.runs = 0
        self.environment = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")

    def close(self):
        """Removes the scratch folder."""
        shutil.rmtree(self.folder, ignore_errors=True)

    def write(self, scene):
        """Writes the scene; returns its path."""
        path = self.folder / "scene.yaml"
        path.write_text(to_text(scene))
        return path

    def call(self, *command):
        """Exit status, output and message of a command; a signal is a negative status."""
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT,
                                  env=self.environment, check=False, preexec_fn=limit_processor)
        except subprocess.TimeoutExpired as late:
            raise Late(f"no answer after {TIME_LIMIT} s, of which less than {PROCESSOR_LIMIT} s on a "
                       f"processor: {' '.join(command)}") from late
        if done.returncode in (-signal.SIGXCPU, 128 + signal.SIGXCPU):  # a run ends in good order
            raise Late(f"no answer after {PROCESSOR_LIMIT} s of processor time: {' '.join(command)}")
        return done.returncode, done.stdout, done.stderr.strip()

    def check(self, scene):
        """Exit status and message of `mpm check`."""
        status, _, message = self.call(self.mpm, "check", str(self.write(scene)))
        return status, message

    def run(self, scene, *options, keep_bytes=False):
        """The result of `mpm run`, with one thread unless the options state otherwise."""
        shutil.rmtree(self.folder / "results", ignore_errors=True)
        threads = () if "--threads" in options else ("--threads", "1")
        return self.run_into(self.write(scene), threads + options, keep_bytes)

    def resume(self, *options):
        """The result of the last run, once it has gone on from its checkpoint."""
        return self.run_into(self.folder / "scene.yaml", ("--resume", *options), True)

    def has(self, name):
        """Has the last run left a file of that name?"""
        return (self.folder / "results" / name).exists()

    def keep_checkpoint(self, name):
        """Removes what is newer than that checkpoint of the last run."""
        if name != "checkpoint.h5":
            (self.folder / "results" / "checkpoint.h5").unlink()

    def run_into(self, path, options, keep_bytes):
        """The result of `mpm run` with a scene's file, into the folder as it is."""
        folder = self.folder / "results"
        self.runs += 1
        status, _, message = self.call(self.mpm, "run", str(path), "--quiet",
                                       "--output", str(folder), *options)
        result = Result(status, message)
        if status in (0, 3) and (folder / "history.csv").exists():
            result.read(folder, keep_bytes)
        return result

    def nodes(self, scene):
        """Exit status, message, and the nodes of every step as rows (step, time, time step, x, y, v_x,
        v_y, mass, temperature, concentration): what mpm-nodes prints."""
        self.runs += 1
        status, output, message = self.call(self.probe, str(self.write(scene)))
        rows = numpy.array([[float(cell) for cell in line.split()]
                            for line in output.splitlines()])
        return status, message, rows.reshape(-1, 10)
