"""What has to hold after a command with a fault.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import hashlib
import json
import re
import xml.dom.minidom

from calls import HARMLESS, REASONS, SUFFIX

SHOWN = 300  # characters of a message

CHECKPOINT = re.compile(r"(^|/)checkpoint[^/]*\.h5$")
IN_TEMPORARY = re.compile(r"/touchstone-\w{6}(/|$)")
KEPT_FOLDER = "/.run/results/"
READS = ("stat", "open", "fstat", "read")
REMOVES = ("opendir", "readdir", "lstat", "unlink", "rmdir")
UNFINISHED = ".run/unfinished/"  # from which a run may go on: from a checkpoint with a right sum
KEPT = re.compile(r"^\.run/results/[^/]*\.json$")  # what one program of the suite has found
LOCKS = ("run.lock", ".mpm-verify")

# Where these fail, the file may belong to another writer, or stays: the next one writes over it.
LEAVES = ("unlink", "flock", "fstat", "stat")

# Faults that a command may pass over, by call and the end of the path, and why its results are none
# the worse.
IGNORED = (
    ("close", "", "what counts has been synced; what was read has been read"),
    ("unlink", "run.lock", "one that is left locks nothing"),
    ("unlink", SUFFIX, "the next writer of the name writes over it"),
    ("mkdir", "", "the folder is there"),
    ("stat", "", "a file is taken to be there: opening it gives the reason"),
    ("", "/checkpoint.h5", "the run goes on from the older one"),
    ("", ".txt", "a page has the end of a log where it can be read"),
    ("rmdir", "", "an empty folder is no result"),
    ("ftruncate", "history.csv", "the file is cut after a failure, which is reported"),
    ("ftruncate", "probes.csv", "the file is cut after a failure, which is reported"),
)


def may_ignore(call):
    """Why a fault of the call may be passed over, or None."""
    if IN_TEMPORARY.search(call.paths[0]) and call.name in REMOVES:
        return "what is left in a temporary folder is no result"
    if KEPT_FOLDER in call.paths[0] and call.name in READS:
        return "a result that cannot be read is found again by its program"
    for name, end, why in IGNORED:
        if name in ("", call.name) and call.paths[0].endswith(end):
            return why
    return None


def without_place(content, folder):
    """Content without its folder and dates."""
    return re.sub(rb"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d)?", b"NOW",
                  content.replace(str(folder).encode(), b"HERE"))


def files(folder):
    """Contents by name, of all files in the folder `out` and those in it, but for locks."""
    out = folder / "out"
    return {str(path.relative_to(out)): without_place(path.read_bytes(), folder)
            for path in out.rglob("*") if path.is_file() and path.name not in LOCKS}


def without_times(name, content):
    """Content in which what a clock says is hidden: seconds and dates. A checkpoint has its own sum,
    and whoever goes on from it writes the bytes of the results."""
    if CHECKPOINT.search(name):
        return b"sound" if is_checkpoint(content) else content
    if KEPT.search(name):
        return b"sound" if is_kept(content) else content
    if name == "run.json":
        record = json.loads(content)
        record["warnings"] = [warning for warning in record["warnings"]
                              if "the run goes on from checkpoint-previous.h5" not in warning]
        record["counters"]["seconds"] = None
        record["provenance"]["processor"] = None  # "unknown" is as good
        record.pop("resumed", None)
        record["counters"].pop("checkpoints", None)
        return json.dumps(record).encode()
    if name.endswith(".md"):
        content = re.sub(rb" +", b" ", content)  # columns are as wide as their numbers
    content = re.sub(rb"[-+]?[0-9]((\xe2\x80\xaf)?[0-9.])*"
                     rb"(e[-+]?[0-9]+| \xc3\x97 10<sup>[^<]*</sup>)?( (ms|s|min)\b)?", b"#", content)
    # only some intervals have a width
    return re.sub(rb'#(, # \.\. #|<span class="about"># \.\. #</span>)', b"#", content)


def same(name, content, other, steady):
    """Are two contents of a file the same, apart from times where it has any?"""
    if content == other:
        return True
    return name not in steady and without_times(name, content) == without_times(name, other)


def difference(name, content, other):
    """Where two contents begin to differ, apart from times."""
    ours, theirs = without_times(name, content), without_times(name, other)
    at = next((i for i, pair in enumerate(zip(ours, theirs)) if pair[0] != pair[1]),
              min(len(ours), len(theirs)))
    return f"{ours[max(0, at - 40):at + 40]} for {theirs[max(0, at - 40):at + 40]}"


# ---------------------------------------------------------------------------- whole files

def is_checkpoint(content):
    """Does its head state its length and its sum?"""
    lines = content[:512].rstrip(b"\0").decode(errors="replace").split("\n")
    return (len(content) > 512 and lines[0] == "touchstone checkpoint" and
            lines[2] == f"bytes {len(content)}" and
            lines[3] == "md5 " + hashlib.md5(content[512:]).hexdigest())


def is_kept(content):
    """Is it a line of JSON, and its sum?"""
    text, _, total = content.rstrip(b"\n").partition(b"\n")
    return hashlib.sha256(text).hexdigest().encode() == total


def is_json_lines(content):
    """Is each line an object, the last one included?"""
    return content.endswith(b"\n") and all(json.loads(line) is not None
                                           for line in content.splitlines())


WHOLE = (
    (CHECKPOINT, is_checkpoint),
    (KEPT, is_kept),
    (r"\.json$|\.series$", lambda content: json.loads(content) is not None),
    (r"\.jsonl$", is_json_lines),
    (r"\.html$", lambda content: content.rstrip().endswith(b"</html>")),
    (r"\.svg$|\.xml$", lambda content: xml.dom.minidom.parseString(content) is not None),
    (r"(^|/)(history|probes|table-[a-z]*|checks|runs|reference)\.csv$|\.dat$|\.md$|\.tap$",
     lambda content: content.endswith(b"\n")),
)

# Rows are added to these: those that are there are whole.
GROWING = ("history.csv", "probes.csv")

# These are appended to: a program that ends early leaves whole lines, or, of its log, any bytes.
APPENDED = re.compile(r"(^|/)(rows-[^/]*\.jsonl|log-[^/]*\.txt)$")


def is_whole(name, content):
    """Does a file of this name look complete?"""
    for pattern, test in WHOLE:
        if re.search(pattern, name):
            try:
                return bool(test(content))
            except (ValueError, IndexError, xml.parsers.expat.ExpatError):
                return False
    return True


def half_written(found, before, reference, steady):
    """The first name of a file that is neither old, nor as it should be, nor whole; or None."""
    for name, content in sorted(found.items()):
        if name.endswith(SUFFIX) or name.startswith(UNFINISHED) or APPENDED.search(name):
            continue
        known = [files[name] for files in (before, reference) if name in files]
        if any(same(name, content, other, steady) for other in known):
            continue
        if name in GROWING and any(other.startswith(content) for other in known) and \
                (content == b"" or content.endswith(b"\n")):
            continue
        if name.endswith(".hdf") or not is_whole(name, content) or content == b"":
            return name
    return None


# ------------------------------------------------------------------------------- verdicts

def names_the_fault(text, call, kind):
    """Does a message name the file of the call and the system's reason?"""
    names = [path[:-len(SUFFIX)] if path.endswith(SUFFIX) else path for path in call.paths]
    return REASONS[kind] in text and any(name.rsplit("/", 1)[-1] in text for name in names)


def missing_files(found, reference):
    """The files that only one of the two has."""
    return sorted(found.keys() ^ reference.keys())


class Judge:
    """Compares outcomes with those of a command without faults."""

    def __init__(self, outcome, found, again, timed):
        self.status, self.files, self.again = outcome.status, found, again
        # `timed`: the command measures time, and all that it writes may have it
        # files whose bytes are the same in two runs without faults: in all others a clock speaks
        self.steady = {name for name in found if again.get(name) == found[name] and
                       not CHECKPOINT.search(name) and not timed}

    def unlike(self, outcome, found):
        """How an outcome differs from that without faults, or None."""
        if outcome.status != self.status:
            return f"exit {outcome.status}, not {self.status}: {outcome.errors.strip()[-SHOWN:]}"
        if missing_files(found, self.files):
            return f"other files: {missing_files(found, self.files)}"
        for name, content in found.items():
            if not any(same(name, content, other.get(name, b""), self.steady)
                       for other in (self.files, self.again)):
                return f"{name} has other bytes: {difference(name, content, self.files[name])}"
        return None

    def of_fault(self, outcome, kind, found, before, lasting):
        """What is wrong with the outcome of a command that had a fault, or None."""
        fired = outcome.fired()
        if outcome.status is None:
            return "hangs"
        if outcome.status < 0:
            return f"ended by signal {-outcome.status}: {outcome.errors.strip()[-SHOWN:]}"
        if "HDF5-DIAG" in outcome.errors:
            return "HDF5 prints messages of its own"
        if kind in HARMLESS:
            return self.unlike(outcome, found)
        bad = half_written(found, before, self.files, self.steady)
        if bad is not None:
            return f"{bad} is not whole (exit {outcome.status}: {outcome.errors.strip()[-SHOWN:]})"
        left = [name for name in found if name.endswith(SUFFIX) and not name.startswith(UNFINISHED)]
        if left and not lasting and fired[0].name not in LEAVES:
            return f"{left[0]} is left (exit {outcome.status})"
        return self.of_status(outcome, kind, found, fired[0], lasting)

    def of_status(self, outcome, kind, found, call, lasting):
        """What is wrong with its exit status or message, or None."""
        if outcome.status == 4:
            record = json.loads(found["run.json"]) if "run.json" in found and call.name else {}
            if record.get("outcome") == "failed" and record["exit_status"] not in (4, 2, 3):
                return f"run.json has exit status {record['exit_status']}"
            if names_the_fault(outcome.errors, call, kind) or lasting and \
                    REASONS[kind] in outcome.errors:
                return None
            return f"does not name the file and the reason: {outcome.errors.strip()[-SHOWN:]}"
        checks = found.get("checks.jsonl", b"").decode(errors="replace")
        if outcome.status == 1 and (names_the_fault(checks, call, kind) or
                                    lasting and REASONS[kind] in checks):
            return None  # a program of the suite failed, and its checks state why
        if outcome.status == self.status and call.paths[0].startswith("/proc/"):
            return None  # what a page says of the machine is then another word
        if outcome.status == self.status and (may_ignore(call) or lasting):
            return self.unlike(outcome, {name: content for name, content in found.items()
                                         if not name.endswith(SUFFIX)})
        return f"exit {outcome.status}, not 4: {outcome.errors.strip()[-SHOWN:]}"
