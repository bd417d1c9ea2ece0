# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a run: from its tail beats, its summary, or the columns of its statistics."""

import dataclasses
import re

from caudal import MissingData, Run
from caudal.tables import find_column, get_name, get_unit

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


def describe_unknown(unknown):
    """What is wrong with names of figures, {name: names that there are}, and what may be given."""
    known = list(dict.fromkeys(name for names in unknown.values() for name in names))
    listed = f" There are {', '.join(known)}; and of" if known else " There is, of"
    return (f"--figures: there is no figure {', '.join(f'<{name}>' for name in unknown)}.{listed} each "
            "column of statistics.txt \"last of\", \"mean of\", \"least of\" or \"largest of\" it, over "
            "the second half of the run.")


def find_figure(known, name):
    """The header of a figure, be it called a mean or not: "speed" and "mean speed" are the same."""
    return find_column(known, name) or find_column(known, f"mean {name}") or \
        find_column(known, name.removeprefix("mean "))


def choose(table, read_statistics, wanted, known, unknown, body=""):
    """The wanted ones of a run's figures, {"name [unit]": number}, and of its columns. What is none of
    them comes into @p unknown."""
    values, is_default = {}, wanted in CHOSEN.values()
    for name in wanted:
        if name == ALL:
            values.update((header, table[header]) for header in known)
        elif header := find_figure(known, name):
            values[header] = table[header]
        elif not is_default and (found := reduce_column(read_statistics(), name, body)):
            values[found[0]] = found[1]
        elif not is_default:
            unknown[name] = [get_name(header) for header in known]
    return values


def read_fish(run, wanted, unknown):
    """A row for each body that beats: the mean of its steady beats or, without any, the last beat."""
    rows, missing = [], []
    for body, swim in run.swims.items():
        beat = swim["mean of steady beats"] or (swim["beats"] or [{}])[-1]
        known = {f"{name} [{quantity['unit']}]" if quantity["unit"] else name: beat.get(name)
                 for name, quantity in swim["quantities"].items() if name not in ("start", "steady")}
        missing.append({})
        values = choose(known, lambda: run.statistics, wanted, known, missing[-1], body)
        rows.append(Row(body, values, swim["steady beats"], "" if beat else "no whole tail beat"))
    if rows:  # a column that one of the bodies has is a figure
        unknown.update((name, known) for name, known in missing[0].items()
                       if all(name in others for others in missing))
        return rows
    named = [name for name in wanted if name not in CHOSEN["immersed"] and name != ALL]
    columns = {name: reduce_column(run.statistics, name) for name in named}
    unknown.update((name, CHOSEN["immersed"]) for name in named if columns[name] is None)
    return [Row("", dict(found for found in columns.values() if found), None, "" if named else
                "no whole tail beat: name columns of statistics.txt by --figures")]


def read_summary(run, wanted, label, unknown):
    """A row for each row of summary.csv."""
    return [Row(values[label], choose(values, lambda: run.read_statistics(values[label]), wanted,
                                      [name for name in values if name != label], unknown))
            for values in run.summary.to_dict("records")]


def read_rows(folder, model, wanted=(), unknown=None):
    """The rows of a run. What is missing or no number is said in `remark`; names of figures that it
    does not have come into @p unknown, {name: names that it has}."""
    run, wanted = Run(folder), wanted or CHOSEN[model]
    unknown = {} if unknown is None else unknown
    try:
        if model == "immersed":
            rows = read_fish(run, wanted, unknown)
        elif model in LABELS:
            rows = read_summary(run, wanted, LABELS[model], unknown)
        else:
            names = [name for name in run.columns[1:]] if wanted in ((), (ALL,)) else wanted
            rows = [Row("", choose({}, lambda: run.statistics, names, (), unknown))]
    except MissingData as reason:
        return [Row(remark=str(reason).replace(f"{folder}/", ""))]
    for row in rows:
        lost = [get_name(name) for name, value in row.values.items()
                if value is None or value != value]
        if lost and not row.remark:
            row.remark = f"no number for {', '.join(lost)}"
    return rows
