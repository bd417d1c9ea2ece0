# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a run of the immersed swimmer."""

import numpy as np

from caudal import Run, read_parameters
from caudal_plots import style
from caudal_plots.main import get_figures

from . import common, files, movie, page, school, tables
from .chart import DASHED, make_chart, make_curve, make_curves

SPAN = "Two dimensions: masses, forces, powers and energies are those of one metre of span."
RESIDUAL = ("The residual holds what the other parts do not: changes of the grid, and what the time "
            "scheme takes from the body, which falls with the time step.")
TIME = "time [s]"
AS_CHARTS = ("speed", "volume", "energy")  # of what scripts/plot draws


def get_sum(run, name):
    return sum(run.get(f"{body}: {name}") for body in run.bodies)


def get_unit(run, name):
    """The unit of a column of the bodies: in two dimensions it is per metre."""
    return run.get_unit(f"{run.bodies[0]}: {name}")


def make_body_curve(run, body, name, values, **options):
    """A curve in the colour of its body, which is the same in all charts."""
    colour = style.LINES[run.bodies.index(body) % len(style.LINES)]
    return make_curve(name, run.time, values, colour, **options)


def make_motion_charts(run):
    """Speed, way, tail and heading of all bodies."""
    t = run.time
    speed, way, tail = [], [], []
    for body in run.bodies:
        x = run.get(f"{body}: x of centre of mass")
        speed.append(make_body_curve(run, body, f"{body}, centre of mass",
                                     -run.get(f"{body}: u of centre of mass")))
        if f"{body}: u of point 1 [m/s]" in run.columns:
            speed.append(make_body_curve(run, body, f"{body}, point 1",
                                         -run.get(f"{body}: u of point 1"), dash=DASHED))
        way.append((body, x[0] - x))
        tail.append((body, run.get(f"{body}: lateral position")))
    options = {"group": "time", "zero": True}
    return [make_chart("Speed, positive towards −x", TIME, "speed [m/s]", speed, **options),
            make_chart("Way of the centre of mass towards −x", TIME, "way [m]", make_curves(t, way),
                       **options),
            make_chart("Tail: lateral position of the muscle's monitored point", TIME,
                       "lateral position [m]", make_curves(t, tail), **options),
            make_chart("Muscle power", TIME, f"power [{get_unit(run, 'muscle power')}]",
                       make_curves(t, [(body, run.get(f"{body}: muscle power"))
                                       for body in run.bodies]), **options)]


def make_force_charts(run):
    """Forces on the bodies, by d(mv)/dt if the mass is known, and body forces."""
    axial, lateral = [], []
    for body in run.bodies:
        axial.append(make_body_curve(run, body, f"{body}, axial (x)",
                                     run.get(f"{body}: force x of the fluid")))
        lateral.append(make_body_curve(run, body, f"{body}, lateral (y)",
                                       run.get(f"{body}: force y of the fluid"), dash=DASHED))
    note = ("By the flow round the body: the rate of change of the momentum of the fluid in its "
            "place, less the resultant of the body's forces.")
    unit = get_unit(run, "force x of the fluid")
    return [make_chart("Force of the fluid on the body", TIME, f"force [{unit}]",
                       axial + lateral, group="time", zero=True, note=note)]


def make_momentum_chart(run, reports):
    """m dv/dt forward, where the mass is known from the swim report."""
    t, curves = run.time, []
    for report in reports:
        v = -run.get(f"{report['body']}: u of centre of mass")
        rate = report["constants"]["mass"]["value"] * np.gradient(v, t)
        curves.append((report["body"], rate))
    if not curves:
        return []
    unit = get_unit(run, "force x of the fluid")
    return [make_chart("Net force forward, d(mv)/dt", TIME, f"force [{unit}]",
                       make_curves(t, curves), group="time", zero=True,
                       note="Its positive part is the thrust, its negative part the drag of the "
                            "table of tail beats, if nothing else pushes the body forward.")]


def make_quality_charts(run):
    """Area and J of the bodies, cells, steps and solver."""
    t, area, jacobian = run.time, [], []
    for k, body in enumerate(run.bodies):
        area.append((body, 100 * run.get(f"{body}: area change")))
        colour = style.LINES[k % len(style.LINES)]
        jacobian += [make_curve(f"{body}, largest J", t, run.get(f"{body}: max J"), colour),
                     make_curve(f"{body}, smallest J", t, run.get(f"{body}: min J"), colour,
                                dash=DASHED)]
    numbers = [make_curve("CFL number of the flow", t, run.get("CFL"), style.LINES[0]),
               make_curve("of the body", t, run.get("body CFL"), style.LINES[1])]
    identity = np.maximum(abs(run.get("power identity")), 1e-18)
    return [make_chart("Change of the bodies' area", TIME, "change of area [%]",
                       make_curves(t, area), group="time", zero=True),
            make_chart("Range of J = det F in the bodies", TIME, "J [1]", jacobian, group="time"),
            make_chart("Cells of the fluid's grid", TIME, "cells [1]",
                       make_curves(t, [("cells", run.get("cells"))]), group="time"),
            make_chart("Time step", TIME, "time step [s]",
                       make_curves(t, [("time step", run.get("time step"))]), group="time",
                       zero=True),
            make_chart("CFL numbers", TIME, "CFL number [1]", numbers, group="time", zero=True),
            make_chart("Iterations of the solver in a step", TIME, "iterations [1]",
                       make_curves(t, [("iterations", run.get("iterations"))]), group="time",
                       zero=True),
            make_chart("Power identity: body against fluid", TIME, "relative difference [1]",
                       make_curves(t, [("difference", identity)]), group="time", log=True)]


def get_ledger(run):
    """(name, values, is on the right hand side) of the energy ledger over time."""
    kinetic = run.get("kinetic energy")
    ledger = [("muscle work", get_sum(run, "muscle work")),
              ("change of kinetic energy", kinetic - kinetic[0]),
              ("change of elastic energy", get_sum(run, "elastic energy")),
              ("dissipation", run.get("dissipation")),
              ("taken by feedback", -get_sum(run, "feedback work")),
              ("external work, taken off", -run.get("external work")),
              ("residual", run.get("energy residual"))]
    return ledger


def make_ledger_section(run, report, reports):
    t, ledger, unit = run.time, get_ledger(run), run.get_unit("kinetic energy")
    listed = list(ledger)
    listed.insert(4, ("– of it by stabilisations and time scheme", run.get("numerical dissipation")))
    curves = [make_curve(name, t, values, colour) for (name, values), colour in
              zip(listed, style.COLOURS.values())]
    curves[0].update(width=2.2)
    for k in (4, 7):  # a part of another curve, and what is no part
        curves[k].update(dash=DASHED)
    charts = [make_chart("Energy since the start", TIME, f"energy [{unit}]", curves, group="time",
                         zero=True),
              make_chart("Residual of the ledger", TIME, f"residual [{unit}]",
                         [make_curve("residual", t, ledger[-1][1], style.COLOURS["residual"])], group="time", zero=True)]
    work = ledger[0][1][-1]
    rows = [(name, page.format_number(values[-1]),
             page.format_number(100 * values[-1] / work if work else None, 3))
            for name, values in listed]
    total = page.make_table((f"at t = {t[-1]:.3f} s", f"energy [{unit}]", "[% of muscle work]"), rows,
                            "muscle work = changes of kinetic and elastic energy + dissipation + "
                            "taken by feedback − external work (through the sides and by the "
                            "body force) + residual")
    content = total + page.make_note(RESIDUAL) + report.place_charts(charts)
    if reports:
        # The ledger is that of all bodies together; the first body's beats divide it.
        content += page.make_element("h3", f"Per tail beat of {reports[0]['body']}")
        content += tables.make_beat_ledger(reports[0])
    return content


def make_swim_section(reports):
    if not any(report["beats"] for report in reports):
        return page.make_note("No whole tail beat: there is no swim.json with beats. It is written "
                              "from the first whole beat of a body that swims on.")
    content = page.Html()
    for report in reports:
        if not report["beats"]:
            continue
        n, mass = report["steady beats"], report["constants"]["mass"]
        state = (f"steady over the last {n} of {len(report['beats'])} tail beats (drift of the speed "
                 "below 2 % a beat)" if n else
                 f"{len(report['beats'])} tail beats, the speed is not steady at the end")
        content += (page.make_element("h3", f"{report['body']}: {state}")
                    + tables.make_swim_tiles(report)
                    + page.make_note(f"Length {report['constants']['length']['value']:g} m, mass "
                                     + page.format_number(mass["value"]) + f" {mass['unit']}. "
                                     "Key figures: " + ("mean of the steady beats." if n else
                                                        "the last beat."))
                    + tables.make_beat_table(report)
                    + page.make_details("All quantities and their definitions",
                                        tables.make_swim_table(report), is_open=False))
    return content


def describe(folder, n_frames, with_pictures, lone=None):
    """The page of a run; MissingData if what it can't do without is not there."""
    entries, log, run = read_parameters(folder), files.Log(folder), Run(folder)
    reports = list(run.swims.values())
    end = run.time[-1]
    names = ", ".join(run.bodies)
    plane = dict((entry, value) for section, entry, value, _ in entries if not section
                 ).get("Dimension", "2") == "2"
    report = page.Page(f"Caudal: {names}",
                       f"Immersed elastic swimmer, {folder.resolve().name}: t = 0 to {end:g} s, "
                       f"{common.make_state(log)}."
                       + (" " + page.make_element("b", SPAN) if plane else ""))
    report.add("Swimming", make_swim_section(reports))
    if lone:
        report.add("Gain of the school", school.make_school_section(entries, reports, lone))
    if n_frames > 0:
        make = movie.make_vortex_movie if run.is_spatial else movie.make_wake_movie
        report.add("The wake", common.place_movie(report, lambda: make(run, n_frames)))
    hint = page.make_note("Drag over a span of time to zoom (all charts), double click for the whole "
                          "run, hover to read values, click a name to hide its curve.")
    report.add("Motion and forces", hint + report.place_charts(
        make_motion_charts(run) + make_momentum_chart(run, reports) + make_force_charts(run)))
    report.add("Energy ledger", make_ledger_section(run, report, reports))
    report.add("Quality", report.place_charts(make_quality_charts(run)))
    if with_pictures:
        report.add("Pictures", page.join(
            common.draw_picture(report, lambda draw=draw: draw(run),
                                caption[0].upper() + caption[1:])
            for name, caption, draw in get_figures(run) if name not in AS_CHARTS))
    viscosity = float(run.parameters["Fluid/Kinematic viscosity"])
    report.add("Next", common.make_next_steps(
        folder, log, f"Fluid/Kinematic viscosity={viscosity:g},{2 * viscosity:g}"))
    report.add("Warnings", common.make_warnings(log))
    report.add("Time spent", common.make_timings(log))
    report.add("Program, grid and body", common.make_program(log))
    report.add("Parameters", common.make_parameters(entries, folder))
    return report
