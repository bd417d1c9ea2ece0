# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a run of the swimmer in an ideal fluid."""

import re

import matplotlib
import numpy as np
from PIL import Image, ImageDraw

from caudal import MissingData, Run, fields, read_parameters
from caudal.tables import get_name
from caudal_plots import style
from caudal_salmon import paper, pictures

from . import common, files, movie, page
from .chart import make_chart, make_curve

TIME = "time [s]"
N_STROKES = 3  # of which torques are shown
ZERO = 1e-7  # of a turn or radius, what is round-off


def read_summary(run):
    """Names with units, and for each frequency their values, from summary.csv."""
    return list(run.summary), run.summary.values.tolist()


def read_statistics(run, frequencies):
    """For each frequency its columns over time, by name without unit."""
    return [run.read_statistics(f).rename(columns=get_name) for f in frequencies]


def make_engineers_table(names, values):
    """All results, a column for each frequency."""
    rows = []
    for k, name in enumerate(names[1:], 1):
        cells = [0. if name.startswith(("turn", "radius")) and abs(row[k]) < ZERO else row[k]
                 for row in values]
        rows.append([name] + [page.format_number(cell) for cell in cells])
    header = ["quantity"] + [f"{row[0]:g} " + page.make_element("small", "[Hz]") for row in values]
    return page.make_table(header, rows, "The whole fish, in three dimensions: nothing is per metre "
                                         "of span. Powers: mean over whole strokes; gross: of the "
                                         "moduli of the joints' powers.")


def make_tiles(names, values):
    """Key figures of the frequency in the middle."""
    row = values[len(values) // 2]
    found = {name.partition(" [")[0]: (row[k], name.partition(" [")[2].rstrip("]"))
             for k, name in enumerate(names)}
    wanted = ("frequency", "distance", "mean speed", "mean speed in body lengths",
              "displacement a stroke", "mean kinetic energy", "mean gross power",
              "cost of transport")
    return page.make_tiles([(name, page.format_number(found[name][0]), found[name][1])
                            for name in wanted if name in found])


def make_time_charts(frequencies, data):
    """Distance, speed, energy, power and path, a curve for each frequency."""
    def make(title, label, get, **options):
        curves = [make_curve(f"{f:g} Hz", columns["time"], get(columns), style.LINES[i % 7])
                  for i, (f, columns) in enumerate(zip(frequencies, data))]
        return make_chart(title, TIME, label, curves, group="time", zero=True, **options)

    charts = [make("Distance of the centre of mass", "distance [cm]", lambda c: 100 * c["distance"]),
              make("Speed of the centre of mass", "speed [cm/s]", lambda c: 100 * c["speed"]),
              make("Kinetic energy of fish and fluid", "kinetic energy [J]",
                   lambda c: c["kinetic energy"])]
    if all("power" in columns for columns in data):
        charts.append(make("Power of all joints", "power [W]", lambda c: c["power"],
                           note="It changes its sign: an ideal fluid gives back within a stroke "
                                "what it took."))
    paths = [make_curve(f"{f:g} Hz", 100 * c["x of centre of mass"], 100 * c["y of centre of mass"],
                        style.LINES[i % 7]) for i, (f, c) in enumerate(zip(frequencies, data))]
    charts.append(make_chart("Path of the centre of mass from above", "x [cm]", "y [cm]", paths,
                             equal=True))
    return charts


def make_torque_charts(frequencies, data):
    """The torques of the joints over the first strokes, which repeat themselves: a chart for each
    frequency."""
    charts = []
    for f, columns in zip(frequencies, data):
        names = [name for name in columns if re.match(r"torque of (joint|mode) \d+$", name)]
        if names:
            shown = columns[columns["time"] <= N_STROKES / f]
            curves = [make_curve(name.removeprefix("torque of "), shown["time"], shown[name],
                                 style.LINES[i % 7]) for i, name in enumerate(names)]
            charts.append(make_chart(f"Torques of the joints at {f:g} Hz: the first strokes", TIME,
                                     "torque [N m]", curves, zero=True))
    return charts


def make_relation_charts(names, values):
    """The empirical relations of the paper's table 2 with the points of this run."""
    columns = {name.partition(" [")[0]: np.array([row[k] for row in values])
               for k, name in enumerate(names)}
    f = columns["frequency"]
    if not np.all(f > 0):
        return []
    F = np.linspace(0.5, max(5., 1.1 * f.max()), 100)

    def make(title, label, relations, name, largest):
        curves = []
        for i, (relation_name, relation) in enumerate(relations):
            with np.errstate(invalid="ignore"):
                V = relation(F)
            # Negative speeds are no speeds; beyond the largest the curves would hide the rest.
            curves.append(make_curve(relation_name, F, np.where((V >= 0) & (V <= largest), V, np.nan),
                                     style.LINES[i % 7]))
        curves.append(make_curve("this run", f, columns[name], "#000000", markers=True, line=True,
                                 dash="3 3"))
        return make_chart(title, "tail-beat frequency F [Hz]", label, curves, zero=True, log=False)

    return [make("Speed in body lengths", "speed V [body lengths/s]", paper.RELATIONS_IN_LENGTHS,
                 "mean speed in body lengths", 6),
            make("Speed in cm/s", "speed V [cm/s]", [paper.RELATION_IN_CM], "mean speed", 70)]


def draw_surface(path, turn, window, size, limit):
    """The swimming surface from above, its pressure in colours."""
    corners, pressure = pictures.read_surface(path, 2)
    image = Image.new("RGB", size, "white")
    draw = ImageDraw.Draw(image)
    scale = size[0] / (window[1] - window[0])
    colours = style.PRESSURE(np.clip(0.5 + 0.5 * pressure / limit, 0, 1), bytes=True)
    for k in np.argsort(corners[:, :, 2].mean(axis=1)):  # the top covers the rest
        points = 100 * corners[k][:, :2] @ turn.T
        draw.polygon([((x - window[0]) * scale, (window[3] - y) * scale) for x, y in points],
                     fill=tuple(int(c) for c in colours[k][:3]))
    draw.line([(16, size[1] - 16), (16 + scale, size[1] - 16)], fill="black", width=2)
    draw.text((16, size[1] - 36), "1 cm", fill="black", font=movie.get_font(14))
    return movie.encode(image)


def make_surface_movie(folder, frequency, count):
    """The first outputs of the surface, in the order in which they follow each other."""
    path = folder / "solution.pvd"
    if not path.is_file():
        raise MissingData(f"There is no {path}. Pictures need Output/Format = vtu.")
    series = pictures.read_series(folder, frequency)
    if len(series) < 2:
        raise MissingData("solution.pvd lists fewer than two surfaces.")
    for _, file in series:
        fields.check_whole(file)
    turn, series = pictures.get_turn(series), series[:count]
    points = np.concatenate([100 * pictures.read_surface(series[k][1])[0].reshape(-1, 3)[:, :2]
                             @ turn.T for k in range(0, len(series), max(len(series) // 8, 1))])
    (x0, y0), (x1, y1) = points.min(axis=0) - 1., points.max(axis=0) + 1.
    size = movie.WIDTH, round(movie.WIDTH * (y1 - y0) / (x1 - x0))
    limit = style.get_round_limit(np.percentile(
        np.abs(pictures.read_surface(series[len(series) // 2][1])[1]), 90))
    frames = [draw_surface(file, turn, (x0, x1, y0, y1), size, limit) for _, file in series]
    stops = ", ".join(matplotlib.colors.to_hex(style.PRESSURE(k / 12)) for k in range(13))
    scale = page.Html(f'<div class="scale">pressure [Pa] −{limit:g} <span class="bar" style="'
                      f'background: linear-gradient(to right, {stops})"></span> {limit:g}</div>')
    return movie.Movie(f"The swimming surface from above at {frequency:g} Hz, swimming to the left: "
                       f"the first {len(series)} outputs", "webp", frames,
                       [f"t = {time:.2f} s" for time, _ in series], scale)


def draw_swimming(folder, frequencies):
    """The fish through a stroke, and on its way, at each frequency."""
    for f in frequencies:
        for _, file in pictures.read_series(folder, f):
            fields.check_whole(file)
    return pictures.draw_swimming(folder.parent, [(folder.name, f) for f in frequencies], "")


def describe(folder, n_frames, with_pictures):
    """The page of a run; MissingData if what it can't do without is not there."""
    entries, log, run = read_parameters(folder), files.Log(folder), Run(folder)
    names, values = read_summary(run)
    frequencies = [row[0] for row in values]
    data = read_statistics(run, frequencies)
    middle = frequencies[len(frequencies) // 2]
    report = page.Page(f"Caudal: {folder.resolve().name}, a swimmer in an ideal fluid",
                       f"t = 0 to {data[0]['time'].iloc[-1]:g} s at "
                       + ", ".join(f"{f:g}" for f in frequencies) + " strokes a second, "
                       f"{common.make_state(log)}.")
    report.add("Results", make_tiles(names, values)
               + page.make_note(f"Key figures: at {middle:g} Hz.")
               + make_engineers_table(names, values)
               + page.make_note("The fluid is ideal: no viscous drag, no boundary layer, no wake, and "
                                "so no thrust from shed vortices. Work done in a part of the stroke is "
                                "returned in another: net work of a stroke is zero, speed is in "
                                "proportion to frequency. Compare trends."))
    if n_frames > 0:
        report.add("The fish", common.place_movie(
            report, lambda: make_surface_movie(folder, middle, n_frames)))
    hint = page.make_note("Drag over a span of time to zoom (all charts), double click for the whole "
                          "run, hover to read values, click a name to hide its curve.")
    report.add("Motion, energy and power", hint
               + report.place_charts(make_time_charts(frequencies, data)))
    torques = make_torque_charts(frequencies, data)
    if torques:
        report.add("Torques", report.place_charts(torques))
    relations = make_relation_charts(names, values)
    if relations:
        report.add("Speed and frequency: empirical relations", page.make_note(
            "Empirical relations that Yao et al. collect, with the units of their sources as far as "
            "they say, beside this run: no agreement is claimed.") + report.place_charts(relations))
    if with_pictures and n_frames > 0:
        report.add("Pictures", common.draw_picture(
            report, lambda: draw_swimming(folder, frequencies), "One stroke, and the way of the whole run"))
    report.add("Next", common.make_next_steps(folder, log, "Body fish/Gait/Frequency=0.5:2:7",
                                                  has_plots=False))
    report.add("Warnings", common.make_warnings(log))
    costs = [line for line in log.lines if line.startswith(("Table of phases", "CPU of rank 0"))]
    report.add("Time spent", page.join(page.make_note(line) for line in costs)
               or page.make_note("The log tells no costs."))
    report.add("Program, grid and body", common.make_program(log))
    report.add("Parameters", common.make_parameters(entries, folder))
    return report
