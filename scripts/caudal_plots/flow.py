"""Figures from the fields: vorticity, pressure, velocity, shapes of the bodies."""

import matplotlib
import numpy as np

from . import style
from .results import MissingData

# The times [s] at which the paper describes the start-up (figure 8).
START_UP_TIMES = (0.07, 0.14, 0.18, 0.22, 0.27, 0.32, 0.4, 0.5)
N_CRUISE_TIMES = 8


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


def draw_sequence(run, times, title):
    """Pressure in colours, velocity as arrows and the bodies, at several times.

    The windows follow the first body; the scales are those of all times together.
    """
    length = get_length(get_first_body(run, times[0]))
    half = 0.95 * length, 0.42 * length

    pictures = []
    for time in times:
        fluid = run.read_fluid(time)
        x0, x1, y0, y1 = get_limits(get_first_body(run, time).points)
        centre = (x0 + x1) / 2 + 0.15 * length, (y0 + y1) / 2
        window = (centre[0] - half[0], centre[0] + half[0],
                  centre[1] - half[1], centre[1] + half[1])
        x = np.linspace(window[0], window[1], 40)[1:-1]
        y = np.linspace(window[2], window[3], 19)[1:-1]
        inside = np.unique(fluid.triangles[fluid.clip(window)])
        pressure = get_data(fluid, "pressure")
        pressure = pressure - np.median(pressure[inside])
        get_data(fluid, "velocity")
        pictures.append((time, fluid, window, pressure, abs(pressure[inside]), x, y,
                         fluid.sample("velocity", x, y)))

    limit = style.get_round_limit(np.quantile(np.concatenate([p[4] for p in pictures]), 0.97))
    speeds = np.concatenate([np.hypot(p[7][..., 0], p[7][..., 1]).ravel() for p in pictures])
    unit = style.get_round_limit(np.nanquantile(speeds, 0.97))

    rows = (len(times) + 1) // 2
    figure, axes = style.make_figure(rows, 2, 0.9 + rows * 2.15)
    for panel in axes.flat[len(times):]:
        panel.set_axis_off()
    for panel, (time, fluid, window, pressure, _, x, y, velocity) in zip(axes.flat, pictures):
        picture = style.draw_field(panel, fluid, pressure, window, limit, "PuOr_r")
        arrows = panel.quiver(x, y, velocity[..., 0], velocity[..., 1], angles="xy",
                              scale=unit / (0.09 * length), scale_units="xy", width=0.0018,
                              color="0.15")
        style.draw_bodies(panel, run.read_bodies(time))
        panel.set_title(f"t = {time:.3f} s")
    for panel in axes[:, 0]:
        panel.set_ylabel("y [m]")
    for panel in axes[-1, :]:
        panel.set_xlabel("x [m]")
    figure.suptitle(title, fontsize=10)
    axes[0, 1].quiverkey(arrows, 0.86, 1.07, unit, f"{unit:g} m/s", labelpos="E")
    figure.colorbar(picture, ax=axes, orientation="horizontal", extend="both", aspect=50,
                    shrink=0.6, label="pressure − its median in the picture [Pa]")
    return figure


def draw_start_up(run):
    return draw_sequence(run, run.get_nearest_times(START_UP_TIMES), "start-up")


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
    times = [time for time in run.times if start - 1e-9 <= time <= end + 1e-9]
    if len(times) < 3:
        raise MissingData("Fewer than three outputs of the fields lie in the last tail beat. "
                          "Make Output/Interval of fields smaller.")
    names = list(run.read_bodies(times[-1]))
    if not names:
        raise MissingData("solution.pvd lists no body beside the fluid.")

    figure, axes = style.make_figure(len(names), 1, 0.9 + 3.4 * len(names))
    colours = matplotlib.colormaps["twilight_shifted"]
    for panel, name in zip(axes[:, 0], names):
        bodies = [run.read(time, name) for time in times]
        frames = [get_frame(body) for body in bodies]
        heading = np.angle(np.mean(np.exp([1j * angle for _, angle in frames])))
        turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
        for time, body, (centre, _) in zip(times, bodies, frames):
            for polygon in body.outline:
                x, y = ((np.vstack([polygon, polygon[:1]]) - centre) @ turn).T
                panel.plot(x, y, color=colours((time - start) / (end - start)), linewidth=0.9)
        panel.set_aspect("equal")
        panel.set_title(f"{name}: {len(times)} outlines between t = {start:.3f} and {end:.3f} s")
        panel.set_ylabel("y − centre [m]")
    axes[-1, 0].set_xlabel("x − centre [m]")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), colours)
    figure.colorbar(scale, ax=axes, shrink=0.8, label="phase of the beat [1]")
    return figure
