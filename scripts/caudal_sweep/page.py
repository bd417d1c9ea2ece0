# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a sweep: what was varied, table, plots, failures, and links to each run's page."""

import contextlib
import io
import os
import urllib.parse

import pandas as pd

from caudal_report import page
from caudal_report.common import draw_picture

from .design import shorten
from .table import REMARK, RUN, STATE, get_figures


def make_run_pages(jobs, model):
    """Writes the page of each finished run that has none yet; pictures are left to scripts/report.
    Returns what went wrong. Bodies without a fluid have no pages."""
    troubles = []
    if model == "elastic":
        return troubles
    from caudal_report import main as run_report  # which loads VTK
    for job in jobs:
        report, written = job.folder / "report.html", job.folder / "manifest.txt"
        if job.state != "finished" or (report.is_file() and written.is_file() and
                                       report.stat().st_mtime >= written.stat().st_mtime):
            continue
        said = io.StringIO()
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
            code = run_report.main([str(job.folder), "--frames", "0", "--no-pictures"])
        if code != 0:
            troubles.append(f"{job.name}: {said.getvalue().strip()}")
    return troubles


def make_link(job, folder, text):
    """Words that lead to the page of a run or, if it failed, to what it printed."""
    target = job.folder / "report.html"
    if not target.is_file():
        target = job.printed
    if not target.is_file():
        return page.escape(text)
    return page.Html('<a href="{}">{}</a>').format(
        urllib.parse.quote(os.path.relpath(target, folder)), text)


def make_results(table, axes, entries, model, links):
    """The table of finished runs; headers are short and have the units small."""
    labels = {**shorten(entries), **{axis.entry: axis.label for axis in axes}}
    done = table[table[STATE] == "finished"]
    shown = [name for name in table if name not in (STATE,)]
    header = []
    for name in shown:
        words, _, unit = labels.get(name, name).partition(" [")
        header.append(page.escape(words) + (page.Html("<br>") + page.make_element("small", f"[{unit}")
                                            if unit else ""))
    figures = get_figures(table, entries, model)
    rows = [[links[row[RUN]] if name == RUN else
             page.format_number(row[name]) if name in figures else
             "–" if pd.isna(row[name]) else
             f"{row[name]:g}" if isinstance(row[name], float) else str(row[name])
             for name in shown] for row in done.to_dict("records")]
    words = [k for k, name in enumerate(shown) if name in (RUN, REMARK)]
    return page.make_table(header, rows, left=words) if rows else page.make_note("No run has finished.")


def describe(case, axes, entries, jobs, table, figure, folder):
    """The page."""
    states = {state: sum(job.state == state for job in jobs)
              for state in ("finished", "failed", "stopped", "not started")}
    summary = ", ".join(f"{count} {state}" for state, count in states.items() if count)
    report = page.Page(f"Caudal: sweep of {case.name}",
                       f"{len(jobs)} runs of the model {case.model}: {summary}.")
    links = {job.name: make_link(job, folder, str(number)) for number, job in enumerate(jobs, 1)}
    varied = page.make_table(
        ("entry", "values"), [(axis.entry + (f" [{axis.unit}]" if axis.unit else ""),
                               "; ".join(axis.values)) for axis in axes], left=(0, 1))
    if case.overrides:
        varied += page.make_note("In all runs: " + "; ".join(case.overrides))
    report.add("What was varied", varied)
    unsteady = page.make_note("Of swimming bodies: means of the steady beats; without any, the last "
                              "beat.") if case.model == "immersed" else page.Html()
    report.add("Results", make_results(table, axes, entries, case.model, links) + unsteady)
    if figure is not None:
        report.add("Plots", draw_picture(report, lambda: figure, "The figures over " + axes[0].label))
    missing = [job for job in jobs if job.state != "finished"]
    if missing:
        report.add("Runs without results", page.make_table(
            ("run", "state", "cause"), [(make_link(job, folder, job.name), job.state, job.cause) for job in missing],
            left=(0, 1, 2)))
    return report


def add_next_steps(report, command):
    """What to do with the results."""
    report.add("Next", page.make_note("The table for other programs: sweep.csv. Click a run for its "
                                      "page. The sweep again, which makes what is missing:")
               + page.make_element("pre", command))
