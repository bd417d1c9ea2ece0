# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures from the fields: vorticity, pressure, velocity, shapes of the bodies."""

import dataclasses

import matplotlib
import numpy as np

from . import MissingData, style

# The times [s] at which the paper describes the start-up (figure 8).
START_UP_TIMES = (0.07, 0.14, 0.18, 0.22, 0.27, 0.32, 0.4, 0.5)
N_CRUISE_TIMES = 8
N_OUTLINES = 12


def get_data(field, name):
    if name not in field.data:
        raise MissingData(f"The fields have no point data <{name}>.")
    return field.data[name]


def get_limits(points):
    """(x0, x1, y0, y1) of some points."""
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return x0, x1, y0, y1


def get_first_body(run, time):
    bodies = run.read_bodies(time)
    if not bodies:
        raise MissingData("solution.pvd lists no body beside the fluid.")
    return next(iter(bodies.values()))


def get_reference(body):
    """The body's points before the deformation."""
    return body.points - get_data(body, "displacement")[:, :2]


def get_length(body):
    """The length of the undeformed body [m]."""
    return np.ptp(get_reference(body), axis=0).max()


def get_vorticity_limit(fluid):
    """End of the colour scale: below it lies most of the flow's absolute circulation.

    Extremes in the boundary layer would leave the wake without colour.
    """
    strength = abs(get_data(fluid, "vorticity")[fluid.triangles].mean(axis=1))
    order = np.argsort(strength)
    circulation = np.cumsum((strength * fluid.areas)[order])
    middle = np.searchsorted(circulation, 0.6 * circulation[-1])
    return style.get_round_limit(strength[order[min(middle, len(order) - 1)]])


def draw_vorticity(run, time=None, limit=None):
    """Vorticity with the bodies: the whole domain, and the first body with its wake."""
    time = run.times[-1] if time is None else time
    fluid, bodies = run.read_fluid(time), run.read_bodies(time)
    limit = limit or get_vorticity_limit(fluid)

    domain = get_limits(fluid.points)
    windows = [domain]
    if bodies:
        body = get_first_body(run, time)
        length, (x0, x1, y0, y1) = get_length(body), get_limits(body.points)
        middle = (y0 + y1) / 2
        near = (x0 - 0.3 * length, x1 + 3 * length, middle - 0.6 * length, middle + 0.6 * length)
        windows.append((max(near[0], domain[0]), min(near[1], domain[1]),
                        max(near[2], domain[2]), min(near[3], domain[3])))

    heights = [(style.WIDTH - 1) * (w[3] - w[2]) / (w[1] - w[0]) for w in windows]
    figure, axes = style.make_figure(len(windows), 1, sum(heights) + 0.9 + 0.4 * len(windows),
                                     gridspec_kw={"height_ratios": heights})
    for panel, window in zip(axes[:, 0], windows):
        picture = style.draw_field(panel, fluid, get_data(fluid, "vorticity"), window, limit,
                                   "RdBu_r")
        style.draw_bodies(panel, bodies)
        panel.set_ylabel("y [m]")
    axes[0, 0].set_title(f"vorticity, t = {time:.3f} s")
    axes[-1, 0].set_xlabel("x [m]")
    figure.colorbar(picture, ax=axes, orientation="horizontal", extend="both", aspect=50,
                    shrink=0.6, label="vorticity [1/s], red: anticlockwise")
    return figure


@dataclasses.dataclass
class Scene:
    """What one panel of a sequence shows: the surroundings of the first body."""

    time: float
    fluid: object
    window: tuple
    pressure: np.ndarray  # of all points, minus the median in the window [Pa]
    inside: np.ndarray    # the points in the window
    x: np.ndarray         # the arrows' lattice
    y: np.ndarray
    velocity: np.ndarray  # on the lattice [m/s]

    @property
    def speed(self):
        return np.hypot(self.velocity[..., 0], self.velocity[..., 1])


def get_scene(run, time):
    fluid, body = run.read_fluid(time), get_first_body(run, time)
    length, (x0, x1, y0, y1) = get_length(body), get_limits(body.points)
    x, y = (x0 + x1) / 2 + 0.15 * length, (y0 + y1) / 2
    window = x - 0.95 * length, x + 0.95 * length, y - 0.42 * length, y + 0.42 * length

    inside = np.unique(fluid.triangles[fluid.clip(window)])
    pressure = get_data(fluid, "pressure")
    get_data(fluid, "velocity")
    x, y = np.linspace(*window[:2], 40)[1:-1], np.linspace(*window[2:], 19)[1:-1]
    return Scene(time, fluid, window, pressure - np.median(pressure[inside]), inside, x, y,
                 fluid.sample("velocity", x, y))


def draw_sequence(run, times, title):
    """Pressure in colours, velocity as arrows and the bodies, at several times.

    The windows follow the first body; the scales are those of all times together.
    """
    scenes = [get_scene(run, time) for time in times]
    length = get_length(get_first_body(run, times[0]))
    limit = style.get_round_limit(
        np.quantile(np.concatenate([abs(scene.pressure[scene.inside]) for scene in scenes]), 0.98))
    unit = style.get_round_limit(
        np.nanquantile(np.concatenate([scene.speed.ravel() for scene in scenes]), 0.98))

    rows = (len(scenes) + 1) // 2
    figure, axes = style.make_figure(rows, 2, 1. + rows * 2.03)
    for panel in axes.flat[len(scenes):]:
        panel.set_axis_off()
    for panel, scene in zip(axes.flat, scenes):
        picture = style.draw_field(panel, scene.fluid, scene.pressure, scene.window, limit,
                                   style.PRESSURE)
        velocity = np.where(scene.speed[..., None] > 0.02 * unit, scene.velocity, np.nan)
        arrows = panel.quiver(scene.x, scene.y, velocity[..., 0], velocity[..., 1], angles="xy",
                              scale=unit / (0.08 * length), scale_units="xy", width=0.0018,
                              color="0.15")
        style.draw_bodies(panel, run.read_bodies(scene.time))
        panel.set_title(f"t = {scene.time:.3f} s")
    for panel in axes[:, 0]:
        panel.set_ylabel("y [m]")
    for panel in axes[-1, :]:
        panel.set_xlabel("x [m]")
    figure.suptitle(title)
    axes[0, 1].quiverkey(arrows, 0.86, 1.07, unit, f"{unit:g} m/s", labelpos="E")
    figure.colorbar(picture, ax=axes, orientation="horizontal", extend="both", aspect=50,
                    shrink=0.6, label="pressure − its median in the picture [Pa]")
    return figure


def draw_start_up(run):
    times = run.get_nearest_times(START_UP_TIMES) or run.times[-1:]  # of a shorter run the last one
    return draw_sequence(run, times, "start-up")


def draw_cruise(run):
    start, end = run.get_last_beat()
    times = run.get_nearest_times(np.linspace(start, end, N_CRUISE_TIMES, endpoint=False))
    return draw_sequence(run, times, f"one tail beat, T = {end - start:.3f} s")


def get_frame(body):
    """Centre of area and heading angle [rad]: the rigid motion nearest to the deformation."""
    corners = body.triangles
    centres, origins = (p[corners].mean(axis=1) for p in (body.points, get_reference(body)))
    centre, origin = (np.average(p, axis=0, weights=body.areas) for p in (centres, origins))
    a, b = origins - origin, centres - centre
    angle = np.arctan2(np.sum(body.areas * np.cross(a, b)),
                       np.sum(body.areas * np.sum(a * b, axis=1)))
    return centre, angle


def draw_body_wave(run):
    """Outlines through the last tail beat in a frame that moves with the centre of area.

    The frame does not turn with the beat; it is turned by the beat's mean heading.
    """
    start, end = run.get_last_beat()
    times = run.get_nearest_times(np.linspace(start, end, N_OUTLINES, endpoint=False))
    names = list(run.read_bodies(times[-1]))
    if not names:
        raise MissingData("solution.pvd lists no body beside the fluid.")

    figure, axes = style.make_figure(len(names), 1, 0.4 + 2.9 * len(names))
    colours = matplotlib.colors.ListedColormap(
        matplotlib.colormaps["plasma"](np.linspace(0, 0.9, 256)))
    for panel, name in zip(axes[:, 0], names):
        bodies = [run.read(time, name) for time in times]
        frames = [get_frame(body) for body in bodies]
        heading = np.angle(np.mean(np.exp([1j * angle for _, angle in frames])))
        turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
        for time, body, (centre, _) in zip(times, bodies, frames):
            for polygon in body.outline:
                x, y = ((np.vstack([polygon, polygon[:1]]) - centre) @ turn).T
                panel.plot(x, y, color=colours((time - start) / (end - start)), linewidth=1.1)
        panel.set_aspect("equal")
        panel.set_title(f"{name}: outlines from t = {times[0]:.3f} to {times[-1]:.3f} s")
        panel.set_ylabel("y − centre [m]")
    axes[-1, 0].set_xlabel("x − centre [m]")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), colours)
    figure.colorbar(scale, ax=axes, shrink=0.8, label="phase of the beat [1]")
    return figure
