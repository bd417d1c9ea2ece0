# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run of caudal whose processor time is read while it goes on."""

import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import time

from caudal import Run
from caudal_plots.program import ENVIRONMENT, PROGRAM, RESULTS, ROOT, get_mpirun

from .runs import RunError

TICK = os.sysconf("SC_CLK_TCK")


@dataclasses.dataclass
class Case:
    """A .prm file and what is changed in it."""
    name: str
    prm: str
    overrides: tuple = ()


class TimedRun:
    """What a run printed, with the seconds (wall, processor) at which it did."""

    def __init__(self, folder, lines):
        self.lines = lines
        text = "\n".join(line for _, _, line in lines)
        self.cells = int(re.findall(r"(\d+) cells, \d+ iterations", text)[-1])
        self.unknowns = sum(map(int, re.search(
            r"(\d+) velocity and (\d+) pressure unknowns", text).groups()))
        costs = re.search(r"(\d+) factorisations of up to (\S+) entries, (\d+) MiB", text)
        self.factorisations, self.memory = int(costs.group(1)), float(costs.group(3))
        self.factor_entries = float(costs.group(2))
        sections = re.findall(r"^  (\S.*?) +([\d.]+) s +([\d.]+) %$", text, re.MULTILINE)
        self.seconds = {name: float(seconds) for name, seconds, _ in sections}
        self.shares = {name: float(share) for name, _, share in sections}
        iterations = Run(folder).get("iterations")
        self.iterations, self.iterations_per_step = sum(iterations), iterations.mean()
        self.largest_iterations = int(iterations.max())
        self.steps = [(float(match.group(1)), int(match.group(2)), wall, cpu)
                      for wall, cpu, line in lines
                      if (match := re.match(r"t = (\S+) of .*  step (\d+)", line))]

    def _get_since(self, is_before):
        """Time, step, wall and processor seconds of the last line before the part and of the end."""
        return next((step for step in reversed(self.steps[:-1]) if is_before(step)),
                    self.steps[0]), self.steps[-1]

    def get_last(self, duration):
        """Processor seconds, simulated seconds and steps of at least the last @p duration."""
        end = self.steps[-1][0]
        begin, end = self._get_since(lambda step: step[0] <= end - duration)
        return end[3] - begin[3], end[0] - begin[0], end[1] - begin[1]

    def get_last_steps(self, number):
        """The same of at least the last steps."""
        last = self.steps[-1][1]
        begin, end = self._get_since(lambda step: step[1] <= last - number)
        return end[3] - begin[3], end[0] - begin[0], end[1] - begin[1]

    def get_last_wall(self, number):
        """Wall time of at least the last steps."""
        last = self.steps[-1][1]
        begin, end = self._get_since(lambda step: step[1] <= last - number)
        return end[2] - begin[2]


def get_banner():
    """The versions and the BLAS of the program, in a line."""
    text = subprocess.run([str(PROGRAM), "--version"], capture_output=True, text=True, check=True,
                          env=ENVIRONMENT).stdout
    return ", ".join(" ".join(line.split()) for line in text.strip().splitlines())


def get_cpu_seconds(pid):
    """User and system time of a process and of the children of mpirun."""
    pids = [pid] + [int(child) for child in pathlib.Path(
        f"/proc/{pid}/task/{pid}/children").read_text(encoding="utf-8").split()]
    total = 0
    for one in pids:
        fields = pathlib.Path(f"/proc/{one}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1]
        total += sum(map(int, fields.split()[11:13]))
    return total / TICK


def get_step(prm):
    """The entry Time/Step of a case."""
    text = (ROOT / prm).read_text(encoding="utf-8")
    match = re.search(r"subsection Time\b.*?set Step\s*=\s*(\S+)", text, re.DOTALL)
    return float(match.group(1)) if match else get_step(
        pathlib.Path(prm).parent / re.search(r"^\s*include (\S+)", text, re.MULTILINE).group(1))


def run(case, folder, end_time=None, steps=None, ranks=1):
    """Runs a case to a time or for some steps; returns the TimedRun."""
    shutil.rmtree(folder, ignore_errors=True)
    if steps is not None:
        end_time = steps * get_step(case.prm)
    command = get_mpirun(ranks) if ranks > 1 else []
    command += [str(PROGRAM), case.prm]
    for override in (*case.overrides, f"Output/Folder={folder}", f"Time/End time={end_time}"):
        command += ["-D", override]
    lines = []
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          stdin=subprocess.DEVNULL, text=True, env=ENVIRONMENT) as process:
        for line in process.stdout:
            cpu = get_cpu_seconds(process.pid) if line.startswith("t = ") else 0.
            lines.append((time.perf_counter(), cpu, line.rstrip("\n")))
    if process.returncode != 0:
        raise RunError(f"{' '.join(command)}: {lines[-1][2] if lines else 'no output'}")
    return TimedRun(folder, lines)
