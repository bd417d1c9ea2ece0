# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sweep will cost, from caudal --check: --dry-run."""

import re

import pandas as pd

from .case import call, find_cause


def describe_time(seconds):
    """A duration as the program writes it."""
    total = round(seconds)
    return (f"{total // 3600}:{total // 60 % 60:02d}" if total >= 3600 else f"{total // 60}") \
        + f":{total % 60:02d}"


def read_time(text):
    """The seconds of "1:02:03" or "2:03"."""
    return sum(float(part) * 60**k for k, part in enumerate(reversed(text.split(":"))))


def read_check(text):
    """Time [s] at least and at most, disk and memory [MiB] that --check tells; None where it does
    not, as in models whose runs take seconds."""
    time = re.search(r"steps on these cells take about ([\d:]+)(?:, ([\d:]+) on)?", text)
    memory = re.search(r"of wall time each and (\S+) MiB", text)
    disk = re.search(r"Disk: up to (\S+) MiB for fields at \d+ times, (\S+) MiB", text)
    return {"time": time and read_time(time[1]), "at most": time and read_time(time[2] or time[1]),
            "disk [MiB]": disk and float(disk[1]) + float(disk[2]),
            "memory [MiB]": memory and float(memory[1])}


def check_jobs(jobs, recall):
    """The table: a row for each run, with the cause if it can't be made."""
    rows = []
    for job in jobs:
        if recall(job):
            rows.append({"run": job.name, "state": f"{job.state}, known", **read_check("")})
            continue
        text, code = call(["--check", job.case.prm, *job.case.make_options(job.point)])
        rows.append({"run": job.name, "state": "to be made" if code == 0 else
                     f"can't be made: {find_cause(text, code)}", **read_check(text)})
        print(f"[{len(rows)}/{len(jobs)}] {job.name}: {rows[-1]['state']}", flush=True)
    return pd.DataFrame(rows)


def describe(table, n_at_once):
    """The sums in words."""
    wanted = table[table["state"] == "to be made"]
    told = wanted.dropna(subset=["time"])
    refused = int(table["state"].str.startswith("can't").sum())
    lines = [f"{len(table)} runs: {len(wanted)} to be made, {n_at_once} at a time, "
             f"{len(table) - len(wanted) - refused} known already"
             + (f", {refused} can't be made" if refused else "") + "."]
    if len(told):
        share = max(told["time"].sum() / n_at_once, told["time"].max())
        most = max(told["at most"].sum() / n_at_once, told["at most"].max())
        lines.append(f"Time: about {describe_time(share)}"
                     + (f" to {describe_time(most)} if the wake asks for all cells that it may"
                        if most > 1.05 * share else "") +
                     f" (runs side by side slow each other down); disk: up to "
                     f"{told['disk [MiB]'].sum():.3g} MiB; memory: about "
                     f"{told['memory [MiB]'].nlargest(n_at_once).sum():.0f} MiB.")
    if len(told) < len(wanted):
        lines.append(f"The program tells no costs of {len(wanted) - len(told)} of them; in the models "
                     "potential, passage and elastic a run takes seconds.")
    return lines
