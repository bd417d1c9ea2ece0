# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the wall of an immersed body acts, and what a swimmer's speed makes of it."""

import math

import numpy as np

from caudal_sweep.mesh import SAFETY, extrapolate

from .figures import Figure

# Circular Couette flow: cells from the disc to the sides by Domain/Levels, and at 16 cells
# elements of these heights, in cells, by the numbers that make them.
CELLS = {3: 8, 4: 16, 5: 32}
DISC_HEIGHTS = {0.87: 768, 1.4: 300, 1.9: 147}
COUETTE_VARIANTS = (tuple((f"Domain/Levels={levels}",) for levels in CELLS) +
                    tuple((f"Body disc/Shape/Elements={n},1",) for n in DISC_HEIGHTS.values()))
TORQUE = 4 / 3 * math.pi

# The walls of the channel are 5.44 cells thick.
WALL_ELEMENTS = {0.78: "90,7", 1.09: "64,5", 1.36: "51,4", 1.81: "39,3"}
CHANNEL_VARIANTS = ((),) + tuple(
    (f"Body upper/Shape/Elements={n}", f"Body lower/Shape/Elements={n}")
    for n in WALL_ELEMENTS.values())

# IBAMR's eel: cells of L/32, L/64 and L/128, velocity nodes half of that apart.
EEL_SPACINGS = {4: "L/64", 5: "L/128", 6: "L/256"}
EEL_VARIANTS = tuple((f"Domain/Levels={levels}", f"Refinement/Vorticity levels={levels - 1}",
                      f"Refinement/Largest number of cells={1500 * 4 ** (levels - 4)}")
                     for levels in EEL_SPACINGS)


def evaluate_couette(runs):
    figures, errors = [], []
    for run, cells in zip(runs, CELLS.values()):
        figures.append(Figure(f"torque [N m/m], {cells} cells", run.get("disc: moment of the fluid")[-1],
                              TORQUE, 0.005 if cells == 16 else None))
        errors.append(run.get("velocity error")[-1])
    figures.append(Figure("order of the velocity", math.log2(errors[1] / errors[2]),
                          gate=(1.4, math.inf)))
    h = 0.5 / CELLS[4]
    for run, height in zip(runs[len(CELLS):], DISC_HEIGHTS):
        error = run.get("disc: moment of the fluid")[-1] / TORQUE - 1
        # A disc of radius R in a circle of radius 1 has the torque 4 pi mu R^2/(1 - R^2).
        shift = error / (2 / (0.5 * (1 - 0.5 ** 2))) / h
        figures.append(Figure(f"shift of the wall [cells], elements {height} high", shift,
                              gate=(-0.05, 0.05)))
    return figures


def evaluate_slanted_channel(runs):
    labels = ["automatic elements"] + [f"elements {height} high" for height in WALL_ELEMENTS]
    return [Figure(f"u in the middle [m/s], {label}", run.get("u at probe 1")[-1], 2., 0.004)
            for run, label in zip(runs, labels)]


def evaluate_eel_ibamr(runs):
    """The mean speed from t = 2.66 to 3.66 on three grids, with the index of scripts/sweep --mesh."""
    figures, speeds = [], []
    for run, spacing in zip(runs, EEL_SPACINGS.values()):
        x = np.interp((2.66, 3.66), run.time, run.get("eel: x of centre of mass"))
        speeds.append(x[0] - x[1])
        late = run.time > 1
        figures += [Figure(f"speed [L/T], {spacing}", speeds[-1]),
                    Figure(f"min J after a beat, {spacing}", run.get("eel: min J")[late].min()),
                    Figure(f"max J after a beat, {spacing}", run.get("eel: max J")[late].max())]
    _, middle, fine = speeds
    change = abs(fine / middle - 1)
    order, _ = extrapolate((4, 2, 1), speeds)
    figures.append(Figure("change of the speed on the finest grid [%]", 100 * change))
    if order is not None:
        figures += [Figure("observed order", order, gate=(1.5, math.inf)),
                    Figure("convergence index [%]", 100 * SAFETY * change / (2**order - 1), gate=(0, 3))]
    else:
        figures[-1].note, figures[-1].gate = "the grids do not converge monotonically", (0, 2)
    return figures
