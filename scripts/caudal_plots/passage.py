# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of a run of the model `passage`: fatigue and speeds along the way, and the matrix of a
batch of fish."""

import csv
import functools
import json
import pathlib

import numpy as np

from . import BrokenData, MissingData, style

MEDIAN = "median"
BANDS = (MEDIAN, "lower limit of 75 %", "lower limit of 95 %")
COLOURS = {"green": "#7fc29b", "amber": "#f2c45a", "red": "#e08a7c"}


class Answers:
    """What a run has written to its folder."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def read(self, name):
        path = self.folder / name
        if not path.is_file():
            raise MissingData(f"There is no {path}; is this the folder of a run with Model = passage?")
        return path.read_text(encoding="utf-8")

    def read_table(self, name):
        """The rows of a table by the names of its columns, without units."""
        try:
            rows = list(csv.reader(self.read(name).splitlines()))
            header = [cell.partition(" [")[0] for cell in rows[0]]
            return [dict(zip(header, row, strict=True)) for row in rows[1:]]
        except (IndexError, ValueError) as error:
            raise BrokenData(f"{self.folder / name} is no whole table: {error}.") from error

    @functools.cached_property
    def facts(self):
        try:
            return json.loads(self.read("passage.json"))
        except ValueError as error:
            raise BrokenData(f"{self.folder / 'passage.json'} is no valid JSON. Was it cut off?") \
                from error

    @functools.cached_property
    def ways(self):
        """Columns along the way by discharge and fish."""
        ways = {}
        for row in self.read_table("way.csv"):
            ways.setdefault((float(row["discharge"]), row["fish"]), []).append(row)
        return {key: {name: np.array([float(row[name]) for row in rows])
                      for name in rows[0] if name != "fish"} for key, rows in ways.items()}

    @functools.cached_property
    def batch(self):
        return self.read_table("batch.csv")

    def get_way(self, verdict, band):
        """The columns of a fish's way, None if it does not even enter."""
        way = self.ways.get((verdict["discharge"], band))
        return way if way is not None and way["distance"][-1] > way["distance"][0] else None

    @property
    def hardest(self):
        """The verdict at the discharge that the fewest fish pass."""
        return min(self.facts["verdicts"], key=lambda verdict: verdict["share"])


def name_discharge(discharge):
    return f"{discharge:g} m³/s" if discharge > 0 else "the profile"


def add_legend(panels):
    """In the first of the panels that has something to name."""
    for panel in panels:
        if panel.get_legend_handles_labels()[0]:
            panel.legend()
            return


def draw_fatigue(answers):
    """The fatigue of three bands at each discharge."""
    verdicts = answers.facts["verdicts"]
    figure, axes = style.make_figure(1, len(verdicts), 3.2, sharey=True)
    for panel, verdict in zip(axes[0], verdicts):
        for band, colour in zip(BANDS, style.LINES):
            way = answers.get_way(verdict, band)
            if way is not None:
                panel.plot(way["distance"], way["fatigue"], label=band, color=colour)
        panel.axhline(1, color="0.3", linewidth=0.8, linestyle="--")
        panel.set_title(name_discharge(verdict["discharge"]))
        panel.set_xlabel("distance [m]")
        panel.set_ylim(0, 2)
    axes[0, 0].set_ylabel("fatigue [1]; 1 is exhausted")
    add_legend(axes[0])
    return figure


def draw_speeds(answers):
    """Speeds of water and of the median fish at each discharge."""
    verdicts = answers.facts["verdicts"]
    figure, axes = style.make_figure(1, len(verdicts), 3.2, sharey=True)
    for panel, verdict in zip(axes[0], verdicts):
        way = answers.get_way(verdict, MEDIAN)
        if way is not None:
            panel.plot(way["distance"], way["water velocity"], label="water")
            panel.plot(way["distance"], way["swimming speed"], label="median fish")
        panel.set_title(name_discharge(verdict["discharge"]))
        panel.set_xlabel("distance [m]")
        panel.set_ylim(bottom=0)
    axes[0, 0].set_ylabel("speed [m/s]")
    add_legend(axes[0])
    return figure


def draw_matrix(answers):
    """Species and lengths over discharges: how many pass, and what stops the others."""
    fish = list(dict.fromkeys((row["species"], float(row["length"])) for row in answers.batch))
    discharges = list(dict.fromkeys(float(row["discharge"]) for row in answers.batch))
    figure, ((axes,),) = style.make_figure(1, 1, 0.7 + 0.34 * len(fish))
    for row in answers.batch:
        x = discharges.index(float(row["discharge"]))
        y = fish.index((row["species"], float(row["length"])))
        axes.add_patch(style.plt.Rectangle((x, y), 1, 1, facecolor=COLOURS[row["verdict"]],
                                           edgecolor="white", linewidth=2))
        text = f"{100 * float(row['share that passes']):.0f} %"
        if row["cause"] != "none":
            text += f"  {row['cause']} at {float(row['place']):.3g} m"
        axes.text(x + 0.5, y + 0.5, text + (" *" if row["remark"] else ""), ha="center",
                  va="center", fontsize=8)
    axes.set_xlim(0, len(discharges))
    axes.set_ylim(len(fish), 0)
    axes.set_xticks(np.arange(len(discharges)) + 0.5, [name_discharge(q) for q in discharges])
    axes.set_yticks(np.arange(len(fish)) + 0.5, [f"{name}, {length:g} m" for name, length in fish])
    axes.tick_params(length=0)
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.set_title("Share of the fish that pass: green 87.5 % or more, amber half or more, red less"
                   + ("; * lengths beyond the data" if any(r["remark"] for r in answers.batch) else ""))
    return figure


FIGURES = (
    ("fatigue", "fatigue along the way", draw_fatigue),
    ("speeds", "speeds of water and fish along the way", draw_speeds),
    ("matrix", "the matrix of a batch of fish", draw_matrix),
)


def get_figures(folder):
    """What can be drawn of a run: one fish has no matrix."""
    return [figure for figure in FIGURES if figure[0] != "matrix" or (folder / "batch.csv").exists()]
