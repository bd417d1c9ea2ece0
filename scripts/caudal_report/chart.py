# SPDX-License-Identifier: LGPL-2.1-or-later
"""The data of a chart that chart.js draws."""

import numpy as np

from caudal_plots import style

MOST_POINTS = 3000
DASHED = "5 3"


def thin(x):
    """Indices of at most MOST_POINTS values, evenly chosen."""
    stride = -(-len(x) // MOST_POINTS)
    indices = np.arange(0, len(x), max(stride, 1))
    return indices if not len(x) or indices[-1] == len(x) - 1 else np.append(indices, len(x) - 1)


def pack(values):
    """As numbers of five digits; what is not finite becomes null."""
    return [float(f"{value:.5g}") if np.isfinite(value) else None for value in values]


def make_curve(name, x, y, colour, **options):
    """A curve; options: dash, width, and markers=True for points instead of a line."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    chosen = thin(x)
    return {"name": name, "x": [float(f"{value:.7g}") for value in x[chosen]], "y": pack(y[chosen]),
            "color": colour, **options}


def make_curves(x, values):
    """Curves of (name, y) in the colours of all figures."""
    return [make_curve(name, x, y, style.LINES[i % len(style.LINES)])
            for i, (name, y) in enumerate(values)]


def make_chart(title, x_label, y_label, curves, **options):
    """A chart; options: group (charts that are zoomed together), log, zero (a line at y = 0), note."""
    return {"title": title, "x": x_label, "y": y_label, "curves": curves, **options}
