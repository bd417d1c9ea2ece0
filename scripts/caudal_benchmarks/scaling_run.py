# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run of caudal on some ranks: seconds, memory, messages and collective calls of each rank.

Messages and bytes are those of Open MPI's component pml_monitoring; collective calls and the time
within MPI are counted by mpi_counts.c, which mpicc ($MPICC) compiles. What is not there counts
nothing, and the figures are None."""

import dataclasses
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import time

from caudal import Run
from caudal_plots.program import ENVIRONMENT, PROGRAM, ROOT, get_mpirun, read_program

from .runs import RunError, read_with_includes
from .timed_run import TICK

COUNTER = pathlib.Path(__file__).resolve().parent / "mpi_counts.c"


@dataclasses.dataclass
class Record:
    """What was measured of a run; of lists, an element for each rank."""
    ranks: int
    steps: int
    cells: int
    wall: float  # [s], of all steps, by the program's own clock
    sections: dict  # [s], of rank 0
    cpu: list  # [s], user time
    memory: list  # [MiB], the largest
    iterations: list  # of each step
    figures: dict  # column of statistics.txt: last value
    messages: list = None
    bytes: list = None
    calls: dict = None  # collective calls of rank 0
    work: list = None  # [s], processor time outside of MPI, without waiting for others


@dataclasses.dataclass
class Cost:
    """What a step costs: the difference of a longer run and a shorter one, which both start."""
    short: Record
    long: Record

    @property
    def steps(self):
        return self.long.steps - self.short.steps

    def _get_difference(self, after, before):
        return None if after is None or before is None else [
            (a - b) / self.steps for a, b in zip(after, before)]

    @property
    def wall(self):
        return (self.long.wall - self.short.wall) / self.steps

    @property
    def sections(self):
        return {name: (seconds - self.short.sections.get(name, 0.)) / self.steps
                for name, seconds in self.long.sections.items()}

    @property
    def cpu(self):
        return self._get_difference(self.long.cpu, self.short.cpu)

    @property
    def work(self):
        return self._get_difference(self.long.work, self.short.work)

    @property
    def messages(self):
        return self._get_difference(self.long.messages, self.short.messages)

    @property
    def bytes(self):
        return self._get_difference(self.long.bytes, self.short.bytes)

    @property
    def calls(self):
        return None if self.long.calls is None or self.short.calls is None else {
            kind: calls for kind, total in sorted(self.long.calls.items())
            if (calls := (total - self.short.calls.get(kind, 0)) / self.steps) > 0}

    @property
    def iterations(self):
        return sum(self.long.iterations[self.short.steps:]) / self.steps


def parse_monitoring(text):
    """Messages and bytes that a rank has sent to others, by a file of Open MPI's monitoring."""
    sent = [(int(n_messages), int(n_bytes)) for source, target, n_bytes, n_messages in re.findall(
        r"^[EI]\t(\d+)\t(\d+)\t(\d+) bytes\t(\d+) msgs", text, re.MULTILINE) if source != target]
    return sum(messages for messages, _ in sent), sum(n_bytes for _, n_bytes in sent)


def parse_counts(text):
    """Collective calls by kind, and seconds outside of MPI, by a file of mpi_counts.c."""
    values = dict(line.split() for line in text.splitlines())
    seconds = float(values.pop("seconds")) - float(values.pop("seconds_in_mpi"))
    return {kind: int(calls) for kind, calls in values.items()}, seconds


def parse_output(text):
    """Steps, cells, wall time and the sections' seconds, by what a run printed."""
    end = re.search(r"^(\d+) steps in .*?, (\S+) steps/s", text, re.MULTILINE)
    cells = re.findall(r"(\d+) cells, \d+ iterations", text)
    if not end or not cells:
        raise RunError(f"no table of costs in: {text.strip()[-500:]}")
    sections = re.findall(r"^  (\S.*?) +([\d.]+) s +[\d.]+ %$", text, re.MULTILINE)
    return (int(end.group(1)), int(cells[-1]), int(end.group(1)) / float(end.group(2)),
            {name: float(seconds) for name, seconds in sections})


def build_counter(folder):
    """The library that counts collective calls, or None if there is no compiler for MPI."""
    compiler = os.environ.get("MPICC") or next(
        filter(shutil.which, ["mpicc.openmpi", "mpicc"]), None)
    library = folder / "mpi_counts.so"
    if compiler is None:
        return None
    result = subprocess.run([compiler, "-O2", "-shared", "-fPIC", str(COUNTER), "-o", str(library)],
                            capture_output=True, text=True, check=False)
    return library if result.returncode == 0 else None


def find_ranks(pid, ranks):
    """The processes of the ranks: this one, or mpirun's children."""
    if ranks == 1:
        return [pid]
    path = pathlib.Path(f"/proc/{pid}/task/{pid}/children")
    return [int(child) for child in path.read_text(encoding="utf-8").split()][:ranks]


def read_usage(pid):
    """User time [s] and largest memory [MiB] of a process so far."""
    folder = pathlib.Path(f"/proc/{pid}")
    fields = (folder / "stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
    memory = re.search(r"VmHWM:\s+(\d+) kB", (folder / "status").read_text(encoding="utf-8"))
    return int(fields[11]) / TICK, int(memory.group(1)) / 1024


def follow(process, ranks):
    """What a process prints, and the usage of its ranks when it printed for the last time."""
    lines, usage = [], [(0., 0.)] * ranks
    for line in process.stdout:
        lines.append(line)
        try:
            usage = [read_usage(pid) for pid in find_ranks(process.pid, ranks)]
        except (OSError, AttributeError):  # a rank has just ended
            pass
    return "".join(lines), usage


def read_ranks(stem, ranks, suffix, parse):
    """What each rank wrote into its file, or None if one is missing."""
    paths = [pathlib.Path(f"{stem}.{rank}{suffix}") for rank in range(ranks)]
    if not all(path.is_file() for path in paths):
        return None
    return [parse(path.read_text(encoding="utf-8")) for path in paths]


def make_record(folder, ranks, text, usage):
    steps, cells, wall, sections = parse_output(text)
    results = Run(folder / "run")
    columns = [name for name in results.statistics.columns
               if "force" in name and "fluid" in name or name.startswith("kinetic energy")]
    record = Record(ranks, steps, cells, wall, sections, [cpu for cpu, _ in usage],
                    [memory for _, memory in usage], [int(n) for n in results.get("iterations")],
                    {name: float(results.statistics[name].iloc[-1]) for name in columns})
    sent = read_ranks(folder / "sent", ranks, ".prof", parse_monitoring)
    if sent is None and ranks == 1:
        sent = [(0, 0)]
    if sent is not None:
        record.messages, record.bytes = map(list, zip(*sent))
    if counts := read_ranks(folder / "calls", ranks, "", parse_counts):
        record.calls, record.work = counts[0][0], [seconds for _, seconds in counts]
    return record


def launch(prm, overrides, folder, ranks, counter):
    """Runs a case; returns its Record."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    # A rank that waits gives way to others: see mpi_counts.c.
    environment = {**ENVIRONMENT, "OMPI_MCA_rmaps_base_oversubscribe": "1",
                   "OMPI_MCA_mpi_yield_when_idle": "1",
                   "OMPI_MCA_pml_monitoring_enable": "2",
                   "OMPI_MCA_pml_monitoring_enable_output": "3",
                   "OMPI_MCA_pml_monitoring_filename": str(folder / "sent")}
    command = get_mpirun(ranks) if ranks > 1 else []
    if counter:
        command += ["env", f"CAUDAL_MPI_COUNTS={folder / 'calls'}", f"LD_PRELOAD={counter}"]
    command += [str(PROGRAM), str(prm)]
    for override in (*overrides, f"Output/Folder={folder / 'run'}"):
        command += ["-D", override]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          stdin=subprocess.DEVNULL, text=True, env=environment) as process:
        text, usage = follow(process, ranks)
    if process.returncode != 0:
        raise RunError(f"{' '.join(command)}: {text.strip()[-500:]}")
    return make_record(folder, ranks, text, usage)


def measure(prm, overrides, folder, ranks, counter, only_known=False):
    """The Record of a case, from a file if that very run was measured before; None if it was not
    and @p only_known."""
    text = "\n".join([*read_with_includes(ROOT / prm), *overrides, str(ranks), str(bool(counter))])
    fingerprint = hashlib.sha256(text.encode() + read_program()).hexdigest()
    path = folder.with_suffix(".json")
    if path.is_file():
        known = json.loads(path.read_text(encoding="utf-8"))
        if known["fingerprint"] == fingerprint:
            return Record(**known["record"])
    if only_known:
        return None
    begin = time.time()
    record = launch(prm, overrides, folder, ranks, counter)
    print(f"  {folder.name}: {record.cells} cells, {time.time() - begin:.0f} s", flush=True)
    path.write_text(json.dumps({"fingerprint": fingerprint, "record": dataclasses.asdict(record)},
                               indent=1), encoding="utf-8")
    return record
