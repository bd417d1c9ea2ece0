# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run has written: its statistics by column name, its fields by time."""

import functools
import json
import pathlib
import re
import xml.etree.ElementTree as xml

import numpy as np

from . import BrokenData, MissingData, fields


class Run:
    """The results in one output folder. Files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    # Statistics

    @functools.cached_property
    def columns(self):
        """The statistics: values over time by "name [unit]"."""
        path = self.folder / "statistics.txt"
        if not path.is_file():
            raise MissingData(f"There is no {path}.")
        lines = path.read_text(encoding="utf-8").splitlines()
        headers = [match.group(1) for line in lines
                   if (match := re.match(r"#\s*\d+:\s*(.*\S)", line))]
        # The last row may be half written while the run goes on.
        rows = [line.split() for line in lines if not line.startswith("#")]
        rows = [row for row in rows if len(row) == len(headers)]
        if not headers or len(rows) < 2:
            raise MissingData(f"{path} has fewer than two rows with as many numbers as headers.")
        return dict(zip(headers, np.array(rows, dtype=float).T))

    def find(self, name):
        """The column "name [unit]" of that name; the unit in brackets need not be given."""
        for header in self.columns:
            if header == name or header.partition(" [")[0] == name:
                return header
        raise MissingData(f"statistics.txt has no column <{name}>.")

    def get(self, name):
        return self.columns[self.find(name)]

    def get_unit(self, name):
        return self.find(name).partition(" [")[2].rstrip("]")

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

    def get_last_beat(self):
        """Start and end [s] of the last whole tail beat of the first body, from its swim.json."""
        body = self.bodies[0]
        name = "swim.json" if len(self.bodies) == 1 else f"swim_{body}.json"
        try:
            beats = json.loads((self.folder / name).read_text(encoding="utf-8"))["beats"]
        except (OSError, ValueError, KeyError):
            beats = []
        if not beats:
            raise MissingData(f"The tail of {body} has made no whole beat yet.")
        return beats[-1]["start"], beats[-1]["start"] + beats[-1]["period"]

    # Fields

    @functools.cached_property
    def files(self):
        """File names by time and block name, from solution.pvd."""
        path = self.folder / "solution.pvd"
        if not path.is_file():
            raise MissingData(f"There is no {path}. Flow pictures need Output/Format = vtu.")
        files = {}
        try:
            entries = list(xml.parse(path).iter("DataSet"))
        except xml.ParseError as error:
            raise BrokenData(f"{path} is no whole XML: {error}. Was it cut off?") from error
        for entry in entries:
            blocks = files.setdefault(float(entry.get("timestep")), {})
            name = entry.get("name") or pathlib.Path(entry.get("file")).stem.rpartition("-")[0]
            blocks[name] = self.folder / entry.get("file")
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

    def get_nearest_times(self, wanted):
        """The outputs nearest to the wanted times [s], each of them once."""
        times = np.array(self.times)
        gap = np.diff(times).max() if len(times) > 1 else 0.
        nearest = [times[np.argmin(abs(times - t))] for t in wanted if t <= times[-1] + gap]
        return sorted(set(nearest))

    @functools.lru_cache(maxsize=8)
    def read(self, time, name):
        return fields.read(self.files[time][name])

    def read_fluid(self, time):
        return self.read(time, "fluid")

    def read_bodies(self, time):
        """The bodies at the time of an output, by name."""
        return {name: self.read(time, name) for name in self.files[time] if name != "fluid"}
