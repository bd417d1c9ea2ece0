# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies under gravity, dead loads and prescribed motion, and the lift of an unsteady flow."""

import math

import numpy as np

from .figures import Figure

# The oscillating cylinder at rest, the fluid moving instead.
STREAM = (tuple(f"Fluid/Boundary conditions/{side}=inflow"
                for side in ("left", "right", "bottom", "top")) +
          ("Fluid/Inflow velocity=sin(2*pi*t/5); 0", "Fluid/Body force=2*pi/5*cos(2*pi*t/5); 0",
           "Body cylinder/Region body/Motion=fixed", "Body cylinder/Region body/Translation="))


def evaluate_falling_disc(runs):
    run = runs[0]
    weight = 0.5 * math.pi / 4
    speed = run.get("disc: v of centre of mass")
    half = len(speed) // 2
    return [Figure("drag by control volume [N/m]", run.get("force y by control volume")[-1], weight,
                   0.005),
            Figure("drag of the body [N/m]", run.get("disc: force y of the fluid")[-1], weight, 0.005),
            Figure("speed [m/s]", -speed[-1],
                   note=f"{100 * (speed[-1] / speed[half] - 1):.2g} % more than at half of the time")]


def evaluate_oscillating_cylinder(runs):
    """In the cylinder's frame the body force presses on it with rho pi/4 a."""
    moving, resting = runs
    time = moving.time
    acceleration = -2 * math.pi / 5 * np.cos(2 * math.pi / 5 * time)
    force = moving.get("cylinder: force x of the fluid")
    other = resting.get("cylinder: force x of the fluid") + math.pi / 4 * acceleration
    late = time > 0.5  # the start is at once
    difference = np.sqrt(np.mean((force - other)[late] ** 2) / np.mean(force[late] ** 2))
    return [Figure("difference of the forces, rms over rms", difference, gate=(0., 0.01)),
            Figure("largest force [N/m]", force[late].max(), other[late].max(), 0.01),
            Figure("smallest force [N/m]", force[late].min(), other[late].min(), 0.01)]


def evaluate_pulsating_channel(runs):
    """The largest lift coefficient with steps of 0.01 s and of 0.005 s: 2 F/(rho U^2 D), U = 1."""
    largest = [20 * run.get("cylinder: force y of the fluid")[run.time > 0.6].max() for run in runs]
    return [Figure("largest cL, steps of 0.01 s", largest[0], largest[1], 0.02,
                   "beside that with half of the step")]


def evaluate_pulled_rectangle(runs):
    run = runs[0]
    length = run.get("block: x of point 1")[-1] - run.get("block: x of point 3")[-1]
    return [Figure("half length [m]", length, 1.5, 0.002)] + evaluate_rest(
        runs, "block", 5.56e-3, 0.05, largest_rate=1e-5)


def evaluate_rest_under_pull(runs):
    return evaluate_rest(runs, "block", 5e-3, 0.01, largest_rate=1e-6)


def evaluate_squeezed_disc(runs):
    run = runs[0]
    speed = run.get("max velocity")
    residual = abs(run.get("energy residual")[-1] / run.get("dissipation")[-1])
    return [Figure("last speed over the largest", speed[-1] / speed.max(), gate=(0., 1e-4)),
            Figure("largest |area change| at the end", abs(run.get("disc: area change")[-1]),
                   gate=(0., 1e-3)),
            Figure("min J", run.get("disc: min J").min(), gate=(0.9, 1.1)),
            Figure("max J", run.get("disc: max J").max(), gate=(0.9, 1.1)),
            Figure("energy residual over dissipation", residual)]


def evaluate_rest(runs, body, area, gate, largest_rate):
    """Area change p/kappa, and what still moves at the end."""
    run = runs[0]
    change = run.get(f"{body}: area change")
    rate = (change[-1] - change[-5]) / (run.time[-1] - run.time[-5])
    speed = run.get("max velocity")
    return [Figure("area change", change[-1], area, gate),
            Figure("its rate [1/s]", rate, gate=(-largest_rate, largest_rate)),
            Figure("last speed [m/s]", speed[-1], gate=(0., 0.01))]
