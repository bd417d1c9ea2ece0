# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of a run as pandas.DataFrame, whose columns are called "name [unit]"."""

import difflib
import io
import pathlib
import re

import numpy as np
import pandas as pd

from .errors import BrokenData, MissingData


def get_unit(header):
    """The unit of a column "name [unit]"; empty if it has none."""
    return header.rpartition(" [")[2].rstrip("]") if header.endswith("]") else ""


def get_name(header):
    """A column's name without its unit."""
    return header.rpartition(" [")[0] if header.endswith("]") else header


def find_column(table, name):
    """The column "name [unit]" of a table; the unit need not be given. None if there is none."""
    if name in table:
        return name
    return next((header for header in table if get_name(header) == name), None)


def suggest_column(table, name):
    """Which columns may have been meant by a name that none has; empty if none is like it."""
    names = [get_name(header) for header in table]
    words = set(get_name(name).lower().partition(": ")[2].split() or get_name(name).lower().split())
    like = [known for known in names if words <= set(known.lower().replace(":", "").split())]
    like = like or difflib.get_close_matches(name, names, n=1)
    return f" Did you mean {' or '.join(f'<{one}>' for one in like[:4])}?" if like else ""


def read_table(path):
    """A table such as statistics.txt, whose header has a line "# number: name [unit]" for each
    column. A row that is being written while the run goes on is left out."""
    path = pathlib.Path(path)
    if not path.is_file():
        raise MissingData(f"There is no {path}.")
    text = path.read_text(encoding="utf-8", errors="replace")
    text = text[:text.rfind("\n") + 1]
    headers = re.findall(r"^#\s*\d+:\s*(.*\S)\s*$", text, re.MULTILINE)
    rows = "".join(line for line in text.splitlines(True) if line[0] != "#" and line.strip())
    try:
        values = np.loadtxt(io.StringIO(rows), ndmin=2) if rows else np.empty((0, len(headers)))
    except ValueError as error:
        raise BrokenData(f"{path} is damaged: {str(error).partition(';')[0]}.") from error
    if not headers or len(values) < 2 or values.shape[1] != len(headers):
        raise MissingData(f"{path} has fewer than two rows with as many numbers as headers.")
    return pd.DataFrame(values, columns=headers)


def read_summary(path):
    """A table of numbers with commas and one row of headers, such as summary.csv; where there is no
    number, such as that of a stroke of a swim without a whole one, is nan."""
    path = pathlib.Path(path)
    if not path.is_file():
        raise MissingData(f"There is no {path}: it is written at the end of the run.")
    try:
        table = pd.read_csv(path)
    except ValueError as error:  # pandas' own errors are such, too
        raise BrokenData(f"{path} has no whole row of numbers. Was it cut off?") from error
    is_whole = path.read_bytes().endswith(b"\n")
    if table.empty or not is_whole or table.select_dtypes("number").shape != table.shape:
        raise BrokenData(f"{path} has no whole row of numbers. Was it cut off?")
    return table
