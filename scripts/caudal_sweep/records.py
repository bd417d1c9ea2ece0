# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sweep's folder holds: what became of each run, with which settings it was made, how far it
came, and so what is to be done about it."""

import dataclasses
import fcntl
import json
import os
import pathlib
import re
import threading

from caudal import MissingData, read_progress
from caudal.parameters import read_parameters

from . import SweepError
from .case import WITHOUT_EFFECT

END_TIME = "Time/End time"
MOST_CHANGES = 5    # that a message names
LONGEST_VALUE = 40  # that a message shows, in characters

# What is to be done about a run.
KNOWN, NEW, ANEW, GOES_ON, REFUSED = "known", "new", "anew", "goes on", "refused"


@dataclasses.dataclass
class Plan:
    """What is to be done about a run, with what is there of it."""

    kind: str
    changes: tuple = ()   # of settings, in words
    start: float = 0.     # the time [s] of the checkpoint that it goes on from
    end: float = None     # its end time [s]; None where it has none
    is_longer: bool = False  # than the run that is there

    def describe(self):
        """In words; "to be made" if nothing is there that counts."""
        if self.kind != GOES_ON:
            return "to be made"
        if self.end is None:
            return f"goes on from {self.start:g} s"
        return f"goes on from {self.start:g} {'to' if self.is_longer else 'of'} {self.end:g} s"

    @property
    def share(self):
        """Of the run that is still to be made."""
        return 1 - self.start / self.end if self.kind == GOES_ON and self.end else 1.


def show_folder(folder):
    """A folder as one would type it here."""
    path = pathlib.Path(folder)
    return path.relative_to(pathlib.Path.cwd()) if path.is_relative_to(pathlib.Path.cwd()) else path


def read_number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def are_same(one, other):
    """Whether two values, as text, mean the same: 4 and 4.0 do."""
    numbers = read_number(one), read_number(other)
    return "".join(one.split()) == "".join(other.split()) if None in numbers else \
        numbers[0] == numbers[1]


def shorten(text):
    """A value as a message shows it."""
    text = " ".join(text.split())
    return text if len(text) <= LONGEST_VALUE else text[:LONGEST_VALUE] + " ..."


def find_checkpoint(folder):
    """The time [s] of a run's newest checkpoint; None if it has none."""
    times = []
    for path in sorted((folder / "restart").glob("*/manifest")):
        match = re.search(r"^time (\S+) s", path.read_text(encoding="utf-8", errors="replace"), re.MULTILINE)
        times += [float(match[1])] if match else []
    return times[-1] if times else None


def find_changed_settings(folder, record, wanted):
    """{entry: (before, now)} of what differs between a run that is there and one that is wanted. The
    truth is its parameters.prm, as a call that failed may have written down more; the record helps
    with entries that have other names there."""
    try:
        # Without a default beside it a value is the default.
        there = {f"{section}/{entry}".lstrip("/"): (value, value if default is None else default)
                 for section, entry, value, default in read_parameters(folder)}
    except MissingData:
        there = {}
    noted, changes = record.get("settings", {}), {}
    compared = {*noted, *wanted}
    if not noted and compared <= set(there):  # without entries of other names
        compared |= {entry for entry, (value, default) in there.items() if value != default}
    for entry in sorted(entry for entry in compared if not WITHOUT_EFFECT.fullmatch(entry)):
        value, default = there.get(entry, (noted.get(entry), None))
        before, now = value, wanted.get(entry, default)
        # Without a name in the results and in the record nothing is known of it.
        if before is None or now is None and entry not in noted:
            continue
        if now is None or not are_same(before, now):
            changes[entry] = (before, now)
    return changes


class Records:
    """sweep.json: what became of each run. One sweep at a time may write it; @p is_read_only, as for
    --dry-run, leaves the folder as it is."""

    def __init__(self, folder, is_read_only=False):
        self.path = folder / "sweep.json"
        self.mutex = threading.Lock()
        if not is_read_only:
            folder.mkdir(parents=True, exist_ok=True)
            self.lock = open(folder / "sweep.lock", "w", encoding="utf-8")
            try:
                fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                raise SweepError(f"{folder}: another sweep is at work there. Wait for it, or give "
                                 "another --folder.") from error
        try:
            self.runs = json.loads(self.path.read_text(encoding="utf-8"))
        except FileNotFoundError:
            self.runs = {}
        except ValueError as error:
            raise SweepError(f"{self.path} is damaged: {error}. Remove it: what is there of the runs "
                             "is found without it.") from error

    def note(self, job, version):
        """Writes down the state of a run."""
        with self.mutex:
            self.runs[job.name] = {"settings": job.settings, "files": job.files, "state": job.state,
                                   "cause": job.cause, "program": version}
            temporary = self.path.with_suffix(".tmp")
            temporary.write_text(json.dumps(self.runs, indent=1), encoding="utf-8")
            os.replace(temporary, self.path)

    def plan(self, job, retries=False):
        """What is to be done about a run."""
        progress = read_progress(job.folder)
        record = self.runs.get(job.name, {"state": progress, "cause": ""} if progress else None)
        end = read_number(job.settings.get(END_TIME))
        if record is None:
            return Plan(NEW, end=end)
        changes = find_changed_settings(job.folder, record, job.settings)
        words = [f"{entry} {shorten(before)}, now {'not set' if now is None else shorten(now)}"
                 for entry, (before, now) in changes.items()]
        words += [f"{name} has another content now" for name, digest in job.files.items()
                  if record.get("files", {}).get(name, digest) != digest]
        checkpoint = find_checkpoint(job.folder)
        if not words:
            if record["state"] == progress == "finished" or record["state"] == "failed" and not retries:
                return Plan(KNOWN)
            return Plan(ANEW, end=end) if checkpoint is None else Plan(GOES_ON, (), checkpoint, end)
        before = read_number(changes.get(END_TIME, (None,))[0])
        if len(words) == 1 and checkpoint is not None and None not in (before, end) and before < end:
            return Plan(GOES_ON, tuple(words), checkpoint, end, is_longer=True)
        is_worth_something = checkpoint is not None or progress == "finished"
        return Plan(REFUSED if is_worth_something else ANEW, tuple(words), end=end)

    def recall(self, job):
        """Takes over what became of a run that is known."""
        record = self.runs.get(job.name, {"state": "finished", "cause": ""})
        job.state, job.cause = record["state"], record["cause"]


def refuse_others(plans, folder):
    """SweepError if runs that are there were made with other settings."""
    changes = list(dict.fromkeys(change for plan in plans if plan.kind == REFUSED
                                 for change in plan.changes))
    if changes:
        more = f"; and {len(changes) - MOST_CHANGES} more" if len(changes) > MOST_CHANGES else ""
        raise SweepError(f"{show_folder(folder)} was made with other settings: "
                         f"{'; '.join(changes[:MOST_CHANGES])}{more}. Give another --folder, or the "
                         "old settings. No run was started.")
