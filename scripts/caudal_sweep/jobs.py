# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of a sweep: side by side, each of them once, going on from their checkpoints."""

import concurrent.futures
import dataclasses
import os
import pathlib
import signal
import subprocess
import time

from caudal_plots.program import ENVIRONMENT, PROGRAM, get_mpirun

from . import SweepError, progress
from .case import call, find_cause
from .design import name_point
from .records import ANEW, GOES_ON, KNOWN, NEW, Plan

INTERVAL = 60.  # seconds between two lines that tell how far the runs are
MOST_FAULTS = 5  # that a message names
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
    plan: Plan = dataclasses.field(default_factory=lambda: Plan(NEW))

    def __post_init__(self):
        self.settings = self.case.get_settings(self.point)
        self.files = self.case.get_files(self.point)

    @property
    def printed(self):
        """The file of what the run printed."""
        return self.folder.with_name(self.folder.name + ".txt")


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
        self.running, self.durations = {}, []  # {process: (job, start)}; seconds
        self.is_stopped = False

    def make_plans(self, jobs):
        """Finds what is to be done about each run; what is known is taken over."""
        for job in jobs:
            job.plan = self.records.plan(job, self.retries)
            if job.plan.kind == KNOWN:
                self.records.recall(job)

    def check_values(self, jobs):
        """SweepError, before any run starts, if the program would refuse one that is to be made."""
        missing = [job for job in jobs if job.plan.kind != KNOWN]
        with concurrent.futures.ThreadPoolExecutor(self.n_at_once) as pool:
            faults = list(pool.map(lambda job: job.case.find_fault(job.point), missing))
        told = [f"{job.name} can't be made: {fault}" for job, fault in zip(missing, faults) if fault]
        if told:
            more = [f"and {len(told) - MOST_FAULTS} more"] if len(told) > MOST_FAULTS else []
            raise SweepError("\n  ".join([*told[:MOST_FAULTS], *more, "No run was started."]))

    def run(self, jobs, look_at_first=None):
        """Runs what is to be run; whether all came to an end, be it a failure. @p look_at_first is
        called with the first run that finishes."""
        self.make_plans(jobs)
        missing = [job for job in jobs if job.plan.kind != KNOWN]
        old = {name: signal.signal(name, self.stop) for name in SIGNALS}
        try:
            with concurrent.futures.ThreadPoolExecutor(self.n_at_once) as pool:
                self.watch({pool.submit(self.work, job) for job in missing}, look_at_first)
        finally:
            for name, handler in old.items():
                signal.signal(name, handler)
        return all(job.state in ("finished", "failed") for job in jobs)

    def watch(self, tasks, look_at_first):
        """Tells of each run that ends and, every minute, how far the others are."""
        n_tasks, n_ended, last = len(tasks), 0, time.time()
        while tasks:
            ended, tasks = concurrent.futures.wait(
                tasks, timeout=max(last + INTERVAL - time.time(), 0),
                return_when=concurrent.futures.FIRST_COMPLETED)
            for job in (task.result() for task in ended):
                if job.state == "not started":
                    continue
                n_ended += 1
                print(f"{job.name}: {job.state} ({n_ended} of {n_tasks})"
                      + (f": {job.cause}" if job.cause else ""), flush=True)
                if job.state == "finished" and look_at_first:
                    look_at_first(job)
                    look_at_first = None
            if time.time() >= last + INTERVAL:
                last = time.time()
                self.tell_progress(len(tasks))

    def tell_progress(self, n_left):
        """A line on how far the runs are."""
        running = list(self.running.items())
        if running and not self.is_stopped:
            print(progress.describe([job.printed for _, (job, _) in running],
                                    [start for _, (_, start) in running], n_left - len(running),
                                    self.durations, self.n_at_once), flush=True)

    def get_command(self, job):
        """The command of a run. One that was broken off before its first checkpoint is made anew
        in its place; results that the sweep knows nothing of are kept beside it by the program."""
        start = get_mpirun(self.ranks) if self.ranks > 1 else []
        command = [*start, str(PROGRAM)]
        command += ["--resume-or-start"] if job.plan.kind == GOES_ON else []
        command += [str(job.case.prm), *job.case.make_options(job.point),
                    "-D", f"Output/Folder={job.folder}"]
        if job.plan.kind == ANEW:
            command += ["-D", "Output/Existing results=replace"]
        return command

    def work(self, job):
        """One run, in a session of its own: a terminal's Ctrl-C reaches it by stop() only."""
        if self.is_stopped:
            return job
        command = self.get_command(job)
        self.records.note(job, self.version)
        job.folder.parent.mkdir(parents=True, exist_ok=True)
        with open(job.printed, "w", encoding="utf-8") as file:
            try:
                process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file,
                                           stderr=subprocess.STDOUT, start_new_session=True,
                                           env=ENVIRONMENT)
            except OSError as error:
                raise SweepError(f"{command[0]} can't be started: {error}.") from error
            start = time.time()
            self.running[process] = job, start
            if self.is_stopped:  # since the look at it above
                process.send_signal(signal.SIGUSR1)
            code = process.wait()
            del self.running[process]
            self.durations.append(time.time() - start)
        job.state = "finished" if code == 0 else "stopped" if code == STOPPED else "failed"
        if job.state == "failed":
            job.cause = find_cause(job.printed.read_text(encoding="utf-8", errors="replace"), code)
        self.records.note(job, self.version)
        return job

    def stop(self, *_):
        """Lets the runs write their checkpoints and end; mpirun hands on this signal only."""
        print("Stopping: the runs finish their step and write checkpoints.", flush=True)
        self.is_stopped = True
        for process in list(self.running):
            process.send_signal(signal.SIGUSR1)

    def find_other_versions(self, jobs):
        """Names of other versions of the program that known runs are of."""
        versions = {self.records.runs[job.name].get("program", self.version) for job in jobs
                    if job.name in self.records.runs}
        return sorted(versions - {self.version})
