# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sweep will cost, from caudal --check: --dry-run."""

import re

import pandas as pd

from .case import call, find_cause
from .progress import read_duration
from .records import GOES_ON, KNOWN


def describe_time(seconds):
    """A duration as the program writes it."""
    total = round(seconds)
    return (f"{total // 3600}:{total // 60 % 60:02d}" if total >= 3600 else f"{total // 60}") \
        + f":{total % 60:02d}"


def read_check(text):
    """Time [s] at least and at most, disk and memory [MiB] that --check tells; None where it does
    not, as in models whose runs take seconds."""
    time = re.search(r"steps on these cells take about ([\d:]+)(?:, ([\d:]+) on)?", text)
    memory = re.search(r"of wall time each and (\S+) MiB", text)
    disk = re.search(r"Disk: up to (\S+) MiB for fields at \d+ times, (\S+) MiB", text)
    return {"time": time and read_duration(time[1]), "at most": time and read_duration(time[2] or time[1]),
            "disk [MiB]": disk and float(disk[1]) + float(disk[2]),
            "memory [MiB]": memory and float(memory[1])}


def read_warnings(text):
    """What --check finds doubtful."""
    return re.findall(r"^Warning: (.*)", text, re.MULTILINE)


def check_jobs(jobs):
    """The table: a row for each run, with what is to be done or why it can't be made, its costs, and
    the warnings. Of a run that goes on only the rest costs time."""
    rows = []
    for job in jobs:
        if job.plan.kind == KNOWN:
            rows.append({"run": job.name, "state": f"{job.state}, known", **read_check(""),
                         "warnings": []})
            continue
        text, code = call(["--check", job.case.prm, *job.case.make_options(job.point)])
        state = job.plan.describe() if code == 0 else f"can't be made: {find_cause(text, code)}"
        costs = read_check(text)
        for name in ("time", "at most"):
            costs[name] = costs[name] and costs[name] * job.plan.share
        rows.append({"run": job.name, "state": state, **costs, "warnings": read_warnings(text)})
        print(f"[{len(rows)}/{len(jobs)}] {job.name}: {state}", flush=True)
    return pd.DataFrame(rows)


def list_warnings(table):
    """The warnings in lines: those of all runs once, then those of each."""
    found = [(run, words) for run, words, state in zip(table["run"], table["warnings"], table["state"])
             if not state.endswith("known") and not state.startswith("can't")]
    shared = [text for text in found[0][1] if all(text in words for _, words in found)] if found else []
    lines = [f"Warning, all runs: {text}" for text in shared] if len(found) > 1 else []
    return lines + [f"Warning, {run}: {text}" for run, words in found for text in words
                    if text not in shared or len(found) == 1]


def describe(table, n_at_once):
    """The sums in words."""
    refused = int(table["state"].str.startswith("can't").sum())
    going_on = int(table["state"].str.startswith(GOES_ON).sum())
    known = int(table["state"].str.endswith("known").sum())
    wanted = table[(table["state"] == "to be made") | table["state"].str.startswith(GOES_ON)]
    told = wanted.dropna(subset=["time"])
    lines = [f"{len(table)} runs: {len(wanted) - going_on} to be made, "
             + (f"{going_on} going on, " if going_on else "")
             + f"{n_at_once} at a time, {known} known already"
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
