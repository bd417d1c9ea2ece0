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
    ("Domain/Cells=6,6,6", "Time/End time=0.4", f"Time/Step={step}")
    for step in (0.05, 0.025, 0.0125))


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


def read_points(run, entry):
    """Points of a parameter, "x, y, z; ...", an array of (n, 3)."""
    return np.array([[float(c) for c in point.split(",")]
                     for point in run.parameters[entry].split(";")])


def find_zero(x, values):
    """Where values that are first negative become positive, between two samples; or nan."""
    for a, b, f, g in zip(x, x[1:], values, values[1:]):
        if f < 0 <= g:
            return a + (b - a) * f / (f - g)
    return math.nan


def evaluate_drag(reynolds, reference, has_wake=False):
    """Of a sphere of diameter 1 in a stream of velocity 1, density 1: Cd = 8 F/pi; also beside the
    standard drag curve of Clift, Grace and Weber (1978) for Reynolds numbers from 20 to 260."""
    curve = 24 / reynolds * (1 + 0.1935 * reynolds ** 0.6305)

    def evaluate(runs):
        run = runs[0]
        drag = 8 / math.pi * run.get("sphere: force x of the fluid")
        late = run.time >= 0.8 * run.time[-1]
        note = (f"Cd changes by {np.ptp(drag[late]):.1e} in the last "
                f"{0.2 * run.time[-1]:.3g} s")
        figures = [Figure("Cd", drag[-1], reference, 0.02, note),
                   Figure("Cd beside the standard drag curve", drag[-1], curve),
                   Figure("Cd by control volume",
                          8 / math.pi * run.get("force x by control volume")[-1], reference)]
        return figures + (measure_wake(run) if has_wake else [])
    return evaluate


def measure_wake(run):
    """Length of the recirculation, and the angle of separation from the front."""
    points = read_points(run, "Fluid/Probes")
    center = read_points(run, "Body sphere/Shape/Position")[0]
    velocities = np.array([[run.get(f"{c} at probe {k + 1}")[-1] for c in "uvw"]
                           for k in range(len(points))])
    offsets = points - center
    radii = np.linalg.norm(offsets, axis=1)
    axial = np.linalg.norm(offsets[:, 1:], axis=1) < 1e-9
    length = find_zero(radii[axial], velocities[axial, 0]) - 0.5
    # On arcs round the sphere in the plane z = 0 the tangential velocity, zero on the surface, is a
    # polynomial of the distance from it; separation is where its slope on the surface is zero.
    distances, along = [], []
    outwards = np.flatnonzero(~axial)[np.argsort(radii[~axial])]
    for arc in np.split(outwards, np.flatnonzero(np.diff(radii[outwards]) > 1e-3) + 1):
        arc.sort()
        theta = np.arctan2(offsets[arc, 1], -offsets[arc, 0])
        distances.append(radii[arc].mean() - 0.5)
        along.append(velocities[arc, 0] * np.sin(theta) + velocities[arc, 1] * np.cos(theta))
    powers = np.vander(distances, len(distances) + 1, increasing=True)[:, 1:]
    slopes = np.linalg.solve(powers, along)[0]
    separation = math.degrees(find_zero(theta, -slopes))
    signs = ", ".join(f"{math.degrees(find_zero(theta, -values)):.1f} at {distance:.3g} D"
                      for distance, values in zip(distances, along))
    return [Figure("recirculation length [D]", length, 0.875, (0.96 * 0.87, 1.04 * 0.88)),
            Figure("separation angle [degrees]", separation, 127, (125, 129),
                   f"the velocity changes its sign at {signs} off the surface")]


# The three translations of an ellipsoid with the axes 4 : 2 : 1.
ELLIPSOID_VARIANTS = tuple((f"Body ellipsoid/Region body/Translation={motion}",)
                           for motion in ("t; 0; 0", "0; t; 0", "0; 0; t"))
ADDED_MASSES = (0.12657072, 0.39817213, 1.51806128)


def evaluate_ellipsoid_start(runs):
    """k of T = (1 + k) rho V U^2/2 and of the impulse (1 + k) rho V U, U = 1, rho = 1."""
    volume = 4 / 3 * math.pi * 2 * 1 * 0.5
    figures = []
    for run, direction, k in zip(runs, "xyz", ADDED_MASSES):
        impulse = -run.get(f"ellipsoid: force {direction} of the fluid")[0] * run.time[0]
        energy = run.get("kinetic energy")[0]
        figures += [Figure(f"k along {direction} by the impulse", impulse / volume - 1, k, 0.03),
                    Figure(f"k along {direction} by the energy", 2 * energy / volume - 1, k)]
    return figures


def compute_force_from_rest(time, radius, viscosity, omega, speed):
    """On a sphere whose velocity is speed sin(omega t) from t = 0 on, in fluid of density 1."""
    n_points = 4000
    share = (np.arange(n_points) + 0.5) / n_points
    # The integral of du/ds / sqrt(t - s), with s = t - x^2, by the rule of midpoints.
    history = np.array([2 * math.sqrt(t) * speed * omega *
                        np.mean(np.cos(omega * t * (1 - share ** 2))) for t in time])
    return (6 * math.pi * viscosity * radius * speed * np.sin(omega * time)
            + 2 / 3 * math.pi * radius ** 3 * speed * omega * np.cos(omega * time)
            + 6 * radius ** 2 * math.sqrt(math.pi * viscosity) * history)


def fit_oscillation(time, values, omega):
    """Amplitude, and phase before sin(omega t) in degrees, by least squares."""
    waves = np.column_stack([np.sin(omega * time), np.cos(omega * time)])
    (sine, cosine), *_ = np.linalg.lstsq(waves, values, rcond=None)
    return math.hypot(sine, cosine), math.degrees(math.atan2(cosine, sine))


def evaluate_oscillating_sphere(runs):
    """Beside Landau and Lifshitz's force, from rest, over the last period; and the periodic one."""
    run = runs[0]
    radius, viscosity, omega, speed = 0.5, 0.19634954, 2 * math.pi, 0.04 * math.pi
    last = run.time > max(0.2, run.time[-1] - 1 + 1e-9)
    time = run.time[last]
    exact = compute_force_from_rest(time, radius, viscosity, omega, speed)
    amplitude, phase = fit_oscillation(
        time, -run.get("sphere: force x of the fluid")[last], omega)
    wanted, wanted_phase = fit_oscillation(time, exact, omega)
    delta = math.sqrt(2 * viscosity / omega)
    drag = 6 * math.pi * viscosity * radius * (1 + radius / delta)
    mass = (3 * math.pi * radius ** 2 * math.sqrt(2 * viscosity / omega)
            * (1 + 2 * radius / (9 * delta)))
    periodic = speed * math.hypot(drag, omega * mass)
    note = (f"the periodic force has {periodic:.4g} N and "
            f"{math.degrees(math.atan2(omega * mass, drag)):.4g} degrees")
    return [Figure("amplitude of the force [N]", amplitude, wanted, 0.02, note),
            Figure("phase before the velocity [degrees]", phase, wanted_phase,
                   (wanted_phase - 2, wanted_phase + 2))]


def evaluate_settling_sphere(free_fall, low, high):
    """The largest speed over that of free fall, within 3 % of what was published."""
    def evaluate(runs):
        run = runs[0]
        speed = -run.get("sphere: w of centre of mass")
        return [Figure("largest speed over that of free fall", speed.max() / free_fall,
                       (low + high) / 2, (0.97 * low, 1.03 * high),
                       f"at {run.time[speed.argmax()]:.3g} s of {run.time[-1]:.3g} s"),
                Figure("lowest centre [m]", run.get("sphere: z of centre of mass").min())]
    return evaluate


def evaluate_elastic_plate(runs):
    """The force on half of it, and how far a point moves downstream, when both are steady."""
    run = runs[0]
    force = 0.5 * run.get("plate: force x of the fluid")
    shift = run.get("plate: x of point 1") - 0.45
    late = run.time >= 0.8 * run.time[-1]
    note = f"it changes by {np.ptp(force[late]):.1e} N in the last {0.2 * run.time[-1]:.3g} s"
    return [Figure("force on half of the plate [N]", force[-1], 1.327, 0.03, note),
            Figure("ux of the point [m]", shift[-1], 5.924e-5, 0.03)]
