# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which runs a sweep has: all combinations of the values of some entries, or the rows of a table."""

import dataclasses
import hashlib
import itertools
import math
import re

import numpy as np
import pandas as pd

from . import SweepError

LONGEST_NAME = 120  # of a folder, in characters


@dataclasses.dataclass(frozen=True)
class Axis:
    """An entry "Section/Entry" and the values, as text, that it takes."""

    entry: str
    values: tuple
    name: str = ""  # for plots and tables; empty: the entry
    unit: str = ""

    @property
    def label(self):
        """The name with the unit."""
        return (self.name or self.entry) + (f" [{self.unit}]" if self.unit else "")


def name_axes(axes, units):
    """The axes with names that are as short as can be, and with their units where these are known."""
    names = shorten([axis.entry for axis in axes])
    return [dataclasses.replace(axis, name=names[axis.entry], unit=find_unit(units, axis.entry))
            for axis in axes]


def find_unit(units, entry):
    """The unit of an entry; in some models the program calls each body and region <name>."""
    general = re.sub(r"^Body [^/]*", "Body <name>", entry)
    return units.get(entry) or units.get(general) or \
        units.get(re.sub(r"/Region [^/]*", "/Region <name>", general), "")


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def space_equally(entry, text, parts):
    """The values of "first:last:number"."""
    if len(parts) != 3 or not all(map(is_number, parts[:2])) or not re.fullmatch("[0-9]+", parts[2]) \
            or int(parts[2]) < 1:
        raise SweepError(f"{entry}: <{text}> are no equally spaced values. Write first:last:number, two "
                         "numbers and how many values there are in all, such as 1:2:5.")
    first, last, number = float(parts[0]), float(parts[1]), int(parts[2])
    if number == 1 and first != last:
        raise SweepError(f"{entry}: <{text}> is one value, {parts[0]}: the last one, {parts[1]}, would "
                         "be left out. Write first:last:number with a number of 2 or more.")
    return [f"{value:.12g}" for value in np.linspace(first, last, number)]


def parse_axis(text):
    """An axis from "Section/Entry=first:last:number", "Section/Entry=v1,v2" or, if the values have
    commas, "Section/Entry=v1|v2"."""
    entry, _, values = (part.strip() for part in text.partition("="))
    if not entry or not values:
        raise SweepError(f"<{text}> can't be understood. Write \"Section/Entry=first:last:number\" "
                         "or \"Section/Entry=value,value,value\".")
    parts = [part.strip() for part in values.split(":")]
    if len(parts) > 1 and not re.search("[,|]", values) and (len(parts) == 3 or all(map(is_number, parts))):
        chosen = space_equally(entry, values, parts)
    else:
        chosen = [value.strip() for value in values.split("|" if "|" in values else ",")]
    if "" in chosen or len(set(chosen)) < len(chosen):
        raise SweepError(f"{entry}: <{values}> has a value that is empty or stands there twice. Give "
                         "each value once.")
    return Axis(entry, tuple(chosen))


def combine(axes):
    """The points of a full factorial: {entry: value} for each combination."""
    entries = [axis.entry for axis in axes]
    if len(set(entries)) < len(entries):
        raise SweepError("An entry is given twice. Give all of its values at once.")
    return [dict(zip(entries, values)) for values in itertools.product(*(a.values for a in axes))]


def read_list(path):
    """The axes and the points of a CSV file: entries in its first row, below it a row for each run."""
    try:
        table = pd.read_csv(path, dtype=str, keep_default_na=False, skipinitialspace=True)
    except (OSError, ValueError) as error:
        raise SweepError(f"--list {path}: the table can't be read: {error}. Give a CSV file with "
                         "entries as its first row and a row for each run.") from error
    # A row with too many cells makes pandas take its first ones for names of rows.
    is_whole = isinstance(table.index, pd.RangeIndex) and not (table == "").any(axis=None)
    if table.empty or not is_whole:
        raise SweepError(f"--list {path}: there are no rows, or a row has too few or too many values. "
                         "Give each run a value for each entry, in quotes if it has commas.")
    if table.duplicated().any():
        number = int(np.flatnonzero(table.duplicated())[0]) + 1
        raise SweepError(f"--list {path}: run {number} stands there twice. Give each run once.")
    axes = [Axis(entry, tuple(dict.fromkeys(table[entry]))) for entry in table]
    return axes, table.to_dict("records")


def shorten(entries):
    """The shortest ends of the entries that tell them apart."""
    parts = {entry: entry.split("/") for entry in entries}
    for length in range(1, max((len(part) for part in parts.values()), default=1) + 1):
        names = {entry: "/".join(part[-length:]) for entry, part in parts.items()}
        if len(set(names.values())) == len(names):
            return names
    return {entry: entry for entry in entries}


def name_point(point):
    """The name of a run's folder, from what is set in it: the same in each sweep that has it."""
    names = shorten(point)
    text = ",".join(f"{names[entry]}={value}" for entry, value in point.items())
    name = re.sub(r"[^A-Za-z0-9.,=+-]+", "_", text)
    values = "".join(point.values()).replace(" ", "")
    if len(name) > LONGEST_NAME or not re.fullmatch(r"[A-Za-z0-9.,=+-]*", values):
        name = name[:LONGEST_NAME] + "-" + hashlib.sha256(text.encode()).hexdigest()[:6]
    return name
