# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a run: from its tail beats, its summary, or the columns of its statistics."""

import dataclasses
import re

from caudal import MissingData, Run
from caudal.tables import find_column, get_name, get_unit

from . import SweepError

# What is told by default, by model.
CHOSEN = {
    "immersed": ("speed", "speed in lengths", "frequency", "amplitude", "Strouhal number", "power",
                 "cost of transport", "numerical share"),
    "potential": ("distance", "displacement a stroke", "turn a stroke", "mean kinetic energy",
                  "mean gross power", "cost of transport"),
    "passage": ("share that passes", "fatigue of the median", "time of the median",
                "largest water velocity"),
    "elastic": (),  # the last values of all columns
}
# What tells the rows of one run apart.
LABELS = {"immersed": "body", "potential": "frequency [Hz]", "passage": "discharge [m^3/s]"}
ALL = "all"


def name_label(header, value):
    """A body's name; a frequency or discharge with its unit."""
    return f"{value:g} {get_unit(header)}" if isinstance(value, float) else str(value)


@dataclasses.dataclass
class Row:
    """A row of the table: one body, frequency or discharge of a run."""

    label: object = ""
    values: dict = dataclasses.field(default_factory=dict)  # by "name [unit]"
    steady_beats: object = None  # their number; None where there are no beats to be steady
    remark: str = ""


# A column of statistics.txt, made one number.
REDUCTIONS = {
    "last": lambda values: values.iloc[-1],
    "mean": lambda values: values.mean(),
    "least": lambda values: values.min(),
    "largest": lambda values: values.max(),
}


def reduce_column(table, wanted, body=""):
    """("name [unit]", number) of "mean of COLUMN" and the like over the second half of a table of
    statistics; the body's name may be left out. None if there is no such column."""
    match = re.fullmatch(r"(last|mean|least|largest) of (.*)", wanted)
    word, name = match.groups() if match else ("last", wanted)
    header = find_column(table, name) or find_column(table, f"{body}: {name}")
    if header is None:
        return None
    half = table[table.iloc[:, 0] >= table.iloc[-1, 0] / 2]
    unit = f" [{get_unit(header)}]" if get_unit(header) else ""
    return (f"{word} of {get_name(header).removeprefix(body + ': ')}{unit}",
            REDUCTIONS[word](half[header]))


def refuse(wanted, known):
    raise SweepError(f"--figures: there is no figure <{wanted}>. There are {', '.join(known)}; and of "
                     "each column of statistics.txt \"last of\", \"mean of\", \"least of\" or "
                     "\"largest of\" it, over the second half of the run.")


def choose(table, read_statistics, wanted, known, body=""):
    """The wanted ones of a run's figures, {"name [unit]": number}, and of its columns."""
    values, is_default = {}, wanted in CHOSEN.values()
    for name in wanted:
        if name == ALL:
            values.update((header, table[header]) for header in known)
        elif header := find_column(known, name):
            values[header] = table[header]
        elif not is_default and (found := reduce_column(read_statistics(), name, body)):
            values[found[0]] = found[1]
        elif not is_default:
            refuse(name, [get_name(header) for header in known])
    return values


def read_fish(run, wanted):
    """A row for each body that beats: the mean of its steady beats or, without any, the last beat."""
    rows = []
    for body, swim in run.swims.items():
        beat = swim["mean of steady beats"] or (swim["beats"] or [{}])[-1]
        known = {f"{name} [{quantity['unit']}]" if quantity["unit"] else name: beat.get(name)
                 for name, quantity in swim["quantities"].items() if name not in ("start", "steady")}
        remark = "" if beat else "no whole tail beat"
        rows.append(Row(body, choose(known, lambda: run.statistics, wanted, known, body), swim["steady beats"], remark))
    if rows:
        return rows
    named = [name for name in wanted if name not in CHOSEN["immersed"] and name != ALL]
    columns = [reduce_column(run.statistics, name) or refuse(name, CHOSEN["immersed"]) for name in named]
    return [Row("", dict(columns), None, "" if named else
                "no whole tail beat: name columns of statistics.txt by --figures")]


def read_summary(run, wanted, label):
    """A row for each row of summary.csv."""
    return [Row(values[label], choose(values, lambda: run.read_statistics(values[label]), wanted,
                                      [name for name in values if name != label]))
            for values in run.summary.to_dict("records")]


def read_rows(folder, model, wanted=()):
    """The rows of a run. What is missing or no number is said in `remark`."""
    run, wanted = Run(folder), wanted or CHOSEN[model]
    try:
        if model == "immersed":
            rows = read_fish(run, wanted)
        elif model in LABELS:
            rows = read_summary(run, wanted, LABELS[model])
        else:
            names = [name for name in run.columns[1:]] if wanted in ((), (ALL,)) else wanted
            rows = [Row("", choose({}, lambda: run.statistics, names, ()))]
    except MissingData as reason:
        return [Row(remark=str(reason).replace(f"{folder}/", ""))]
    for row in rows:
        lost = [get_name(name) for name, value in row.values.items()
                if value is None or value != value]
        if lost and not row.remark:
            row.remark = f"no number for {', '.join(lost)}"
    return rows
