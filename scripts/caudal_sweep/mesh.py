# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh studies: one case on three grids or more; observed order, convergence index, error bars.

The index is that of Roache (1994, doi:10.1115/1.2910291), for any ratios of the spacings as Celik
et al. (2008, doi:10.1115/1.2960953) give it.
"""

import re

import numpy as np
import pandas as pd

from caudal.tables import get_name, get_unit
from caudal_plots import style
from caudal_report import page

from . import SweepError
from .design import Axis
from .figures import LABELS, name_label
from .table import STATE, get_figures, is_steady, write

# Cells along and across in the same proportion, so that the grids differ in their spacing only. On
# grids that are not nested, the stations of an outline stand elsewhere in their cells and
# differences have any sign.
SURFACE = {"Surface/Cells along": 3, "Surface/Cells across": 2}
DEFAULT = {"immersed": "-2,-1,0", "potential": "1,2,4", "elastic": "-1,0,1"}
SAFETY = 1.25       # of the index where there is an order
LARGE_SAFETY = 3.   # where there is none
HIGHEST_ORDER = 2.  # that is believed in: of the walls of bodies and outlines
STEP_STAYS = "The time step is the same on all grids: its error is not in the error bars."
LEAST_ORDER = 0.5   # below it the grids are not in the range of convergence


def parse_grids(text, model):
    """The numbers of --grids, from coarse to fine."""
    if model not in DEFAULT:
        raise SweepError(f"--mesh: the model {model} has no grid. Give entries with values instead.")
    try:
        grids = [int(word) for word in (text or DEFAULT[model]).split(",")]
    except ValueError:
        grids = []
    if len(grids) < 3 or sorted(set(grids)) != grids or (model == "potential" and grids[0] < 1):
        raise SweepError(f"--grids: the value is <{text}>. Give at least three whole numbers that "
                         f"grow, such as {DEFAULT[model]}.")
    return grids


def scale_elements(entry, text, levels):
    """The numbers of elements on a grid with so many levels more."""
    numbers = [float(word) * 2**levels for word in text.split(",")]
    if any(number != round(number) or number < 1 for number in numbers):
        raise SweepError(f"{entry}: {text} elements can't be made 2^{-levels} times coarser. Give "
                         "automatic, which follows the fluid's grid, or multiples of that; or finer "
                         "--grids, such as 0,1,2.")
    return ",".join(f"{number:.0f}" for number in numbers)


def refine_bodies(case, levels):
    """The entries of the bodies' elements with so many levels more, where they are numbers."""
    return {entry: scale_elements(entry, value, levels) for entry, value in case.values.items()
            if re.fullmatch(r"Body [^/]+/Shape/Elements", entry) and value != "automatic"}


def refine_elastic(case, levels):
    """The same of a case without a fluid."""
    point = refine_bodies(case, levels)
    if not point:
        raise SweepError("--mesh: no body of the case has a number of elements. Give Body <name>/Shape/"
                         "Elements numbers.")
    return point


def refine_immersed(case, levels):
    """The entries of a case on a grid with so many levels more: bodies and the limit of the number
    of cells follow the fluid. The time step stays: it is no part of the grid."""
    n_levels = int(case.get("Domain/Levels", "4")) + levels
    if n_levels < 1:
        raise SweepError(f"--grids: {levels} levels of a case with Domain/Levels = "
                         f"{n_levels - levels}. Give finer grids, such as 0,1,2.")
    dimension = int(case.get("Dimension", "2"))
    point = {"Domain/Levels": str(n_levels)}
    vorticity = int(case.get("Refinement/Vorticity levels", "0"))
    if vorticity > 0:
        point["Refinement/Vorticity levels"] = str(max(vorticity + levels, 1))
    most = float(case.get("Refinement/Largest number of cells", "100000"))
    point["Refinement/Largest number of cells"] = f"{max(most * 2**(dimension * levels), 1):.0f}"
    return {**point, **refine_bodies(case, levels)}


def make_design(case, text):
    """The points, the axis, whose values are those of their first entry, and the spacings of the
    grids, relative to the finest."""
    grids = parse_grids(text, case.model)
    if case.model == "potential":
        points = [{entry: str(grid * cells) for entry, cells in SURFACE.items()} for grid in grids]
        spacings = [grids[-1] / grid for grid in grids]
    else:
        refine = refine_immersed if case.model == "immersed" else refine_elastic
        points = [refine(case, levels) for levels in grids]
        spacings = [2.**(grids[-1] - levels) for levels in grids]
    entry = next(iter(points[0]))
    return points, Axis(entry, tuple(point[entry] for point in points)), spacings


def extrapolate(h, values):
    """Observed order p and limit of f(h) = limit + C h^p through three grids of spacing h, from
    coarse to fine; None, None if the differences do not decrease that way."""
    coarse, middle, fine = values
    if middle == fine or (coarse - middle) / (middle - fine) <= 0:
        return None, None
    ratio = (coarse - middle) / (middle - fine)
    orders = np.linspace(0.01, 10, 10000)
    misfit = (h[0]**orders - h[1]**orders) / (h[1]**orders - h[2]**orders) - ratio
    crossing = np.flatnonzero(misfit[1:] * misfit[:-1] <= 0)
    if len(crossing) == 0:
        return None, None
    k = crossing[0]
    p = orders[k] + (orders[k + 1] - orders[k]) * misfit[k] / (misfit[k] - misfit[k + 1])
    return p, fine - (middle - fine) * h[2]**p / (h[1]**p - h[2]**p)


def judge(h, values):
    """Order, limit, error bar of the finest value, and a remark on the order."""
    h, values = np.asarray(h[-3:], float), np.asarray(values[-3:], float)
    if not np.all(np.isfinite(values)):
        return None, None, None, "no number on one of the last three grids"
    change = abs(values[2] - values[1])
    if np.ptp(values) <= 1e-10 * abs(values).max():
        return None, None, None, "the same on all grids, which may be the same grid"
    order, limit = extrapolate(h, values)
    if order is None or order < LEAST_ORDER:
        largest = max(change, abs(values[1] - values[0]))
        why = "the differences do not decrease" if order is None else \
            f"the order, {order:.2f}, is too low to be believed"
        return order, None, LARGE_SAFETY * largest, f"{why}: the bar is {LARGE_SAFETY:g} times the " \
            "largest difference"
    p = min(order, HIGHEST_ORDER)
    bar = SAFETY * change / ((h[1] / h[2])**p - 1)
    remark = "" if p == order else f"bar with the order {HIGHEST_ORDER:g}"
    return order, limit, bar, remark


class Study:
    """What the runs on the grids say of each figure."""

    def __init__(self, axis, h, table, entries, model):
        self.h = h
        self.table = self.evaluate(axis, table, entries, model)

    def evaluate(self, axis, table, entries, model):
        """A row for each figure of each body or frequency; none if a grid is missing."""
        records = []
        done = table[table[STATE] == "finished"]
        short = "/".join(axis.entry.split("/")[-2:])
        key = LABELS.get(model)
        has_labels = key in table and done[key].nunique() > 1
        for value, rows in done.groupby(key, sort=False) if has_labels else [("", done)]:
            label = name_label(key, value) if has_labels else ""
            rows = rows.set_index(axis.entry).reindex(axis.values)
            if rows[STATE].isna().any():
                continue
            unsteady = "" if is_steady(rows).all() else "beats are not steady on all grids"
            for name in get_figures(table, entries, model):
                values = rows[name].to_numpy(float)
                order, limit, bar, remark = judge(self.h, values)
                scale = abs(values[-1])
                records.append({
                    "figure": name, "of": label,
                    **{f"{short} = {grid}": value for grid, value in zip(axis.values, values)},
                    "observed order": order, "extrapolated": limit, "error bar": bar,
                    "convergence index [%]": 100 * bar / scale if bar is not None and scale else None,
                    "remark": "; ".join(filter(None, (remark, unsteady)))})
        return pd.DataFrame(records)

    def write(self, folder):
        """mesh.csv and what it says on the screen; returns the figure, or None."""
        if self.table.empty:
            print("No order: a grid has no result.")
            return None
        write(self.table, folder / "mesh.csv")
        for row in self.table.to_dict("records"):
            print("  " + self.describe_row(row))
        print(folder / "mesh.csv")
        return self.draw()

    @staticmethod
    def describe_row(row):
        """A figure with its error bar, in a line."""
        name = get_name(row["figure"]) + (f" of {row['of']}" if row["of"] else "")
        grids = [value for key, value in row.items() if " = " in key]
        bar = "" if pd.isna(row["error bar"]) else f" ± {row['error bar']:.2g}"
        order = "no order" if pd.isna(row["observed order"]) else f"order {row['observed order']:.2f}"
        return f"{name}: {grids[-1]:.6g}{bar} {get_unit(row['figure'])}, {order}" \
            + (f" ({row['remark']})" if row["remark"] else "")

    def draw(self):
        """Each figure over the spacing, with its bar and what it is extrapolated to."""
        names = list(dict.fromkeys(self.table["figure"]))
        columns = min(3, len(names))
        rows = -(-len(names) // columns)
        figure, panels = style.make_figure(rows, columns, 2.3 * rows + 0.4)
        for panel, name in zip(panels.flat, names):
            for row, colour in zip(self.table[self.table["figure"] == name].to_dict("records"),
                                   np.resize(style.LINES, len(self.table))):
                values = [value for key, value in row.items() if " = " in key]
                panel.plot(self.h, values, "o-", markersize=4, color=colour,
                           label=row["of"] or None)
                if not pd.isna(row["error bar"]):
                    panel.errorbar(self.h[-1], values[-1], row["error bar"], color=colour, capsize=3)
                if not pd.isna(row["extrapolated"]):
                    panel.plot([0, self.h[-1]], [row["extrapolated"], values[-1]], "--", color=colour,
                               linewidth=0.9)
            panel.set_xlim(0, 1.05 * self.h[0])
            panel.set_xlabel("spacing, relative to the finest [1]")
            panel.set_ylabel(f"{get_name(name)}\n{name.removeprefix(get_name(name)).strip()}".strip())
        for panel in panels.flat[len(names):]:
            panel.set_visible(False)
        if self.table["of"].nunique() > 1:
            panels[0, 0].legend()
        return figure

    def describe(self, report):
        """Adds the study to the page of the runs: key figures with their bars, and the table."""
        if self.table.empty:
            report.add("Grid convergence", page.make_note("No order: a grid has no result."))
            return
        first = self.table[self.table["of"] == self.table["of"].iloc[0]].to_dict("records")
        tiles = page.make_tiles([
            (get_name(row["figure"]),
             page.format_number([value for key, value in row.items() if " = " in key][-1])
             + ("" if pd.isna(row["error bar"]) else f" ± {row['error bar']:.2g}"),
             get_unit(row["figure"])) for row in first])
        words = [k for k, name in enumerate(self.table) if name in ("figure", "of", "remark")]
        rows = [[page.format_number(value) if isinstance(value, float) else
                 "–" if value is None else str(value) for value in row.values()]
                for row in self.table.to_dict("records")]
        report.add("Grid convergence", tiles + page.make_table(
            list(self.table), rows, left=words) + page.make_note(
            f"Error bar: Roache's convergence index with the factor of safety {SAFETY:g} and an order "
            f"of at most {HIGHEST_ORDER:g}; it is that of the finest grid. {STEP_STAYS}"))
