# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a sweep: each figure over one entry, a curve for each value of the others."""

import math
import re

import matplotlib
import numpy as np

from caudal.tables import get_name
from caudal_plots import style

from .figures import LABELS, name_label
from .table import STATE, get_figures, is_steady, read_numbers

COLUMNS = 3           # of panels
LEGEND_COLUMNS = 4
SMALLEST_SPAN = 1e-6  # of the largest value: less is rounding
LEAST = {"turn a stroke [degrees]": 1e-3}  # less is rounding


def name_value(axis, value):
    """A value of an entry with the entry's name and unit: text, or a number where one run has many."""
    text = value if isinstance(value, str) else f"{value:g}"
    return f"{axis.name or axis.entry} {text} {axis.unit}".strip()


def find_curves(table, axis, model):
    """[(name, rows)]: what is drawn as one curve, all but the first axis being the same."""
    names = [entry for entry in axis[1:] if table[entry.entry].nunique() > 1]
    keys = [entry.entry for entry in names]
    label = LABELS.get(model)
    if label in table and table[label].nunique() > 1:
        keys.append(label)
    if not keys:
        return [("", table)]
    shown = {entry.entry: entry for entry in names}

    def name(values):
        values = values if len(keys) > 1 else (values,)
        return ", ".join(name_value(shown[key], value) if key in shown else name_label(key, value)
                         for key, value in zip(keys, values))

    groups = table.groupby(keys[0] if len(keys) == 1 else keys, sort=False)
    return [(name(values), rows) for values, rows in groups]


def split_curve(label):
    """("name [unit]", number as text) of a curve's label "name number unit"."""
    match = re.fullmatch(r"(?:(.*) )?([-+.\deE]+)(?: (\D.*))?", label)
    if not match:
        return label, ""
    return (match[1] or "") + (f" [{match[3]}]" if match[3] else ""), match[2]


def set_limits(panel, name, values):
    """Keeps rounding from filling the height of a panel."""
    values = values[np.isfinite(values)]
    if len(values) == 0:
        return
    largest = abs(values).max()
    if largest < LEAST.get(name, 0.):
        panel.set_ylim(-1, 1)
    elif np.ptp(values) < SMALLEST_SPAN * largest:
        panel.set_ylim(*sorted((0, 1.5 * values.mean())))


def draw_curve(panel, x, y, steady, **options):
    """A curve with its points: full ones are means of steady beats, hollow ones are not."""
    order = np.argsort(x, kind="stable")
    x, y, steady = x[order], y[order], steady[order]
    line, = panel.plot(x, y, **options)
    for chosen, face in ((steady, line.get_color()), (~steady, "white")):
        panel.plot(x[chosen], y[chosen], "o", markersize=4, color=line.get_color(),
                   markerfacecolor=face, zorder=3)


def choose_colours(curves):
    """Colours of the curves, and their scale if they are many and told apart by a number."""
    if len(curves) <= len(style.LINES):
        return style.LINES, None
    numbers = read_numbers([split_curve(label)[1] for label, _ in curves])
    if numbers is None:
        numbers = np.arange(len(curves))
    scale = matplotlib.cm.ScalarMappable(
        matplotlib.colors.Normalize(numbers.min(), numbers.max()), "viridis")
    return scale.to_rgba(numbers), scale


def place_legend(figure, panels, curves, scale):
    """Below all panels, or a scale of colours beside them."""
    if scale is not None:
        figure.colorbar(scale, ax=panels, label=split_curve(curves[0][0])[0], aspect=40)
    elif len(curves) > 1:
        lines = math.ceil(len(curves) / LEGEND_COLUMNS)
        room = (0.22 * lines + 0.05) / figure.get_figheight()
        figure.get_layout_engine().set(rect=(0, room, 1, 1 - room))
        figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="lower center",
                      ncol=min(LEGEND_COLUMNS, len(curves)))


def describe_points(table, n_unsteady, steady_only):
    """What the points are, and which are missing."""
    notes = []
    if n_unsteady:
        notes.append(f"left out as no beat is steady: {n_unsteady}" if steady_only else
                     "hollow: the last beat, as none is steady")
    n_missing = int((table[STATE] != "finished").sum())
    if n_missing:
        notes.append(f"without a point as they did not finish: {n_missing}")
    return "; ".join(notes)


def draw(table, axes, entries, model, steady_only=False):
    """A panel for each figure over the first of the axes; None if there is nothing to draw."""
    done = table[table[STATE] == "finished"]
    steady = is_steady(done)
    notes = describe_points(table, int((~steady).sum()), steady_only)
    if steady_only:
        done = done[steady]
    names = [name for name in get_figures(table, entries, model)
             if done[name].notna().any()]
    if not names:
        return None
    first, curves = axes[0], find_curves(done, axes, model)
    positions = read_numbers(first.values)
    columns = min(COLUMNS, len(names))
    figure, panels = style.make_figure(math.ceil(len(names) / columns), columns,
                                       2.3 * math.ceil(len(names) / columns) + 0.6)
    colours, scale = choose_colours(curves)
    for panel, name in zip(panels.flat, names):
        for (label, part), colour in zip(curves, colours):
            x = (part[first.entry].astype(float).to_numpy() if positions is not None else
                 np.array([first.values.index(value) for value in part[first.entry]], dtype=float))
            draw_curve(panel, x, part[name].to_numpy(float), steady[part.index].to_numpy(),
                       color=colour, label=label)
        set_limits(panel, name, done[name].to_numpy(float))
        panel.set_ylabel(f"{get_name(name)}\n{name.removeprefix(get_name(name)).strip()}".strip())
        panel.set_xlabel(first.label, loc="left")  # at the right a power of ten may stand
        if positions is not None and np.all(positions == np.round(positions)):
            panel.xaxis.get_major_locator().set_params(integer=True)
        if positions is None:
            panel.set_xticks(range(len(first.values)), first.values)
    for panel in panels.flat[len(names):]:
        panel.set_visible(False)
    place_legend(figure, panels, curves, scale)
    figure.suptitle(notes)
    return figure
