# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures from the fields: vorticity, pressure, velocity, shapes of the bodies."""

import dataclasses

import matplotlib
import numpy as np

from . import MissingData, phases, style

NEAR = 0.1  # lengths from a body: within, vorticity is that of its boundary layer
ARROWS = 26  # across 1.9 lengths


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
    return body.points - get_data(body, "displacement")[:, :body.points.shape[1]]


def get_length(body):
    """The length of the undeformed body [m]."""
    return np.ptp(get_reference(body), axis=0).max()


def find_far(centres, bodies):
    """Which of the centres of cells are farther than NEAR from all bodies."""
    is_far = np.ones(len(centres), dtype=bool)
    for body in bodies.values():
        distance = NEAR * get_length(body)
        low, high = body.points.min(axis=0), body.points.max(axis=0)
        box = np.flatnonzero(((centres > low - distance) & (centres < high + distance)).all(axis=1))
        if len(box):
            nearest = np.full(len(box), np.inf)
            for point in body.points[::max(len(body.points) // 500, 1)]:
                nearest = np.minimum(nearest, ((centres[box] - point) ** 2).sum(axis=1))
            is_far[box[nearest < distance**2]] = False
    return is_far


def find_far_triangles(fluid, bodies):
    """Which triangles of the fluid are farther than NEAR from all bodies."""
    return find_far(fluid.points[fluid.cells].mean(axis=1), bodies)


def find_middle(strength, circulation):
    """The strength below which lies most of the circulation, rounded."""
    order = np.argsort(strength)
    circulation = np.cumsum(circulation[order])
    middle = np.searchsorted(circulation, 0.6 * circulation[-1])
    return style.get_round_limit(strength[order[min(middle, len(order) - 1)]])


def get_vorticity_limit(fluid, bodies):
    """End of the colour scale: below it lies most of the absolute circulation off the bodies; in
    three dimensions that about z.

    Extremes in the boundary layer would leave the wake without colour.
    """
    vorticity = get_data(fluid, "vorticity")
    vorticity = vorticity if vorticity.ndim == 1 else vorticity[:, 2]
    strength = abs(vorticity[fluid.cells].mean(axis=1))
    circulation = strength * fluid.sizes
    is_far = find_far_triangles(fluid, bodies)
    if (circulation * is_far).sum() > 0.01 * circulation.sum():  # there is a wake
        circulation = circulation * is_far
    return find_middle(strength, circulation)


def get_wake_window(body, domain):
    """A body with three lengths behind it, within the domain; of one size whatever the body's shape,
    as the pictures of a film must be."""
    length, (x0, _, y0, y1) = get_length(body), get_limits(body.points)
    window = []
    for start, size, low, high in ((x0 - 0.3 * length, 4.3 * length, *domain[:2]),
                                   ((y0 + y1) / 2 - 0.6 * length, 1.2 * length, *domain[2:])):
        start = max(low, min(start, high - size))
        window += [start, min(start + size, high)]
    return tuple(window)


def draw_vorticity(run, time=None, limit=None):
    """Vorticity with the bodies: the whole domain, and the first body with its wake."""
    time = run.times[-1] if time is None else time
    fluid, bodies = run.read_fluid(time), run.read_bodies(time)
    limit = limit or get_vorticity_limit(fluid, bodies)

    domain = get_limits(fluid.points)
    windows = [domain]
    if bodies:
        windows.append(get_wake_window(get_first_body(run, time), domain))

    heights = [(style.WIDTH - 1) * (w[3] - w[2]) / (w[1] - w[0]) for w in windows]
    figure, axes = style.make_figure(len(windows), 1, sum(heights) + 0.9 + 0.4 * len(windows),
                                     gridspec_kw={"height_ratios": heights})
    for panel, window in zip(axes[:, 0], windows):
        picture = style.draw_field(panel, fluid, get_data(fluid, "vorticity"), window, limit,
                                   "RdBu_r")
        style.draw_bodies(panel, bodies, with_names=panel is axes[-1, 0])
        panel.set_ylabel("y [m]")
    axes[0, 0].set_title(f"Vorticity in the whole domain, t = {time:.3f} s")
    if bodies:
        axes[1, 0].set_title(f"{next(iter(bodies))} and its wake")
    axes[-1, 0].set_xlabel("x [m]")
    figure.colorbar(picture, ax=axes, orientation="horizontal", extend="both", aspect=50,
                    shrink=0.6, label="vorticity [1/s], red: anticlockwise")
    return figure


@dataclasses.dataclass
class Scene:
    """What one panel of a sequence shows: the surroundings of the bodies."""

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


def get_window(run, times):
    """Width and height of what shows all bodies at each of the times, with room round them."""
    length, sizes = get_length(get_first_body(run, times[0])), []
    for time in times:
        points = np.concatenate([body.points for body in run.read_bodies(time).values()])
        sizes.append(np.ptp(points, axis=0))
    width, height = np.max(sizes, axis=0)
    return max(width + 0.8 * length, 1.9 * length), max(height + 0.5 * length, 0.84 * length)


def get_scene(run, time, size):
    fluid, length = run.read_fluid(time), get_length(get_first_body(run, time))
    x0, x1, y0, y1 = get_limits(np.concatenate([body.points for body in
                                                run.read_bodies(time).values()]))
    x, y = (x0 + x1) / 2 + 0.15 * length, (y0 + y1) / 2
    window = x - size[0] / 2, x + size[0] / 2, y - size[1] / 2, y + size[1] / 2

    inside = np.unique(fluid.triangles[fluid.clip(window)])
    pressure = get_data(fluid, "pressure")
    get_data(fluid, "velocity")
    spacing = 1.9 * length / ARROWS
    x, y = (np.arange(low + spacing / 2, high, spacing) for low, high in (window[:2], window[2:]))
    return Scene(time, fluid, window, pressure - np.median(pressure[inside]), inside, x, y,
                 fluid.sample("velocity", x, y))


def draw_arrows(panel, scene, unit, length):
    """The velocity, but where it is small; arrows whose tips would leave the picture are left out."""
    speed = scene.speed[..., None]
    velocity = scene.velocity * np.minimum(1, unit / np.maximum(speed, 1e-300))
    reach = 0.11 * length / unit
    x, y = np.meshgrid(scene.x, scene.y)
    tip_x, tip_y = x + reach * velocity[..., 0], y + reach * velocity[..., 1]
    x0, x1, y0, y1 = scene.window
    is_seen = ((speed[..., 0] > 0.05 * unit) & (tip_x > x0) & (tip_x < x1) & (tip_y > y0)
               & (tip_y < y1))
    velocity = np.where(is_seen[..., None], velocity, np.nan)
    return panel.quiver(scene.x, scene.y, velocity[..., 0], velocity[..., 1], angles="xy",
                        scale=1 / reach, scale_units="xy", units="inches", width=0.013, headwidth=3.5,
                        headlength=4, headaxislength=3.5, minlength=0.2, color="0.15")


def draw_keys(figure, axes, spare, picture, arrows, unit):
    """What arrows and colours mean; the colours in the place of the missing picture, if there is one."""
    height = arrows.axes.get_position().height * figure.get_figheight()  # [inch], about
    arrows.axes.quiverkey(arrows, 0.9, 1 + 0.1 / height, unit, f"{unit:g} m/s and more", labelpos="W")
    place = ({"cax": spare[0].inset_axes((0.1, 0.5, 0.8, 0.06))} if len(spare)
             else {"ax": axes, "aspect": 50, "shrink": 0.6})
    figure.colorbar(picture, orientation="horizontal", extend="both",
                    label="pressure − its median in the picture [Pa]", **place)


def draw_sequence(run, times, title, name_time):
    """Pressure in colours, velocity as arrows and the bodies, at several times, each with the name
    that name_time(time) gives it.

    The windows follow the bodies; the scales are those of all times together. Arrows end at the
    unit's length: longer ones would cross each other.
    """
    size = get_window(run, times)
    scenes = [get_scene(run, time, size) for time in times]
    length = get_length(get_first_body(run, times[0]))
    limit = style.get_round_limit(
        np.quantile(np.concatenate([abs(scene.pressure[scene.inside]) for scene in scenes]), 0.98))
    unit = style.get_round_limit(
        np.nanquantile(np.concatenate([scene.speed.ravel() for scene in scenes]), 0.95))

    columns = 2 if size[0] < 3 * size[1] and len(scenes) > 1 else 1
    rows = -(-len(scenes) // columns)
    figure, axes = style.make_figure(rows, columns, 1. + rows * (
        0.4 + (style.WIDTH - 0.7 * columns) / columns * size[1] / size[0]))
    spare = axes.flat[len(scenes):]
    for panel in spare:
        panel.set_axis_off()
    for panel, scene in zip(axes.flat, scenes):
        picture = style.draw_field(panel, scene.fluid, scene.pressure, scene.window, limit,
                                   style.PRESSURE)
        arrows = draw_arrows(panel, scene, unit, length)
        style.draw_bodies(panel, run.read_bodies(scene.time))
        panel.set_title(name_time(scene.time))
    for panel in axes[:, 0]:
        panel.set_ylabel("y [m]")
    for panel in [*axes[-1, :], *axes.flat[len(scenes) - columns:len(scenes)]]:
        panel.set_xlabel("x [m]")
    figure.suptitle(title)
    draw_keys(figure, axes, spare, picture, arrows, unit)
    return figure


def draw_start_up(run):
    times, period = phases.choose_start(run)
    title = "Start from rest: pressure (colours) and velocity (arrows)"
    if period is None:
        return draw_sequence(run, times, title, lambda time: f"t = {time:.3f} s")
    return draw_sequence(run, times, f"{title}; T = {period:.3f} s is the period of the first tail beat",
                         lambda time: f"t/T = {time / period:.2f}")


def draw_cruise(run):
    start, end = run.get_last_beat()
    period = end - start
    times = phases.choose_phases(run.times, start, period, phases.SEQUENCE)
    return draw_sequence(run, times, f"One tail beat of {run.bodies[0]} from t = {start:.3f} s, "
                         f"T = {period:.3f} s: pressure (colours) and velocity (arrows)",
                         lambda time: f"t/T = {(time - start) / period:.2f}")


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
    times = phases.choose_phases(run.times, start, end - start, phases.OUTLINES)
    names = list(run.read_bodies(times[-1]))
    if not names:
        raise MissingData("solution.pvd lists no body beside the fluid.")

    figure, axes = style.make_figure(len(names), 1, 0.4 + 2.9 * len(names))
    for panel, name in zip(axes[:, 0], names):
        bodies = [run.read(time, name) for time in times]
        frames = [get_frame(body) for body in bodies]
        heading = np.angle(np.mean(np.exp([1j * angle for _, angle in frames])))
        turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
        for time, body, (centre, _) in zip(times, bodies, frames):
            for polygon in body.outline:
                x, y = ((np.vstack([polygon, polygon[:1]]) - centre) @ turn).T
                panel.plot(x, y, color=style.PHASES((time - start) / (end - start)), linewidth=1.1)
        panel.set_aspect("equal")
        panel.set_title(f"{name}: outlines from t = {times[0]:.3f} to {times[-1]:.3f} s; "
                        "x and y have the same scale")
        panel.set_ylabel("y − centre [m]")
    axes[-1, 0].set_xlabel("x − centre [m]")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 1), style.PHASES)
    figure.colorbar(scale, ax=axes, shrink=0.8, label="phase of the beat t/T [1]")
    return figure
