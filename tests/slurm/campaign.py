#!/usr/bin/python3
"""A part of the catalogue on a real Slurm on this machine: `make test-slurm`.

    campaign.py --verify PROGRAM --folder DIR

Starts munged, slurmctld and slurmd from a configuration made in DIR, runs programs with `mpm-verify
run --launcher slurm` while it kills a task, requeues another, interrupts mpm-verify and kills the
controller, and compares the report with that of a local run: all bytes of all files, once times and
peak memory are set to zero and the pages are made again. Before, it kills a study on Slurm, lets it
go on, and compares its tables and pictures. All daemons end with it. The last line is `N passed, N
failed, N skipped`; where Slurm is not installed, or does not start, it is skipped with the reason.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

LONGEST = 60  # seconds that anything here may take to happen
SCENE = pathlib.Path(__file__).resolve().parent.parent / "interruption/disk.yaml"  # of the study

CONFIGURATION = """ClusterName=touchstone
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={sockets}/munge.sock,cred_expire=6
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=2,batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=1500 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


class Missing(Exception):
    """Slurm cannot be had here, and why."""


def wait_until(holds, what):
    """Waits until `holds` gives something, and returns that."""
    end = time.monotonic() + LONGEST
    while time.monotonic() < end:
        found = holds()
        if found:
            return found
        time.sleep(0.05)
    raise TimeoutError(what)


def free_ports(count):
    """Numbers of ports that nobody uses."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """The daemons."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}
        path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
        self.programs = {name: shutil.which(name, path=path)
                         for name in ("munged", "slurmctld", "slurmd", "sbatch", "squeue")}
        absent = [name for name, found in self.programs.items() if found is None]
        if absent:
            raise Missing(f"not installed: {', '.join(absent)} (Debian: slurm-wlm, munge)")
        if os.geteuid() != 0:
            raise Missing("slurmd has to be started by root")
        self.sockets = pathlib.Path(tempfile.mkdtemp(prefix="mpm-slurm-"))
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"), PATH=path)

    def start(self):
        """Raises Missing if no task runs."""
        host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, ports=free_ports(2), folder=self.folder, sockets=self.sockets, user="root"))
        key = self.sockets / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.daemon("munged", "--foreground", "--force", f"--key-file={key}",
                    f"--socket={self.sockets}/munge.sock", f"--pid-file={self.sockets}/munged.pid",
                    f"--log-file={self.sockets}/munged.log", f"--seed-file={self.sockets}/seed")
        try:
            wait_until(lambda: (self.sockets / "munge.sock").exists(), "munged")
            self.controller()
            self.daemon("slurmd", "-D")
            wait_until(lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"), "slurmd")
        except TimeoutError as failure:
            raise Missing(f"{failure} does not start; see {self.folder}") from failure

    def controller(self):
        """Starts slurmctld, also again."""
        self.daemon("slurmctld", "-D")

    def daemon(self, name, *arguments):
        """A program that stays; its number is in `daemons`."""
        with open(self.folder / f"{name}.out", "ab") as out:
            self.daemons[name] = subprocess.Popen([self.programs[name], *arguments], stdout=out,
                                                  stderr=out, env=self.environment)

    def ask(self, *command):
        """What a command of Slurm's prints; nothing if it fails."""
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True,
                              check=False, timeout=LONGEST)
        return done.stdout if done.returncode == 0 else ""

    def state(self):
        """Jobs and nodes, and the end of what the daemons wrote."""
        logs = [self.folder / f"{name}.log" for name in ("slurmctld", "slurmd")]
        return "\n".join([self.ask("squeue", "-a"), self.ask("sinfo", "-R"), self.ask("sinfo")] + [
            line for log in logs if log.exists() for line in log.read_text().splitlines()[-20:]])

    def kill_controller(self):
        """As by a fault, but not within the seconds before it has saved its state: of jobs that it
        does not know to run, Slurm drains the node."""
        start = time.time()
        state = self.folder / "state" / "job_state"
        while time.time() < start + 8 and not (state.exists() and state.stat().st_mtime > start):
            time.sleep(0.1)
        self.daemons["slurmctld"].kill()
        self.daemons["slurmctld"].wait()

    def stop(self):
        """Ends all that was started here: daemons, and the steps that slurmd has started."""
        for daemon in self.daemons.values():
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(5)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        for process in processes(b"SLURM_CONF=" + bytes(self.folder / "slurm.conf"), "environ"):
            os.kill(process, signal.SIGKILL)
        shutil.rmtree(self.sockets, ignore_errors=True)


def processes(text, file):
    """Numbers of the processes, but for this one, whose file in /proc has the text."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if text in (folder / file).read_bytes() and int(folder.name) != os.getpid():
                found.append(int(folder.name))
        except OSError:
            pass
    return found


def tasks_at_work(folder):
    """The processes `mpm-verify task` of a run: those of the batch scripts, not their programs'."""
    found = processes(b"\0task\0" + bytes(folder) + b"\0", "cmdline")
    return [number for number in found if parent_of(number) not in found]


def parent_of(number):
    """The process that has started another; 0 if that is gone."""
    try:
        text = pathlib.Path(f"/proc/{number}/stat").read_text()
    except OSError:
        return 0
    return int(text.rpartition(")")[2].split()[1])


# ---------------------------------------------------------------------- comparison

TIMES = {"seconds", "started", "command", "only"}
MEASURED = {"seconds", "cpu_seconds", "peak_bytes"}


def without(value):
    """A value of the same type that says nothing."""
    return value if value is None else "" if isinstance(value, str) else 0


def without_times(value):
    """JSON with every time set to zero."""
    if isinstance(value, dict):
        if value.get("quantity") in MEASURED:
            return dict(value, value=0)
        return {key: without(inner) if key in TIMES else without_times(inner)
                for key, inner in value.items()}
    return [without_times(inner) for inner in value] if isinstance(value, list) else value


def normalize(verify, folder):
    """Sets the times to zero and makes the pages again; returns the bytes of all files."""
    for name in ("checks.jsonl", "measurements.jsonl"):
        path = folder / name
        lines = [json.dumps(without_times(json.loads(line)), ensure_ascii=False)
                 for line in path.read_text().splitlines()]
        path.write_text("\n".join(lines) + "\n")
    for path in folder.glob("cases/*/rows-*.jsonl"):
        path.write_text(re.sub(r'("kind":"(?:processor|memory)","name":"","text":")[^"]*', r"\g<1>0",
                               path.read_text()))
    subprocess.run([verify, "report", str(folder)], check=True, capture_output=True)
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*")
            if path.is_file() and ".run" not in path.parts and path.name != ".mpm-verify"}


PROCESSOR = "processor / s"  # the column of study.md that a clock speaks in


def without_column(text):
    """The text of study.md without that column."""
    kept, place = [], None
    for line in text.splitlines():
        cells = line.split("|")
        if PROCESSOR in line:
            place = next(i for i, cell in enumerate(cells) if cell.strip() == PROCESSOR)
        elif len(cells) < 3:
            place = None
        if place is not None:
            del cells[place]
        kept.append("|".join(cells))
    return "\n".join(kept)


def study_files(folder):
    """Tables and pictures of a study by name, without times."""
    found = {}
    for path in (folder / "study").iterdir():
        if path.is_dir() or "-time." in path.name:
            continue
        text = path.read_text()
        if path.name == "study.md":
            text = without_column(text)
        elif path.suffix == ".csv":
            text = re.sub(r",[^,]*(,[^,]*,\"[^\"]*\")$", r"\1", text, flags=re.M)
        elif path.suffix == ".jsonl":
            text = re.sub(r'"cpu_seconds":[^,]*', "", text)
        found[path.name] = text
    return found


# ------------------------------------------------------------------------- campaign

class Campaign:
    """One run on Slurm with all that is done to it; counts what holds."""

    def __init__(self, verify, cluster, folder, programs):
        self.verify, self.cluster, self.folder = verify, cluster, folder
        self.list = folder / "programs"
        self.list.write_text(programs)
        self.local = folder / "local"
        self.remote = folder / "on Slurm's \"100 %\""
        self.passed = self.failed = 0

    def check(self, what, holds, found=""):
        """Counts and prints."""
        self.passed += bool(holds)
        self.failed += not holds
        print(f"{'pass' if holds else 'FAIL'} {what}{'' if holds else f': {found}'}", flush=True)

    def run(self, *options, output=None):
        """Starts mpm-verify run."""
        command = [self.verify, "run", "--output", str(output or self.remote), *options]
        return subprocess.Popen(command, env=self.cluster.environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def status(self):
        """What --status prints last, by word."""
        said = self.run("--status").communicate(timeout=LONGEST)[0]
        return {word: int(number) for number, word in re.findall(r"(\d+) (\w+)",
                                                                 said.splitlines()[-1])}

    def go(self):
        """Everything, in order."""
        said, _ = self.run("--only", str(self.list), output=self.local).communicate()
        self.check("a local run passes", ", 0 failed" in said, said)
        run = self.run("--launcher", "slurm", "--only", str(self.list), "--costs", str(self.local))
        number = wait_until(lambda: tasks_at_work(self.remote), "no task runs")[0]
        os.kill(number, signal.SIGKILL)
        number = wait_until(lambda: [one for one in tasks_at_work(self.remote) if one != number],
                            "no other task runs")[0]
        job = self.job_of(number)
        self.check("a running task is requeued", job and self.requeue(job), job)
        run.send_signal(signal.SIGTERM)
        said = run.communicate(timeout=LONGEST)[0]
        self.check("mpm-verify is interrupted with status 143 and leaves the programs to Slurm",
                   run.returncode == 128 + signal.SIGTERM and "go on in Slurm" in said,
                   f"{run.returncode}: {said}")
        self.cluster.kill_controller()
        said = self.run("--status").communicate(timeout=LONGEST)
        self.check("without a controller --status reports why", "squeue: " in said[0], said)
        self.cluster.controller()
        wait_until(lambda: self.cluster.ask("sinfo", "-h"), "no controller")
        counts = self.status()
        self.check("--status counts all programs", sum(counts.values()) == len(
            self.list.read_text().split()) and counts["done"] < sum(counts.values()), counts)
        run = self.run("--launcher", "slurm", "--resume", "--costs", str(self.local))
        time.sleep(1)
        self.cluster.kill_controller()
        time.sleep(2)
        self.cluster.controller()
        said = run.communicate(timeout=5 * LONGEST)[0]
        self.check("the run ends, with every program", run.returncode == 0, said)
        counts = self.status()
        self.check("--status: all done", counts["done"] == sum(counts.values()), counts)
        self.compare()

    def study(self):
        """A study that is killed with one of its tasks goes on to the tables of a local one."""
        local, remote = self.folder / "study", self.folder / "study on Slurm"
        command = [self.verify, "study", str(SCENE), "--output"]
        grid = ["--refine", "1,2", "--vary", "method.shape=ugimp,cpdi", "--set", "time.end=0.6",
                "--set", "output.checkpoint_seconds=0.05",
                "--measure", "kinetic_energy:max", "--measure", "displacement_x:at@25,5=finest"]
        words = {"env": self.cluster.environment, "text": True, "stdout": subprocess.PIPE,
                 "stderr": subprocess.STDOUT}
        said = subprocess.run([*command, str(local), *grid], check=False, **words)
        self.check("a local study ends well", said.returncode == 0, said.stdout)
        run = subprocess.Popen([*command, str(remote), *grid, "--launcher", "slurm"], **words)
        number = wait_until(lambda: tasks_at_work(remote), "no task of the study runs")[0]
        run.kill()
        os.kill(number, signal.SIGKILL)
        run.communicate()
        begun = not (remote / "study/study.csv").exists()
        said = subprocess.run([*command, str(remote), "--resume", "--launcher", "slurm"],
                              check=False, timeout=5 * LONGEST, **words)
        self.check("a study that was killed with a task goes on",
                   begun and said.returncode == 0, said.stdout)
        ours, theirs = study_files(local), study_files(remote)
        other = sorted(set(ours) ^ set(theirs)) + [name for name in ours if name in theirs and
                                                   ours[name] != theirs[name]]
        self.check(f"its tables and pictures are those of the local study: {len(ours)} files",
                   not other and "study.csv" in ours, other)

    def job_of(self, number):
        """JOB_INDEX of a task's process."""
        try:
            lines = pathlib.Path(f"/proc/{number}/environ").read_bytes().split(b"\0")
        except OSError:
            return ""
        words = dict(line.decode().split("=", 1) for line in lines if b"=" in line)
        return f"{words.get('SLURM_ARRAY_JOB_ID')}_{words.get('SLURM_ARRAY_TASK_ID')}"

    def requeue(self, job):
        """Does Slurm end and requeue it?"""
        return subprocess.run(["scontrol", "requeue", job], env=self.cluster.environment,
                              capture_output=True, check=False).returncode == 0

    def compare(self):
        """The reports, byte by byte."""
        local, remote = (normalize(self.verify, folder) for folder in (self.local, self.remote))
        other = sorted(set(local) ^ set(remote)) + [name for name in local if name in remote and
                                                    local[name] != remote[name]]
        self.check(f"the report is that of the local run: {len(local)} files, "
                   f"{sum(map(len, local.values()))} bytes", not other, other)


def main():
    """Exit status: 0 all holds or is skipped; 1 something does not."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--verify", required=True, type=os.path.abspath)
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    given = parser.parse_args()
    folder = given.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    cluster = campaign = None
    try:
        cluster = Cluster(folder)
        cluster.start()
        programs = (pathlib.Path(__file__).parent / "programs").read_text()
        campaign = Campaign(given.verify, cluster, folder, programs)
        # The study first: a controller that is killed as a job ends counts that job as running for
        # minutes, with its memory, and no task of the study begins.
        campaign.study()
        campaign.go()
    except Missing as reason:
        print(f"skipped: {reason}")
        print("0 passed, 0 failed, 1 skipped")
        return 0
    except (TimeoutError, subprocess.TimeoutExpired) as failure:
        campaign.check(str(failure), False, f"not within {LONGEST} s\n" + cluster.state())
    finally:
        if cluster is not None:
            cluster.stop()
    print(f"{campaign.passed} passed, {campaign.failed} failed, 0 skipped")
    return int(campaign.failed > 0)


if __name__ == "__main__":
    sys.exit(main())
