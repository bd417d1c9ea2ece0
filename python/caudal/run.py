# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run: its statistics by column name, its tail beats, its fields by time."""

import functools
import json
import pathlib
import xml.etree.ElementTree as xml

import numpy as np
import pandas as pd

from . import tables
from .errors import BrokenData, MissingData
from .parameters import read_model, read_parameters, read_progress


def read_json(path):
    """A file of JSON that a run has written."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise BrokenData(f"{path} is no valid JSON. Was it cut off?") from error


# Where what the lists of fields name comes from.
LISTS = {"solution": "Flow pictures need Output/Format = vtu.",
         "surfaces": "The surfaces of bodies need Output/Surfaces/Write = true and Format = vtu.",
         "slices": "Slices need planes in Output/Slices/Planes and Output/Format = vtu."}


class Run:
    """The results in one output folder. Files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise MissingData(f"There is no folder {folder}. Give the output folder of a run; "
                              "list_runs(\".\") tells all that there are.")

    @property
    def model(self):
        """immersed, potential, passage or elastic."""
        return read_model(self.folder)

    @property
    def progress(self):
        """finished, unfinished or failed; None if the run does not say."""
        return read_progress(self.folder)

    @functools.cached_property
    def parameters(self):
        """The parameters: values, as text, by "Section/Subsection/Entry"."""
        return pd.Series({f"{section}/{entry}".lstrip("/"): value
                          for section, entry, value, _ in read_parameters(self.folder)})

    # Tables

    @functools.cached_property
    def statistics(self):
        """statistics.txt: a row for each step, columns "name [unit]"."""
        return tables.read_table(self.folder / "statistics.txt")

    def read_statistics(self, frequency):
        """The same of a fish in an ideal fluid at one of its frequencies [Hz]."""
        path = self.folder / f"statistics_{frequency:g}Hz.txt"
        return tables.read_table(path) if path.is_file() else self.statistics

    @functools.cached_property
    def summary(self):
        """summary.csv of the models potential and passage: a row for each frequency or discharge."""
        return tables.read_summary(self.folder / "summary.csv")

    @property
    def columns(self):
        """The names "name [unit]" of the statistics."""
        return self.statistics.columns

    def find(self, name):
        """The column "name [unit]" of that name; the unit in brackets need not be given."""
        header = tables.find_column(self.statistics, name)
        if header is None:
            raise MissingData(f"statistics.txt has no column <{name}>."
                              + tables.suggest_column(self.statistics, name))
        return header

    def get(self, name):
        """The values of a column of the statistics."""
        return self.statistics[self.find(name)].to_numpy()

    def get_unit(self, name):
        return tables.get_unit(self.find(name))

    @property
    def time(self):
        return self.get("time")

    @functools.cached_property
    def bodies(self):
        """The names of the bodies, from the columns "<body>: ..."."""
        names = dict.fromkeys(header.partition(": ")[0] for header in self.columns
                              if ": " in header)
        if not names:
            raise MissingData("statistics.txt has no columns <body: quantity>.")
        return list(names)

    # Tail beats

    @functools.cached_property
    def swims(self):
        """What swim.json, or swim_<body>.json, say of the tail beats, by body."""
        reports = [read_json(path) for path in sorted(self.folder.glob("swim*.json"))]
        return {report["body"]: report for report in reports}

    def get_swim(self, body=None):
        """The swim report of a body, by default of the first one that has any beats."""
        found = [report for name, report in self.swims.items()
                 if report["beats"] and body in (None, name)]
        if not found:
            tail = f"the tail of {body} has made no" if body else "no tail has made a"
            raise MissingData(f"{self.folder}: {tail} whole beat yet.")
        return found[0]

    def beats(self, body=None):
        """A row for each whole tail beat, columns "name [unit]"; `steady` tells which are."""
        report = self.get_swim(body)
        units = {name: f"{name} [{quantity['unit']}]" if quantity["unit"] else name
                 for name, quantity in report["quantities"].items()}
        table = pd.DataFrame(report["beats"]).rename(columns=units)
        table.index = pd.RangeIndex(1, len(table) + 1, name="beat")
        return table

    def get_last_beat(self):
        """Start and end [s] of the last whole tail beat of the first body."""
        body = self.bodies[0]
        try:
            beat = self.get_swim(body)["beats"][-1]
        except (BrokenData, KeyError, OSError, MissingData) as error:
            raise MissingData(f"The tail of {body} has made no whole beat yet.") from error
        return beat["start"], beat["start"] + beat["period"]

    def resample_beats(self, columns, body=None, count=50):
        """Columns of the statistics at so many equal phases of each whole tail beat: a row for each
        beat and phase. Mean over the beats: .groupby("phase").mean(). A name that is no column is
        looked for as "<body>: name"."""
        report = self.get_swim(body)
        phases = np.arange(count) / count
        found = [tables.find_column(self.statistics, name)
                 or tables.find_column(self.statistics, f"{report['body']}: {name}")
                 or self.find(name) for name in columns]
        parts = {}
        for number, beat in enumerate(report["beats"], 1):
            times = beat["start"] + phases * beat["period"]
            parts[number] = pd.DataFrame(
                {header: np.interp(times, self.time, self.statistics[header]) for header in found},
                index=pd.Index(phases, name="phase"))
        return pd.concat(parts, names=["beat"])

    # Fields

    @property
    def is_spatial(self):
        """Whether the run has three dimensions; one that has no parameters has two."""
        try:
            return self.parameters.get("Dimension", "2") == "3"
        except MissingData:
            return False

    @functools.cached_property
    def files(self):
        """File names by time and block name, from solution.pvd."""
        return self.read_list("solution")

    @functools.lru_cache(maxsize=8)
    def read_list(self, name):
        """File names by time and block name, from a list: solution, surfaces or slices."""
        path = self.folder / f"{name}.pvd"
        if not path.is_file():
            raise MissingData(f"There is no {path}. " + LISTS[name])
        files = {}
        try:
            entries = list(xml.parse(path).iter("DataSet"))
        except xml.ParseError as error:
            raise BrokenData(f"{path} is no whole XML: {error}. Was it cut off?") from error
        for entry in entries:
            blocks = files.setdefault(float(entry.get("timestep")), {})
            block = entry.get("name") or pathlib.Path(entry.get("file")).stem.rpartition("-")[0]
            blocks[block] = self.folder / entry.get("file")
        if not files:
            raise MissingData(f"{path} lists no fields yet.")
        return files

    @property
    def times(self):
        """The times [s] of the outputs of the fluid."""
        times = sorted(time for time, blocks in self.files.items() if "fluid" in blocks)
        if not times:
            raise MissingData("solution.pvd lists no block <fluid>.")
        return times

    def find_blocks(self, time):
        """File names by block name at the time of an output."""
        if time not in self.files:
            nearest = min(self.files, key=lambda output: abs(output - time))
            raise MissingData(f"There are no fields at t = {time:g} s; the nearest are those at "
                              f"{nearest:g} s. `times` lists all.")
        return self.files[time]

    def find_file(self, time, name):
        """The file of a block at the time of an output."""
        blocks = self.find_blocks(time)
        if name not in blocks:
            raise MissingData(f"solution.pvd lists no block <{name}> at t = {time:g} s; it has "
                              f"{', '.join(blocks)}.")
        return blocks[name]

    @functools.lru_cache(maxsize=8)
    def read(self, time, name):
        """The field of a block at the time of an output: points, triangles and data."""
        from . import fields  # which needs VTK; tables don't
        return fields.read(self.find_file(time, name))

    @functools.lru_cache(maxsize=4)
    def read_volume(self, time, name):
        """The same in three dimensions: points, cells and data."""
        from . import fields
        return fields.read_volume(self.find_file(time, name))

    def read_volumes(self, time):
        """The bodies at the time of an output in three dimensions, by name."""
        return {name: self.read_volume(time, name) for name in self.find_blocks(time)
                if name != "fluid"}

    def read_surfaces(self):
        """The time of the last output of the bodies' surfaces, and these by name, in three
        dimensions."""
        from . import fields
        time, blocks = max(self.read_list("surfaces").items())
        return time, {name.removeprefix("surface_"): fields.read_volume(path)
                      for name, path in blocks.items()}

    def read_fluid(self, time):
        return self.read(time, "fluid")

    def read_bodies(self, time):
        """The bodies at the time of an output, by name."""
        return {name: self.read(time, name) for name in self.find_blocks(time) if name != "fluid"}


def list_runs(folder):
    """The runs in and below a folder: a row for each, with model, state, bodies and tail beats."""
    folder, rows = pathlib.Path(folder), []
    for path in sorted(folder.rglob("parameters.prm")):
        if path.parent.parent.name == "restart":  # that of a checkpoint
            continue
        run = Run(path.parent)
        try:
            values = run.parameters
            n_beats = max((len(swim["beats"]) for swim in run.swims.values()), default=0)
        except MissingData as reason:
            rows.append({"run": str(path.parent), "trouble": str(reason)})
            continue
        rows.append({"run": str(path.parent), "model": run.model, "state": run.progress or "unknown",
                     "bodies": values.get("Bodies", ""), "tail beats": n_beats, "trouble": ""})
    if not rows:
        raise MissingData(f"{folder}: there are no results of runs in or below it.")
    return pd.DataFrame(rows).set_index("run")
