# SPDX-License-Identifier: LGPL-2.1-or-later
"""How FSI3 depends on grid, step and kernel."""

from caudal_plots import style

from .figures import MILLIMETRE, Figure, Signal, check_body

# FSI3 of Turek et al. (2010): column, figure, reference.
QUANTITIES = (("uy amplitude [mm]", "flag: y of point 1", "amplitude", 34.99),
              ("ux amplitude [mm]", "flag: x of point 1", "amplitude", 2.72),
              ("frequency [Hz]", "flag: y of point 1", "frequency", 5.46),
              ("mean drag [N/m]", "flag: force x of the fluid", "mean", 460.5),
              ("lift amplitude [N/m]", "flag: force y of the fluid", "amplitude", 153.91))

GRIDS = {2: ("Domain/Cells=31,5", "Body flag/Shape/Elements=35,2",
             "Refinement/Largest number of cells=1000"),
         4: (),
         8: ("Domain/Cells=122,20", "Body flag/Shape/Elements=140,8",
             "Refinement/Largest number of cells=16000")}
# The oscillation is periodic from about 3 s on.
END = "Time/End time=4.2"
KERNELS = ("dirac", "four-point", "three-point", "cosine", "hat", "B-spline 3", "B-spline 4",
           "B-spline 5", "B-spline 6", "composite B-spline 32", "composite B-spline 43",
           "composite B-spline 54")

# Each grid with 4 ms, and other steps on the cheaper ones: all nine would take five hours.
GRID_AND_STEP = ((2, 8e-3), (2, 4e-3), (2, 2e-3), (4, 8e-3), (4, 4e-3), (8, 4e-3))
GRID_AND_STEP_VARIANTS = tuple(GRIDS[cells] + (END, f"Time/Step={step}")
                               for cells, step in GRID_AND_STEP)
# On the coarse grid, where they differ most.
KERNEL_VARIANTS = tuple(GRIDS[2] + (END, "Time/Step=5e-3", f"Coupling/Kernel={kernel}") for kernel in KERNELS)


def measure(run, label):
    figures = []
    for name, column, part, reference in QUANTITIES:
        factor, offset = (MILLIMETRE, run.get(column)[0]) if "point" in column else (1., 0.)
        signal = Signal(run, column, factor, offset=offset)
        figures.append(Figure(f"{name}, {label}", getattr(signal.end, part), reference,
                              note=f"{name}, {label}: {signal.end.state}"))
    return figures


def evaluate_grid_and_step(runs):
    return [figure for run, (cells, step) in zip(runs, GRID_AND_STEP)
            for figure in measure(run, f"{cells} cells, {step:g} s")]


def evaluate_kernels(runs):
    figures = []
    for run, kernel in zip(runs, KERNELS):
        figures += measure(run, kernel) + check_body(run, label=f", {kernel}")
    return figures


def plot_grid_and_step(path, figures):
    """Errors over the step, a line for each grid."""
    style.apply()
    picture, axes = style.make_figure(1, len(QUANTITIES), 2.6)
    known = {figure.name: 100 * figure.error for figure in figures}
    for axis, (name, _, _, _) in zip(axes[0], QUANTITIES):
        for cells in GRIDS:
            steps = [step for n, step in GRID_AND_STEP if n == cells]
            axis.plot([1e3 * step for step in steps],
                      [known[f"{name}, {cells} cells, {step:g} s"] for step in steps], "o-",
                      label=f"{cells} cells thick")
        axis.axhline(0, color="0.4", linestyle="--", linewidth=0.8)
        axis.set_title(name)
        axis.set_xlabel("step [ms]")
    axes[0, 0].set_ylabel("error [%]")
    axes[0, 0].legend(loc="lower left")
    picture.savefig(path)
    style.close(picture)
