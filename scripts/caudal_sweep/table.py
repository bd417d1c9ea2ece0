# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a sweep: a row for each body, frequency or discharge of each run."""

import numpy as np
import pandas as pd

from . import SweepError
from .figures import LABELS, Row, read_rows

# Beside the entries of the sweep, the label and the figures.
RUN, STEADY, STATE, REMARK = "run", "steady beats", "state", "remark"


def get_figures(table, entries, model):
    """The columns that are figures."""
    others = {RUN, STEADY, STATE, REMARK, LABELS.get(model), *entries}
    return [name for name in table if name not in others]


def find_unknown(jobs, model, wanted):
    """The names of figures that no finished run has, {name: names that there are}."""
    missing = []
    for job in jobs:
        if job.state == "finished" and wanted:
            missing.append({})
            read_rows(job.folder, model, wanted, missing[-1])
    return {name: known for name, known in (missing or [{}])[0].items()
            if all(name in others for others in missing)}


def make_table(jobs, entries, model, wanted, joined=None):
    """The table. Of runs that failed or did not come to their end there is the cause. An entry that
    is @p joined takes all of its values in one run: each row of that has one of them."""
    records = []
    for job in jobs:
        rows = read_rows(job.folder, model, wanted) if job.state == "finished" else [Row()]
        for row in rows:
            record = {RUN: job.name, **job.point}
            if joined:
                record[joined] = row.label if row.label != "" else job.point[joined]
            elif model in LABELS:
                record[LABELS[model]] = row.label
            record.update(row.values)
            if model == "immersed":
                record[STEADY] = row.steady_beats
            record.update({STATE: job.state, REMARK: job.cause or row.remark})
            records.append(record)
    table = pd.DataFrame(records)
    last = [name for name in (STEADY, STATE, REMARK) if name in table]
    table = table[[name for name in table if name not in last] + last]
    if table.get(LABELS.get(model)) is not None and (table[LABELS[model]] == "").all():
        table = table.drop(columns=LABELS[model])
    if STEADY in table:
        table[STEADY] = table[STEADY].astype("Int64")
    figures = get_figures(table, entries, model)
    table[figures] = table[figures].apply(pd.to_numeric, errors="coerce")
    return table


def is_steady(table):
    """Whether the figures of each row are means of steady beats; all are where nothing beats."""
    if STEADY not in table or table[STEADY].isna().all():
        return pd.Series(True, index=table.index)
    return (table[STEADY].fillna(0) > 0).astype(bool)


def write(table, path):
    """As CSV with one row of headers, the units in their names."""
    try:
        table.to_csv(path, index=False)
    except OSError as error:
        raise SweepError(f"{path} can't be written: {error}.") from error


def read_numbers(values):
    """The values of an entry as numbers, or None if one of them is none."""
    try:
        numbers = np.array([float(value) for value in values])
    except ValueError:
        return None
    return numbers if np.all(np.isfinite(numbers)) else None
