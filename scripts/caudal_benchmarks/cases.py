# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmarks: how each is run, its figures and gates. References: Schaefer and Turek 1996
(doi:10.1007/978-3-322-89849-4_39), Turek and Hron 2006 (doi:10.1007/3-540-34596-5_15), Turek et
al. 2010 (doi:10.1007/978-3-642-14206-2_15), and what the opening comments of the .prm name."""

import dataclasses
import json
import math
import typing

import numpy as np

from . import loads, studies, surface, three_d
from .figures import (MILLIMETRE, Figure, Signal, check_body, check_ledger,
                      compare_force_accounts, describe)


@dataclasses.dataclass
class Case:
    """A benchmark of one run, or of several that differ in overrides."""

    name: str
    purpose: str
    cost: str
    evaluate: typing.Callable  # from a list of runs to a list of figures
    variants: tuple = ((),)    # the overrides of each run
    curves: tuple = ()         # columns to plot
    from_start: bool = False   # whether they show the start, which may dwarf what comes later
    file: str = ""             # prm/benchmarks/<file>.prm, by default <name>.prm
    plot: typing.Callable = None  # of the figures, to a file

    @property
    def prm(self):
        return f"prm/benchmarks/{self.file or self.name}.prm"


DRAG, LIFT = "flag: force x of the fluid", "flag: force y of the fluid"
TIP = ("flag: x of point 1", "flag: y of point 1")
TIP_AT_START = (0.6, 0.2)
AREA_GATE = (0, 5e-4)


def evaluate_orders(runs):
    """Observed L2 orders from pairs of runs, the second with half the spacing."""
    figures = []
    for kind, (coarse, fine) in zip(("uniform", "hanging nodes"), (runs[:2], runs[2:])):
        for quantity, least in (("velocity", 2.9), ("pressure", 1.9)):
            ratio = coarse.get(f"{quantity} error")[-1] / fine.get(f"{quantity} error")[-1]
            figures.append(Figure(f"{quantity} order, {kind}", math.log2(ratio),
                                  gate=(least, math.inf)))
    return figures


def evaluate_time_order(runs):
    errors = [run.get("velocity error")[-1] for run in runs]
    return [Figure("velocity order in time", math.log2(errors[0] / errors[1]),
                   gate=(1.9, math.inf))]


def spatial_variants(n):
    return tuple((f"Domain/Cells={m},{m}", f"Refinement/Level expression={level}")
                 for level in ("0", "if(x>0.3,1,0)") for m in (n, 2 * n))


def evaluate_ring(runs):
    """What moves is an error; its L2 norm is the root of the kinetic energy."""
    coarse, run = runs
    ratio = coarse.get("kinetic energy")[-1] / run.get("kinetic energy")[-1]
    return [Figure("p inside [Pa]", run.get("p at probe 1")[-1], 0.167920, 0.005),
            Figure("p outside [Pa]", run.get("p at probe 2")[-1], -0.055223, 0.005),
            Figure("velocity order", math.log2(ratio) / 2, gate=(1.5, math.inf)),
            Figure("max velocity [m/s]", run.get("max velocity")[-1])]


def evaluate_dfg_steady(runs):
    run, factor = runs[0], 500.
    drag = Signal(run, "cylinder: force x of the fluid", factor)
    lift = Signal(run, "cylinder: force y of the fluid", factor, scale=0.1)
    pressure = run.get("p at probe 1")[-1] - run.get("p at probe 2")[-1]
    return [Figure("cD", drag.end.mean, 5.57953523384, 0.015, drag.end.state),
            Figure("cL", lift.end.mean, 0.010618948146, (0.97 * 0.0104, 1.03 * 0.0110),
                   lift.end.state),
            Figure("dp [Pa]", pressure, 0.11752016697, 0.015)
            ] + compare_force_accounts(run, "cylinder", "x")


def evaluate_dfg_periodic(runs):
    run, factor = runs[0], 20.
    drag = Signal(run, "cylinder: force x of the fluid", factor)
    lift = Signal(run, "cylinder: force y of the fluid", factor)
    return [Figure("max cD", drag.end.maximum, 3.23, 0.015, drag.end.state),
            Figure("max cL", lift.end.maximum, 1.0, (0.97 * 0.99, 1.03 * 1.01), lift.end.state),
            Figure("St", 0.1 * lift.end.frequency, 0.3, (0.97 * 0.295, 1.03 * 0.305))
            ] + compare_force_accounts(run, "cylinder", "x")


def evaluate_free_cylinder(drag, lift=None, strouhal=None):
    """Intervals of the published coefficients."""
    def evaluate(runs):
        run = runs[0]
        force = Signal(run, "cylinder: force x of the fluid", 2.)
        cross = Signal(run, "cylinder: force y of the fluid", 2., scale=1.)
        figures = [Figure("Cd", force.end.mean, sum(drag) / 2, drag, force.end.state)]
        if lift:
            figures += [Figure("Cl amplitude", cross.end.amplitude, sum(lift) / 2, lift,
                               cross.end.state),
                        Figure("St", cross.end.frequency, sum(strouhal) / 2, strouhal)]
        else:
            figures.append(Figure("recirculation length", find_stagnation(run) - 10.5, 2.24,
                                  (2.13, 2.35)))
        return figures + compare_force_accounts(run, "cylinder", "x")
    return evaluate


def find_stagnation(run):
    """Where on the axis, between the probes at x = 12.4, 12.5, ... the velocity changes sign."""
    places = [12.4 + 0.1 * k for k in range(7)]
    speeds = [run.get(f"u at probe {k + 1}")[-1] for k in range(7)]
    for x, a, b in zip(places, speeds, speeds[1:]):
        if a < 0 <= b:
            return x + 0.1 * a / (a - b)
    return math.nan


def evaluate_flap(runs):
    """The mean time from one maximum of the tip's deflection to the next, by parabolas."""
    run = runs[0]
    t, x = run.time, run.get("flap: x of point 1")
    maxima = [t[i] + 0.5 * (t[i + 1] - t[i]) * (x[i - 1] - x[i + 1]) / (x[i - 1] - 2 * x[i] + x[i + 1])
              for i in range(1, len(x) - 1) if x[i - 1] < x[i] >= x[i + 1]]
    period = (maxima[-1] - maxima[0]) / (len(maxima) - 1)
    return [Figure("period [s]", period, 1.625, 0.02),
            Figure("largest deflection [m]", x.max())]


def evaluate_soft_disc(runs):
    """The extremes of the centroid's path, Sugiyama et al. 2011."""
    run = runs[0]
    x, y = run.get("disc: x of centre of mass"), run.get("disc: y of centre of mass")
    wanted = (("smallest x", x.min(), .2894), ("largest x", x[run.time > 2].max(), .7021),
              ("smallest y", y.min(), .4936), ("largest y", y.max(), .8684))
    return [Figure(name, value, reference, (reference - 0.01, reference + 0.01))
            for name, value, reference in wanted] + [
        Figure("largest |area change|", abs(run.get("disc: area change")).max(), gate=(0, 1e-3)),
        Figure("min J", run.get("disc: min J").min()),
        Figure("max J", run.get("disc: max J").max())]


def evaluate_rigid_flag(drag, lift, gates, amplitude=None, frequency=None):
    """CFD1 to CFD3; gates of drag, lift and frequency."""
    def evaluate(runs):
        run = runs[0]
        figures = describe(Signal(run, DRAG), "drag [N/m]", mean=(drag, gates[0]),
                           amplitude=amplitude and (amplitude[0], None))
        figures += describe(Signal(run, LIFT, scale=abs(drag)), "lift [N/m]",
                            mean=(lift, None if amplitude else gates[1]),
                            amplitude=amplitude and (amplitude[1], gates[1]),
                            frequency=frequency and (frequency, gates[2]))
        return figures + compare_force_accounts(run, "flag", "x")
    return evaluate


def evaluate_csm(ux, uy):
    """Static: values in mm."""
    def evaluate(runs):
        end = [MILLIMETRE * (runs[0].get(column)[-1] - start)
               for column, start in zip(TIP, TIP_AT_START)]
        return [Figure("ux [mm]", end[0], ux, 0.005), Figure("uy [mm]", end[1], uy, 0.005)]
    return evaluate


def evaluate_csm3(runs):
    """Over the last two periods: higher modes take up energy, by which ux loses 2 % in 10 s."""
    ux, uy = get_tip(runs[0], n_periods=2)
    return (describe(ux, "ux [mm]", (-14.305, 0.005), (14.305, 0.005), (1.0995, 0.005))
            + describe(uy, "uy [mm]", (-63.607, 0.005), (65.160, 0.005), (1.0995, 0.005)))


def get_tip(run, scale=1., **options):
    """Displacement of point A in mm; changes that are small beside `scale` don't count."""
    return [Signal(run, column, MILLIMETRE, scale, start, **options)
            for column, start in zip(TIP, TIP_AT_START)]


def evaluate_fsi1(runs):
    run = runs[0]
    ux, uy = get_tip(run, scale=0.1)
    return (describe(ux, "ux [mm]", mean=(0.0227, 0.03))
            + describe(uy, "uy [mm]", mean=(0.8209, 0.03))
            + describe(Signal(run, DRAG), "drag [N/m]", mean=(14.295, 0.01))
            + describe(Signal(run, LIFT, scale=10.), "lift [N/m]", mean=(0.7638, 0.01))
            + compare_force_accounts(run, "flag", "x"))


def evaluate_fsi2(runs):
    run = runs[0]
    ux, uy = get_tip(run)
    return (describe(uy, "uy [mm]", (1.30, None), (81.6, 0.05), (1.93, 0.02))
            + describe(ux, "ux [mm]", (-14.85, None), (12.70, None), (3.86, None))
            + describe(Signal(run, DRAG), "drag [N/m]", (215.1, 0.03), (77.7, None))
            + describe(Signal(run, LIFT), "lift [N/m]", (0.6, None), (237.8, None))
            + check_body(run, AREA_GATE) + [check_ledger(run, 1 / uy.end.frequency)]
            + compare_force_accounts(run, "flag", "x"))


def evaluate_fsi3(runs):
    run = runs[0]
    ux, uy = get_tip(run)
    return (describe(uy, "uy [mm]", (1.47, None), (34.99, 0.03), (5.46, 0.015))
            + describe(ux, "ux [mm]", (-2.88, None), (2.72, 0.06), (10.93, None))
            + describe(Signal(run, DRAG), "drag [N/m]", (460.5, 0.02), (27.74, 0.15))
            + describe(Signal(run, LIFT), "lift [N/m]", (2.50, None), (153.91, 0.08))
            + check_body(run, AREA_GATE) + [check_ledger(run, 1 / uy.end.frequency)]
            + compare_force_accounts(run, "flag", "x"))


def evaluate_fsi3_paper(runs):
    """No reference but that of FSI3, whose channel is wider by 2.5 %: no gates."""
    figures = evaluate_fsi3(runs)
    for figure in figures:
        if figure.reference is not None and not figure.name.startswith("mean force"):
            figure.gate = None
    return figures


def evaluate_cook(runs):
    run = runs[0]
    rise = run.get("panel: y of point 1")
    late = rise[run.time > 0.8 * run.time[-1]]
    return [Figure("rise of the corner [cm]", rise[-1] - 8., 0.66, (0.63, 0.69),
                   f"changes by {np.ptp(late):.1e} cm in the last {0.2 * run.time[-1]:.3g} s"),
            Figure("min J", run.get("panel: min J").min(), gate=(0.97, math.inf)),
            Figure("max J", run.get("panel: max J").max(), gate=(0., 1.03))]


def evaluate_eel(runs):
    """On three grids, each twice as fine as the one before; the index of P. J. Roache (1994,
    doi:10.1115/1.2910291) with his factor of safety 1.25."""
    figures = []
    for quantity, label in (("speed in lengths", "speed [L/T]"),
                            ("Strouhal number", "Strouhal number")):
        beats = [json.loads((run.folder / "swim.json").read_text(encoding="utf-8"))["beats"][-1]
                 for run in runs]
        values = [beat[quantity] for beat in beats]
        for spacing, value, beat in zip(("L/64", "L/128", "L/256"), values, beats):
            figures.append(Figure(f"{label}, {spacing}", value,
                                  note=f"last beat, begins at {beat['start']:.3g} T, change of "
                                       f"speed {beat['change']:.2g} %"))
        coarse, middle, fine = values
        ratio = (coarse - middle) / (middle - fine)
        if ratio > 1:
            figures += [Figure(f"{label}, observed order", math.log2(ratio)),
                        Figure(f"{label}, convergence index [%]",
                               125 * abs((fine - middle) / fine) / (ratio - 1))]
        else:
            figures.append(Figure(f"{label}, observed order", None,
                                  note="the grids do not converge monotonically"))
    return figures


FORCES = (DRAG, "force x by control volume", LIFT)
CASES = {case.name: case for case in (
    Case("taylor_green", "orders in space, decaying vortices", "5 s", evaluate_orders,
         spatial_variants(6)),
    Case("kovasznay", "orders in space, flow behind a row of obstacles", "5 s", evaluate_orders,
         spatial_variants(6)),
    Case("moving_vortices", "order in time (BDF2)", "3 s", evaluate_time_order,
         (("Time/Step=0.04",), ("Time/Step=0.02",))),
    Case("ethier_steinman", "orders in 3D, an exact flow", "30 s",
         three_d.evaluate_ethier_steinman, three_d.ETHIER_STEINMAN_VARIANTS),
    Case("ring", "balance of fibre tension and pressure", "1 s", evaluate_ring,
         (("Domain/Levels=3", "Refinement/Level expression=2", "Body ring/Shape/Elements=48,2"),
          ())),
    Case("cylinder_re40", "cylinder in a free stream, Reynolds number 40", "1.5 min",
         evaluate_free_cylinder((1.54, 1.565)),
         curves=("cylinder: force x of the fluid", "force x by control volume")),
    Case("cylinder_re100", "cylinder in a free stream, Reynolds number 100", "5 min",
         evaluate_free_cylinder((1.33, 1.364), (0.34, 0.35), (0.98 * 0.165, 1.02 * 0.165)),
         curves=("cylinder: force x of the fluid", "cylinder: force y of the fluid")),
    Case("soft_disc", "soft disc in a lid-driven cavity", "2 min", evaluate_soft_disc,
         curves=("disc: x of centre of mass", "disc: y of centre of mass")),
    Case("dfg_2d1", "flow past a cylinder, Reynolds number 20", "1.5 min", evaluate_dfg_steady,
         curves=("cylinder: force x of the fluid", "force x by control volume")),
    Case("dfg_2d2", "flow past a cylinder, Reynolds number 100", "10 min", evaluate_dfg_periodic,
         curves=("cylinder: force x of the fluid", "cylinder: force y of the fluid")),
    Case("cfd1", "rigid flag, Reynolds number 20", "20 s",
         evaluate_rigid_flag(14.29, 1.119, (0.015, 0.03)), curves=FORCES),
    Case("cfd2", "rigid flag, Reynolds number 100", "40 s",
         evaluate_rigid_flag(136.7, 10.53, (0.015, 0.03)), curves=FORCES),
    Case("cfd3", "rigid flag, Reynolds number 200", "60 min",
         evaluate_rigid_flag(439.45, -11.893, (0.015, 0.03, 0.01), (5.6183, 437.81), 4.3956),
         curves=FORCES),
    Case("csm1", "the flag without fluid, static", "3 s", evaluate_csm(-7.187, -66.10)),
    Case("csm2", "the same, four times as stiff", "3 s", evaluate_csm(-0.4690, -16.97)),
    Case("csm3", "the flag without fluid, swinging", "3 min", evaluate_csm3, curves=TIP),
    Case("fsi1", "elastic flag, steady", "30 s", evaluate_fsi1, curves=TIP + FORCES),
    Case("fsi2", "elastic flag ten times as dense as the fluid", "8 min", evaluate_fsi2,
         curves=TIP + FORCES),
    Case("fsi3", "elastic flag, the paper's benchmark", "5 min", evaluate_fsi3,
         curves=TIP + FORCES),
    Case("fsi3_fast", "the same, the cheapest that meets the gates", "1.5 min", evaluate_fsi3,
         curves=TIP + FORCES),
    Case("fsi3_paper", "the same in the paper's channel", "6 min", evaluate_fsi3_paper,
         curves=TIP + FORCES),
    Case("fsi3_study", "FSI3 on three grids and with three steps", "90 min",
         studies.evaluate_grid_and_step, studies.GRID_AND_STEP_VARIANTS, file="fsi3",
         plot=studies.plot_grid_and_step),
    Case("fsi3_kernels", "FSI3 on a coarse grid with each kernel", "60 min",
         studies.evaluate_kernels, studies.KERNEL_VARIANTS, file="fsi3"),
    Case("flap", "flap on the floor, of a compressible material", "1 min", evaluate_flap,
         curves=("flap: x of point 1",)),
    Case("cook", "Cook's membrane in a box of fluid", "3.5 min", evaluate_cook,
         curves=("panel: y of point 1", "panel: min J", "panel: max J")),
    Case("eel", "self-propelled eel on three grids", "8 min", evaluate_eel,
         tuple((f"Domain/Cells={16 * n},{8 * n}",
                f"Refinement/Largest number of cells={1250 * n * n}") for n in (1, 2, 4)),
         curves=("eel: u of centre of mass",)),
    Case("eel_ibamr", "IBAMR's eel on three grids", "10 min", surface.evaluate_eel_ibamr,
         surface.EEL_VARIANTS, curves=("eel: u of centre of mass",)),
    Case("falling_disc", "gravity: drag and weight less buoyancy", "30 s",
         loads.evaluate_falling_disc, curves=("disc: v of centre of mass",)),
    Case("oscillating_cylinder", "prescribed motion, in fluid at rest and in the cylinder's frame",
         "1.5 min", loads.evaluate_oscillating_cylinder, ((), loads.STREAM)),
    Case("pulsating_channel", "lift of an unsteady flow with large steps", "1 min",
         loads.evaluate_pulsating_channel, ((), ("Time/Step=0.005",))),
    Case("pulled_rectangle", "rest under a dead load, stretched", "5 s",
         loads.evaluate_pulled_rectangle),
    Case("rest_under_pull", "rest under a dead load, all round", "5 s",
         loads.evaluate_rest_under_pull),
    Case("squeezed_disc", "rest under a dead load, for 100 s", "1 min",
         loads.evaluate_squeezed_disc),
    Case("couette", "circular Couette flow, place of an immersed wall", "1 min",
         surface.evaluate_couette, surface.COUETTE_VARIANTS),
    Case("slanted_channel", "channel between slanted immersed walls", "1 min",
         surface.evaluate_slanted_channel, surface.CHANNEL_VARIANTS),
    Case("sphere_re20", "fixed sphere in a stream, Reynolds number 20", "6 min",
         three_d.evaluate_drag(20, 2.85),
         curves=("sphere: force x of the fluid", "force x by control volume")),
    Case("sphere_re100", "fixed sphere in a stream, Reynolds number 100", "21 min",
         three_d.evaluate_drag(100, 1.085, has_wake=True),
         curves=("sphere: force x of the fluid", "force x by control volume")),
    Case("elastic_plate", "elastic plate on the floor of a channel, steady", "9 min",
         three_d.evaluate_elastic_plate, curves=("plate: force x of the fluid",)),
    Case("ellipsoid_start", "impulsive start of an ellipsoid: added masses", "4 min",
         three_d.evaluate_ellipsoid_start, three_d.ELLIPSOID_VARIANTS),
    Case("oscillating_sphere", "force on an oscillating sphere", "9 min",
         three_d.evaluate_oscillating_sphere, curves=("sphere: force x of the fluid",)),
    Case("settling_sphere_e1", "sinking sphere, Reynolds number 1.5", "16 min",
         three_d.evaluate_settling_sphere(0.038, 0.947, 0.947),
         curves=("sphere: w of centre of mass", "sphere: z of centre of mass"), from_start=True),
    Case("settling_sphere_e4", "sinking sphere, Reynolds number 32", "11 min",
         three_d.evaluate_settling_sphere(0.128, 0.955, 0.96),
         curves=("sphere: w of centre of mass", "sphere: z of centre of mass"), from_start=True),
)}
