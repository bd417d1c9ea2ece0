# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of caudal and their results."""

import csv
import pathlib
import re
import resource
import subprocess

import numpy as np

from caudal_plots.program import ENVIRONMENT, PROGRAM, RESULTS, ROOT


class RunError(Exception):
    """A run failed; the text is what it said."""


def run(case, folder, overrides=(), is_done=None):
    """Runs a case into a folder, unless it holds that very run. Returns s of CPU, or None."""
    folder = pathlib.Path(folder)
    command = [str(PROGRAM), str(case), "-D", f"Output/Folder={folder}",
               "-D", "Output/Existing results=replace"]
    for override in overrides:
        command += ["-D", override]
    note = "\n".join(command[1:]) + "\n" + pathlib.Path(case).read_text()
    stamp = folder / "plots" / "command.txt"
    if stamp.is_file() and stamp.read_text() == note and (folder / "summary.csv").is_file():
        return None
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True,
                            env=ENVIRONMENT, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if result.returncode != 0:
        raise RunError(f"{' '.join(command)}\n{result.stderr.strip()}")
    stamp.parent.mkdir(exist_ok=True)
    stamp.write_text(note)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def get_peak_memory():
    """Of the largest run until now [MiB]."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def read_summary(folder):
    """A dictionary for each frequency, by the names of the columns without their units."""
    with open(pathlib.Path(folder) / "summary.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    names = [name.partition(" [")[0] for name in rows[0]]
    return [dict(zip(names, map(float, row))) for row in rows[1:]]


def read_statistics(folder, frequency):
    """The columns over time, by name without unit."""
    folder = pathlib.Path(folder)
    path = folder / "statistics.txt"
    if not path.is_file():
        path = folder / f"statistics_{frequency:g}Hz.txt"
    with open(path, encoding="utf-8") as file:
        names = [match.group(1) for line in file
                 if (match := re.match(r"#\s*\d+:\s*(.*?)(?: \[[^[]*\])?\s*$", line))]
    return dict(zip(names, np.loadtxt(path).T))


def read_log(folder, pattern):
    """The numbers of the first match of a regular expression in log.txt."""
    match = re.search(pattern, (pathlib.Path(folder) / "log.txt").read_text(encoding="utf-8"))
    return [float(group) for group in match.groups()] if match else None
