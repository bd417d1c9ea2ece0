# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases in three dimensions: an exact flow, spheres, an ellipsoid."""

import math

import numpy as np

from .figures import Figure

# Ethier and Steinman's flow: uniform grids and grids whose half has cells of half the size, each
# with 4 and 8 cells along an edge, then three steps on one grid.
ETHIER_STEINMAN_VARIANTS = tuple(
    (f"Domain/Cells={n},{n},{n}", f"Refinement/Level expression={level}")
    for level in ("0", "if(x>0,1,0)") for n in (4, 8)) + tuple(
    ("Domain/Cells=6,6,6", "Time/End time=0.4", f"Time/Step={step}") for step in (0.05, 0.025, 0.0125))


def evaluate_ethier_steinman(runs):
    """Orders in space within 0.15; that in time from what halving the step changes, twice."""
    figures = []
    for kind, (coarse, fine) in zip(("uniform", "hanging nodes"), (runs[:2], runs[2:4])):
        for quantity, order in (("velocity", 3), ("pressure", 2)):
            ratio = coarse.get(f"{quantity} error")[-1] / fine.get(f"{quantity} error")[-1]
            figures.append(Figure(f"{quantity} order, {kind}", math.log2(ratio), order,
                                  (order - 0.15, order + 0.15)))
    ends = [np.array([run.get(f"{component} at probe {k}")[-1] for k in (1, 2, 3)
                      for component in "uvw"]) for run in runs[4:]]
    changes = [np.linalg.norm(b - a) for a, b in zip(ends, ends[1:])]
    return figures + [Figure("velocity order in time", math.log2(changes[0] / changes[1]), 2,
                             (1.9, math.inf))]
