# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures from statistics.txt: quantities over time."""

import numpy as np

from . import MissingData, style

START_UP = (0., 0.5)  # [s]


def get_spans(run):
    """Title and limits of the time axes: the whole run, its start, its last tail beat."""
    spans = [("whole run", run.time[0], run.time[-1])]
    if run.time[-1] > START_UP[1]:
        spans.append(("start-up", *START_UP))
    try:
        spans.append(("last tail beat", *run.get_last_beat()))
    except MissingData:
        pass
    return spans


def set_span(axes, start, end, values):
    """Limits of both axes so that the values between the times fill the height."""
    axes.set_xlim(start, end)
    low, high = min(v.min() for v in values), max(v.max() for v in values)
    margin = 0.06 * (high - low) or 1e-3
    axes.set_ylim(low - margin, high + margin)


def find_point(run):
    """The place whose way all bodies tell, its name on the axes and that in the title: the first monitored point,
    or, without such, the centre of mass."""
    try:
        for body in run.bodies:
            run.find(f"{body}: x of point 1")
    except MissingData:
        return "centre of mass", "\nthe centre of mass", "the centre of mass"
    return "point 1", " A", "the first monitored point, A"


def draw_speed(run):
    """Speed and displacement of point A, or of the centre of mass, of all bodies; forward is -x."""
    spans = get_spans(run)
    figure, axes = style.make_figure(2, len(spans), 4.8)
    curves = []
    point, name, long_name = find_point(run)
    for body in run.bodies:
        x = run.get(f"{body}: x of {point}")
        curves.append((body, (-run.get(f"{body}: u of {point}"), x[0] - x)))

    for column, (title, start, end) in enumerate(spans):
        inside = (run.time >= start) & (run.time <= end)
        for row in range(2):
            panel = axes[row, column]
            for body, values in curves:
                panel.plot(run.time, values[row], label=body)
            set_span(panel, start, end, [values[row][inside] for _, values in curves])
        axes[0, column].set_title(f"({'abc'[column]}) {title}")
        axes[1, column].set_xlabel("time [s]")
        axes[0, column].axhline(0, color="0.5", linewidth=0.6)
    axes[0, 0].set_ylabel(f"speed of{name} [m/s]")
    axes[1, 0].set_ylabel(f"displacement of{name} [m]")
    figure.suptitle(f"Speed and way of {long_name}, positive towards −x")
    if len(curves) > 1:
        axes[0, 0].legend()
    return figure


def draw_volume(run):
    """How well the bodies keep their area, as a whole and in each point."""
    figure, axes = style.make_figure(2, 1, 4.6, sharex=True)
    for body, colour in zip(run.bodies, np.resize(style.LINES, len(run.bodies))):
        axes[0, 0].plot(run.time, 100 * run.get(f"{body}: area change"), color=colour, label=body)
        axes[1, 0].fill_between(run.time, run.get(f"{body}: min J"), run.get(f"{body}: max J"),
                                color=colour, alpha=0.5, linewidth=0, label=body)
    axes[0, 0].set_ylabel("change of area [%]")
    axes[1, 0].set_ylabel("range of $J = \\det F$ [1]")
    axes[1, 0].axhline(1, color="0.4", linewidth=0.6)
    axes[1, 0].set_xlabel("time [s]")
    axes[1, 0].set_xlim(run.time[0], run.time[-1])
    axes[0, 0].legend()
    return figure


def draw_energy(run):
    """muscle work + external = kinetic + elastic + dissipation + feedback + residual, since the start.

    Feedback is what springs and dampers take up: minus their work on the bodies.
    """
    def get_sum(name):
        return sum(run.get(f"{body}: {name}") for body in run.bodies)

    kinetic = run.get("kinetic energy")
    curves = (("muscle work", get_sum("muscle work"), dict(linewidth=2)),
              ("kinetic energy", kinetic - kinetic[0], {}),
              ("elastic energy", get_sum("elastic energy"), {}),
              ("dissipation", run.get("dissipation"), {}),
              ("numerical dissipation", run.get("numerical dissipation"), dict(linestyle="--")),
              ("feedback", -get_sum("feedback work"), {}),
              ("external work", run.get("external work"), {}),
              ("residual", run.get("energy residual"), dict(linestyle="--")))
    figure, axes = style.make_figure(2, 1, 5.4, sharex=True, gridspec_kw={"height_ratios": (3, 1)})
    for label, values, options in curves:
        axes[0, 0].plot(run.time, values, color=style.COLOURS[label], label=label if label !=
                        "numerical dissipation" else "numerical part of the dissipation", **options)
    axes[0, 0].axhline(0, color="0.5", linewidth=0.6)
    axes[0, 0].set_ylabel(f"energy since the start [{run.get_unit('kinetic energy')}]")
    axes[0, 0].set_title("Where the muscles' work goes: muscle work + external work = kinetic + "
                         "elastic energy + dissipation + feedback + residual")
    axes[0, 0].legend(loc="upper left", ncol=2)

    axes[1, 0].semilogy(run.time, np.maximum(abs(run.get("power identity")), 1e-18), linewidth=0.8)
    axes[1, 0].set_ylabel("power identity,\nrelative error [1]")
    axes[1, 0].set_xlabel("time [s]")
    axes[1, 0].set_xlim(run.time[0], run.time[-1])
    return figure
