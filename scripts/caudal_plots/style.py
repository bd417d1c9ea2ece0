# SPDX-License-Identifier: LGPL-2.1-or-later
"""One look for all figures."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.colors  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

WIDTH = 9.  # of a figure [inch]

# Colour-blind safe (Okabe and Ito, 2008).
LINES = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
BODY = "#3A3F44"
# One colour for one quantity, in pictures and reports.
COLOURS = {"muscle work": "#000000", "kinetic energy": LINES[0], "elastic energy": LINES[1],
           "dissipation": LINES[2], "numerical dissipation": LINES[3], "feedback": LINES[4],
           "external work": LINES[5], "residual": "#8a949b"}


def apply():
    plt.rcParams.update({
        "figure.dpi": 100, "savefig.dpi": 160, "figure.facecolor": "white",
        "font.family": "DejaVu Sans", "font.size": 9,
        "axes.titlesize": 9, "figure.titlesize": 10, "axes.labelsize": 9, "axes.titlelocation": "left",
        "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8,
        "axes.linewidth": 0.7, "xtick.major.width": 0.7, "ytick.major.width": 0.7,
        "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
        "lines.linewidth": 1.3, "axes.prop_cycle": plt.cycler(color=LINES),
        "axes.grid": True, "grid.color": "0.9", "grid.linewidth": 0.6, "axes.axisbelow": True,
        "legend.frameon": False, "axes.formatter.useoffset": False,
        "axes.formatter.limits": (-3, 4), "axes.formatter.use_mathtext": True,
    })


def make_figure(rows, columns, height, **options):
    """A figure of the common width, its height in inches, its axes as a 2D array."""
    return plt.subplots(rows, columns, figsize=(WIDTH, height), squeeze=False,
                        constrained_layout=True, **options)


# Purple to orange without the dark ends, so that arrows can be seen on it.
PRESSURE = matplotlib.colors.ListedColormap(
    matplotlib.colormaps["PuOr_r"](np.linspace(0.14, 0.86, 256)))


def make_cycle(lightness=0.62, chroma=0.125, count=256):
    """All hues at one lightness, so that the end of a cycle has the colour of its beginning and
    none is lost on white (Oklab by B. Ottosson, 2020)."""
    angle = 2 * np.pi * np.arange(count) / count
    lab = np.stack([np.full(count, lightness), chroma * np.cos(angle), chroma * np.sin(angle)])
    roots = np.array([[1, 0.3963377774, 0.2158037573], [1, -0.1055613458, -0.0638541728],
                      [1, -0.0894841775, -1.2914855480]]) @ lab
    linear = np.array([[4.0767416621, -3.3077115913, 0.2309699292],
                       [-1.2684380046, 2.6097574011, -0.3413193965],
                       [-0.0041960863, -0.7034186147, 1.7076147010]]) @ roots**3
    linear = np.clip(linear, 0, 1)
    colours = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear**(1 / 2.4) - 0.055)
    return matplotlib.colors.ListedColormap(colours.T)


PHASES = make_cycle()  # of what repeats itself


def close(figure):
    plt.close(figure)


def get_round_limit(value):
    """The nearest of 1, 2, 5 times a power of ten."""
    if not value > 0:
        return 1.
    power = 10.**np.floor(np.log10(value))
    return power * min((1, 2, 5, 10), key=lambda factor: abs(np.log(factor * power / value)))


def set_window(axes, window):
    axes.set_aspect("equal")
    axes.set_xlim(window[:2])
    axes.set_ylim(window[2:])
    axes.grid(False)


def draw_field(axes, field, values, window, limit, colours):
    """Smooth colours from -limit to limit in the window (x0, x1, y0, y1)."""
    picture = axes.tripcolor(field.points[:, 0], field.points[:, 1],
                             field.triangles[field.clip(window)], values, shading="gouraud",
                             cmap=colours, vmin=-limit, vmax=limit, rasterized=True)
    set_window(axes, window)
    return picture


def draw_bodies(axes, bodies, with_names=True):
    """The bodies, filled; several ones with their names."""
    for name, body in bodies.items():
        axes.add_collection(PolyCollection(body.outline, facecolor=BODY, edgecolor="black",
                                           linewidth=0.5, zorder=3))
        if with_names and len(bodies) > 1:
            x, y = body.points.mean(axis=0)[0], body.points[:, 1].max()
            axes.annotate(name, (x, y), xytext=(0, 3), textcoords="offset points", fontsize=7,
                          ha="center", va="bottom", zorder=4, annotation_clip=True,
                          bbox={"boxstyle": "round,pad=0.1", "facecolor": "white", "alpha": 0.6,
                                "linewidth": 0})
