# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh independence: the same swim on finer and finer surfaces."""

import numpy as np

from caudal_plots import style

from . import runs

# Cells along and across in the same proportion, so that the grids differ in their spacing only.
# Each halves the spacing of one before it, or lies between two such: on grids that are not
# nested, the stations of an outline stand elsewhere in their cells and differences have any sign.
UNITS = (1, 2, 4, 6)  # 130, 514, 2,050, 4,610 panels
FINEST = 8  # 8,194 panels
QUANTITIES = ("displacement a stroke", "mean kinetic energy")


def count_panels(along, across):
    return 16 * along * across + 8 * across**2 + 2


def extrapolate(units, values):
    """Observed order p and limit of f(h) = limit + C h^p through three grids of spacing 1/unit.

    For any ratios of the spacings, e.g. I. B. Celik et al., J. Fluids Eng. 130, 2008,
    doi:10.1115/1.2960953.
    """
    h = 1 / np.asarray(units, dtype=float)
    coarse, middle, fine = values
    if middle == fine or (coarse - middle) / (middle - fine) <= 0:
        return None, None
    ratio = (coarse - middle) / (middle - fine)
    orders = np.linspace(0.2, 8, 7801)
    misfit = (h[0]**orders - h[1]**orders) / (h[1]**orders - h[2]**orders) - ratio
    crossing = np.flatnonzero(misfit[1:] * misfit[:-1] <= 0)
    if len(crossing) == 0:
        return None, None
    p = orders[crossing[0]]
    return p, fine - (middle - fine) * h[2]**p / (h[1]**p - h[2]**p)


def describe(name, units, values):
    """A sentence for each set of three grids, and the last limit."""
    lines, limit = [], values[-1]
    for chosen in (units[:3], (2, 4, units[-1])):
        picked = [values[units.index(unit)] for unit in chosen]
        order, value = extrapolate(chosen, picked)
        grids = ", ".join(str(count_panels(3 * unit, 2 * unit)) for unit in chosen)
        if order is None:
            lines.append(f"{name}, {grids} panels: the differences do not decrease; no order")
        else:
            lines.append(f"{name}, {grids} panels: observed order {order:.2f}, "
                         f"Richardson's value {value:.8g}")
            limit = value
    return lines, limit


def main(case, folder, overrides, with_finest):
    units = UNITS + ((FINEST,) if with_finest else ())
    rows, text = [], []
    for unit in units:
        along, across = 3 * unit, 2 * unit
        n = count_panels(along, across)
        place = folder / f"{n}"
        runs.run(case, place, [*overrides, f"Surface/Cells along={along}",
                               f"Surface/Cells across={across}", "Integration/Torques=false",
                               "Output/Interval of fields=1e9"])
        result = runs.read_summary(place)[0]
        cpu = runs.read_log(place, r"CPU of rank 0: (\S+) s")[0]
        rows.append((n, *(result[name] for name in QUANTITIES), cpu))
        text.append(f"{n:8d}{rows[-1][1]:20.8g}{rows[-1][2]:20.8g}{cpu:12.2f}")
        print(text[-1], flush=True)
    n, *values, _ = np.array(rows).T
    header = f"{'panels':>8}{'a stroke [cm]':>20}{'<T> [J]':>20}{'CPU [s]':>12}"
    text.insert(0, header)
    limits = []
    for name, value in zip(QUANTITIES, values):
        lines, limit = describe(name, units, value)
        text += lines
        limits.append(limit)
    (folder / "mesh.txt").write_text("\n".join(text) + "\n")
    print("\n".join(text[len(units) + 1:]))
    style.apply()
    figure, axes = style.make_figure(1, 1, 3.6)
    for name, value, limit in zip(QUANTITIES, values, limits):
        axes[0, 0].loglog(n, np.maximum(abs(value / limit - 1), 1e-8), "o-", markersize=3, label=name)
    axes[0, 0].set_xlabel("panels")
    axes[0, 0].set_ylabel("relative difference from\nRichardson's value [1]")
    axes[0, 0].legend()
    figure.savefig(folder / "mesh.png")
    style.close(figure)
    print(folder / "mesh.txt", folder / "mesh.png", sep="\n")
    return 0
