# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/benchmark space: what a step costs in three dimensions, by the iterative method.

A step is the mean of the third and fourth one: the first two also make the multigrid of the pressure,
which is then kept until the grid changes. A body at rest keeps its factors as well. The flow passes about
one spacing of the nodes in a step."""

import argparse
import pathlib

from . import hardware, report, timed_run
from .figures import Figure
from .timed_run import Case

PRM = "prm/benchmarks/ellipsoid_wake.prm"
STEPS, COUNTED = 4, 2


def make_small(levels):
    """The ellipsoid of ellipsoid.prm with its wake: 2,144 cells on four levels."""
    region = f"if(x>0.3,if(x<1.6,if(abs(y-0.5)<0.2,if(abs(z-0.5)<0.2,{levels - 1},0),0),0),0)"
    return (f"Domain/Levels={levels}", f"Refinement/Level expression={region}",
            "Body body/Shape/Length=0.8", "Body body/Shape/Thickness=0.3", "Body body/Shape/Width=0.2")


HELD = ("Body body/Region body/Material=none", "Body body/Region body/Motion=fixed",
        "Body body/Region body/Feedback damping=1e9")
STIFF = ("Body body/Region body/Young's modulus=1e5",)
MEBIBYTES = 1024.  # of a GiB

# Name, overrides, step [s], ranks and the upper limits of what is measured.
PLAN = (("small", make_small(4), 0.025, 1, {"cpu": 3, "memory": 0.6}),
        ("small_stiff", make_small(4) + STIFF, 0.025, 1, {}),
        ("small_held", make_small(4) + HELD, 0.025, 1, {}),
        ("half", make_small(5), 0.0125, 1, {}),
        ("elastic", (), 0.00625, 1, {}),
        ("elastic", (), 0.00625, 2, {"wall": 45, "memory": 6}),
        ("held", HELD, 0.00625, 1, {}),
        ("held", HELD, 0.00625, 2, {"wall": 20, "memory": 6}))


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/benchmark space",
        description="Prints what a step of an ellipsoid costs, elastic and held, on 2,144 cells and "
        "on 50,920 with one and two ranks, beside the gates. Wall times are for idle cores. 8 "
        "minutes on two of an AMD EPYC.")
    parser.add_argument("--small", action="store_true", help="the first three, small ones only: half a minute")
    parser.add_argument("--folder", type=pathlib.Path,
                        default=timed_run.RESULTS / "benchmarks" / "space",
                        help="where the runs go")
    return parser.parse_args(arguments)


def measure(name, overrides, folder, step, ranks, gates):
    """Figures of a run: seconds of a step, memory, iterations."""
    run = timed_run.run(Case(name, PRM, (*overrides, f"Time/Step={step}")),
                        folder / f"{name}_{ranks}", end_time=STEPS * step, ranks=ranks)
    cpu, _, steps = run.get_last_steps(COUNTED)
    wall = run.get_last_wall(COUNTED) / steps
    limits = {quantity: (0, limit) for quantity, limit in gates.items()}
    note = f"{run.cells:,} cells, {ranks} rank{'s' if ranks > 1 else ''}"
    return [Figure("CPU time of a step [s]", cpu / steps, gate=limits.get("cpu"), note=note),
            Figure("wall time of a step [s]", wall, gate=limits.get("wall")),
            Figure("memory [GiB]", run.memory / MEBIBYTES, gate=limits.get("memory")),
            Figure("largest number of iterations", run.largest_iterations, gate=(0, 60))]


def compare(name, figure, other, gate):
    return Figure(name, figure.value / other.value, gate=gate)


def main(arguments):
    options = parse(arguments)
    options.folder.mkdir(parents=True, exist_ok=True)
    print(f"{hardware.get_processor()}; {timed_run.get_banner()}")
    print(report.format_row(report.HEADER))
    tables = {}
    for name, overrides, step, ranks, gates in PLAN[:3] if options.small else PLAN:
        figures = measure(name, overrides, options.folder, step, ranks, gates)
        if name == "half":
            figures.append(compare("iterations over those with twice h and dt", figures[-1],
                                   tables["small, 1"][-1], (0, 1.3)))
        if ranks == 2:  # the gate is for steps without the bodies' factors, which rank 0 makes
            figures.append(compare("one rank over two", tables[f"{name}, 1"][1], figures[1],
                                   (1.7, 2.2) if name == "held" else None))
        tables[f"{name}, {ranks}"] = figures
        for figure in figures:
            print(report.format_row(report.make_row(f"{name}, {ranks}", figure)), flush=True)
    report.write_markdown(options.folder / "table.md", tables)
    missed = [name for name, figures in tables.items() if not all(f.is_ok for f in figures)]
    print("Gates missed: " + ", ".join(missed) if missed else "All gates met.")
    return 1 if missed else 0
