# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of a sweep: side by side, each of them once, going on from their checkpoints."""

import concurrent.futures
import dataclasses
import fcntl
import json
import os
import pathlib
import signal
import subprocess
import threading

from caudal import read_progress
from caudal_plots.program import ENVIRONMENT, PROGRAM, get_mpirun

from . import SweepError
from .case import call, find_cause
from .design import name_point

STOPPED = 2  # the program's exit code with a checkpoint to go on from
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


@dataclasses.dataclass
class Job:
    """A run of the sweep: what is set in it, where its results are, and what became of it."""

    name: str
    case: object
    point: dict
    folder: pathlib.Path
    state: str = "not started"  # then finished, failed, stopped
    cause: str = ""             # of a failure
    is_new: bool = False        # run now, not known already

    def __post_init__(self):
        self.fingerprint = self.case.get_fingerprint(self.point)

    @property
    def printed(self):
        """The file of what the run printed."""
        return self.folder.with_name(self.folder.name + ".txt")


class Records:
    """sweep.json: what became of each run. One sweep at a time may write it."""

    def __init__(self, folder):
        self.path = folder / "sweep.json"
        self.mutex = threading.Lock()
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
            raise SweepError(f"{self.path} is damaged: {error}. Remove it: runs whose results are "
                             "there are made again, and the old ones kept beside them.") from error

    def note(self, job, version):
        """Writes down the state of a run."""
        with self.mutex:
            self.runs[job.name] = {"fingerprint": job.fingerprint, "state": job.state,
                                   "cause": job.cause, "program": version}
            temporary = self.path.with_suffix(".tmp")
            temporary.write_text(json.dumps(self.runs, indent=1), encoding="utf-8")
            os.replace(temporary, self.path)


def make_jobs(case, points, folder):
    """A job for each point of the sweep."""
    return [Job(name_point(point), case, point, folder / "runs" / name_point(point) / "results")
            for point in points]


def count_cores():
    return len(os.sched_getaffinity(0))


def get_version():
    """The first line of the program's version."""
    return call(["--version"])[0].partition("\n")[0]


class Runner:
    """Makes the runs that are not there yet; stops them, with checkpoints, when it is told to."""

    def __init__(self, records, ranks=1, n_at_once=None, retries=False):
        self.records = records
        n_at_once = n_at_once or max(count_cores() // ranks, 1)
        self.ranks, self.n_at_once, self.retries = ranks, n_at_once, retries
        self.version = get_version()
        self.processes, self.is_stopped = set(), False

    def run(self, jobs):
        """Runs what is to be run; whether all came to an end, be it a failure."""
        missing = [job for job in jobs if not self.recall(job)]
        known = len(jobs) - len(missing)
        if known:
            print(f"{known} of {len(jobs)} runs are known already", flush=True)
        old = {name: signal.signal(name, self.stop) for name in SIGNALS}
        try:
            with concurrent.futures.ThreadPoolExecutor(self.n_at_once) as pool:
                tasks = [pool.submit(self.work, job) for job in missing]
                for number, task in enumerate(concurrent.futures.as_completed(tasks), 1):
                    job = task.result()
                    if job.state != "not started":
                        print(f"[{number}/{len(missing)}] {job.name}: {job.state}"
                              + (f": {job.cause}" if job.cause else ""), flush=True)
        finally:
            for name, handler in old.items():
                signal.signal(name, handler)
        return all(job.state in ("finished", "failed") for job in jobs)

    def recall(self, job):
        """Whether the run came to its end before, with these parameters."""
        record = self.records.runs.get(job.name)
        if not record or record["fingerprint"] != job.fingerprint:
            return False
        is_there = record["state"] == "finished" and read_progress(job.folder) == "finished"
        has_failed = record["state"] == "failed" and not self.retries
        if is_there or has_failed:
            job.state, job.cause = record["state"], record["cause"]
        return is_there or has_failed

    def get_command(self, job):
        """The command of a run. One that was broken off before its first checkpoint is made anew
        in its place; results with other parameters are kept beside it by the program."""
        record = self.records.runs.get(job.name)
        is_same = record is not None and record["fingerprint"] == job.fingerprint
        has_checkpoint = any((job.folder / "restart").glob("*"))
        start = get_mpirun(self.ranks) if self.ranks > 1 else []
        command = [*start, str(PROGRAM)]
        command += ["--resume-or-start"] if is_same and has_checkpoint else []
        command += [str(job.case.prm), *job.case.make_options(job.point),
                    "-D", f"Output/Folder={job.folder}"]
        if is_same and not has_checkpoint:
            command += ["-D", "Output/Existing results=replace"]
        return command

    def work(self, job):
        """One run, in a session of its own: a terminal's Ctrl-C reaches it by stop() only."""
        if self.is_stopped:
            return job
        command = self.get_command(job)
        job.is_new = True
        self.records.note(job, self.version)
        job.folder.parent.mkdir(parents=True, exist_ok=True)
        with open(job.printed, "w", encoding="utf-8") as file:
            try:
                process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file,
                                           stderr=subprocess.STDOUT, start_new_session=True,
                                           env=ENVIRONMENT)
            except OSError as error:
                raise SweepError(f"{command[0]} can't be started: {error}.") from error
            self.processes.add(process)
            if self.is_stopped:  # since the look at it above
                process.send_signal(signal.SIGUSR1)
            code = process.wait()
            self.processes.discard(process)
        job.state = "finished" if code == 0 else "stopped" if code == STOPPED else "failed"
        if job.state == "failed":
            job.cause = find_cause(job.printed.read_text(encoding="utf-8", errors="replace"), code)
        self.records.note(job, self.version)
        return job

    def stop(self, *_):
        """Lets the runs write their checkpoints and end; mpirun hands on this signal only."""
        print("Stopping: the runs finish their step and write checkpoints.", flush=True)
        self.is_stopped = True
        for process in list(self.processes):
            process.send_signal(signal.SIGUSR1)

    def find_other_versions(self, jobs):
        """Names of other versions of the program that known runs are of."""
        versions = {self.records.runs[job.name]["program"] for job in jobs
                    if job.name in self.records.runs}
        return sorted(versions - {self.version})
