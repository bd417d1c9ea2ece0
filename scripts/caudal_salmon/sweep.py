# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sweep over one entry of a case: runs side by side, a table and a plot."""

import concurrent.futures
import csv
import os

import numpy as np

from caudal_plots import style

from . import runs

FREQUENCY = "Gait/Frequency"  # of the body
PLOTTED = {"distance": "cm", "displacement a stroke": "cm", "turn a stroke": "degrees",
           "mean kinetic energy": "J", "mean gross power": "W", "cost of transport": "J/(kg m)"}
LEAST_TURN = 1e-3  # [degrees]; less is rounding


def parse(text):
    """The entry and its values from "Section/Entry=first:last:number"."""
    entry, _, values = text.partition("=")
    try:
        first, last, number = values.split(":")
        result = np.linspace(float(first), float(last), int(number))
    except ValueError:
        result = []
    if not entry or len(result) == 0:
        raise runs.RunError(f"--sweep: <{text}> can't be understood. Write "
                            "\"Section/Entry=first:last:number\".")
    return entry, [float(f"{value:.12g}") for value in result]


def run_values(case, entry, values, folder, overrides):
    """Rows of results with the value in front. Runs that are there already are kept."""
    if entry.endswith(FREQUENCY):  # all from one table of phases
        runs.run(case, folder / "run", [*overrides, f"{entry}=" + ", ".join(map(str, values))])
        return list(zip(values, runs.read_summary(folder / "run")))

    def work(value):
        place = folder / f"{value:g}"
        cost = runs.run(case, place, [*overrides, f"{entry}={value}"])
        print(f"{entry} = {value:g}: " + ("known already" if cost is None else "done"), flush=True)
        return [(value, result) for result in runs.read_summary(place)]

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return [row for rows in pool.map(work, values) for row in rows]


def draw(entry, rows, path):
    style.apply()
    names = [name for name in PLOTTED if all(name in result for _, result in rows)]
    figure, axes = style.make_figure(2, 3, 4.8)
    for panel, name in zip(axes.flat, names):
        for frequency in sorted({result["frequency"] for _, result in rows}) \
                if not entry.endswith(FREQUENCY) else [None]:
            chosen = [(value, result[name]) for value, result in rows
                      if frequency in (None, result["frequency"])]
            panel.plot(*np.array(chosen).T, "o-", markersize=3,
                       label=None if frequency is None else f"{frequency:g} Hz")
        values = [result[name] for _, result in rows]
        if name.startswith("turn") and max(map(abs, values)) < LEAST_TURN:
            panel.set_ylim(-1, 1)
        elif np.ptp(values) < 1e-6 * max(map(abs, values)):
            panel.set_ylim(0, 1.5 * max(values))
        panel.set_ylabel(f"{name} [{PLOTTED[name]}]")
        panel.set_xlabel(entry)
    for panel in axes.flat[len(names):]:
        panel.set_visible(False)
    if not entry.endswith(FREQUENCY):
        axes[0, 0].legend()
    figure.savefig(path)
    style.close(figure)


def main(text, case, folder, overrides):
    entry, values = parse(text)
    rows = run_values(case, entry, values, folder, overrides)
    with open(folder / "sweep.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([entry, *rows[0][1]])
        writer.writerows([value, *result.values()] for value, result in rows)
    draw(entry, rows, folder / "sweep.png")
    print(folder / "sweep.csv", folder / "sweep.png", sep="\n")
    return 0
