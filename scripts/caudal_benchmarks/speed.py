# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/benchmark speed: what a step costs, and where the time goes.

CPU seconds are those of the program's processes (user and system), read while the run goes on,
so that the start, which costs no more for a longer run, can be left out."""

import argparse
import datetime
import math
import pathlib
import platform
import re
import subprocess
import tempfile

from . import hardware, studies, timed_run
from .timed_run import Case

SERIES = (("40, 6", 6), ("180, 27", 4), ("280, 42", 4), ("400, 60", 4), ("560, 84", 4), ("840, 126", 4))
SERIES_STEPS = 6

FSI3 = Case("fsi3", "prm/benchmarks/fsi3.prm")
FSI3_FAST = Case("fsi3_fast", "prm/benchmarks/fsi3_fast.prm")
# The cheapest within 3, 1.5 and 2 % in uy, frequency and mean drag: a run of fsi3_kernels.
FSI3_COARSE = Case("fsi3_coarse", "prm/benchmarks/fsi3.prm",
                   studies.KERNEL_VARIANTS[studies.KERNELS.index("hat")])
FISH = Case("fish", "prm/fish.prm")
EEL = Case("eel", "prm/eel.prm")
FISH_PAPER = Case("fish_paper", "prm/fish_paper.prm")
SMALL = "prm/benchmarks/ring.prm"

# CPU seconds for a simulated second of FSI3 in its oscillating state on this kind of machine.
PEERS = (("turtleFSI, body-fitted, monolithic, as shipped, 1e-3 s", 2640),
         ("turtleFSI, tuned, 5e-3 s", 315),
         ("deal.II, body-fitted, monolithic, 14,740 unknowns, 1e-3 s", 1400),
         ("IBAMR, h = 6.4 mm, 1.9e-4 s", 267),
         ("IBAMR, h = 3.2 mm, 1.2e-4 s", 1130))


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/benchmark speed",
        description="Prints what a step costs: for FSI3 in its oscillating state, the fish and the "
        "eel in their developed wakes, fish on grids from 2,000 to 100,000 cells, and the fish at "
        "the paper's resolution on one and two ranks; and writes the tables to speed.md in the "
        "folder. About 8 minutes on two idle cores of an AMD EPYC.")
    parser.add_argument("--quick", action="store_true",
                        help="the first steps only, from rest: a few minutes")
    parser.add_argument("--peer", action="store_true",
                        help="also what other programs need for FSI3, as measured elsewhere")
    parser.add_argument("--folder", type=pathlib.Path,
                        default=timed_run.RESULTS / "benchmarks" / "speed",
                        help="where the tables go")
    return parser.parse_args(arguments)


class Report:
    """Lines that go to the screen at once and to a file in the end."""

    def __init__(self):
        self.lines = []

    def add(self, *lines):
        for line in lines:
            print(line, flush=True)
            self.lines.append(line)

    def add_table(self, header, rows):
        self.add("", "| " + " | ".join(header) + " |", "|" + "---|" * len(header))
        for row in rows:
            self.add("| " + " | ".join(row) + " |")


def describe_machine(program_banner):
    return [f"{datetime.date.today().isoformat()}, {hardware.get_processor()}, "
            f"{platform.system()}; {program_banner}.",
            f"Memory bandwidth of one core, z = x + y of long vectors: "
            f"{hardware.measure_bandwidth() / 1e9:.1f} GB/s."]


def measure_cases(report, quick, folder):
    """FSI3, the fish and the eel, from rest or in the last part of their run."""
    plans = ((FSI3, 0.1, 0.05) if quick else (FSI3, 2.6, 0.5),
             (FSI3_FAST, 0.1, 0.05) if quick else (FSI3_FAST, 2.6, 0.5),
             (FSI3_COARSE, 0.1, 0.05) if quick else (FSI3_COARSE, 2.6, 0.5),
             (FISH, 0.1, 0.05) if quick else (FISH, 1.6, 0.6),
             (EEL, 0.1, 0.05) if quick else (EEL, 4., 1.))
    rows, shares = [], {}
    for case, end, window in plans:
        result = timed_run.run(case, folder / case.name, end_time=end)
        cpu, simulated, steps = result.get_last(window)
        rows.append((case.name, f"{end - simulated:.2f} to {end:.2f}", str(result.cells),
                     str(result.unknowns), f"{steps / cpu:.2f}", f"{cpu / simulated:.0f}",
                     f"{result.iterations_per_step:.1f}", f"{result.memory:.0f}"))
        shares[case.name] = result.shares
    report.add_table(("case", "time [s]", "cells", "unknowns of the fluid at the start",
                      "steps per CPU s", "CPU s per simulated s", "iterations per step",
                      "memory [MiB]"), rows)
    sections = sorted({name for share in shares.values() for name in share})
    report.add_table(("share of the run",) + tuple(shares),
                     [(name,) + tuple(f"{share.get(name, 0):.1f} %" for share in shares.values())
                      for name in sections])


def measure_series(report, quick, folder):
    """The fish on finer and finer grids: how the cost of a step grows."""
    rows, points, bandwidth = [], [], hardware.measure_bandwidth()
    for cells, levels in SERIES[:3] if quick else SERIES:
        case = Case(f"series_{cells.split(',')[0]}", "prm/fish.prm",
                    (f"Domain/Cells={cells}", f"Domain/Levels={levels}",
                     "Refinement/Vorticity levels=0",
                     "Refinement/Largest number of cells=150000",
                     "Solver/Reuse factorisation=never"))
        result = timed_run.run(case, folder / case.name, steps=SERIES_STEPS)
        cpu, _, steps = result.get_last_steps(SERIES_STEPS - 1)
        points.append((result.cells, cpu / steps))
        solve = result.seconds["iterations"] / result.iterations
        limit = 8 * result.factor_entries / bandwidth
        rows.append((str(result.cells), str(result.unknowns), f"{cpu / steps:.2g}",
                     f"{result.iterations_per_step:.1f}",
                     f"{result.seconds['factorisation'] / result.factorisations:.2g}",
                     f"{solve:.2g}" if solve > 0 else "-", f"{limit:.2g}", f"{result.memory:.0f}",
                     f"{cpu / steps / result.cells * 1e6:.0f}"))
    report.add_table(("cells", "unknowns", "CPU s per step", "iterations per step",
                      "s per factorisation", "s per iteration", "its limit by memory bandwidth",
                      "memory [MiB]", "CPU us per cell and step"), rows)
    (n_0, t_0), (n_1, t_1) = points[1], points[-1]
    report.add("", f"From {n_0} to {n_1} cells the cost of a step grows as N^"
               f"{math.log(t_1 / t_0) / math.log(n_1 / n_0):.2f}. The limit is the time in which "
               "the factors are read once.")


def measure_ranks(report, quick, folder):
    steps = 4 if quick else 20
    seconds = []
    for ranks in (1, 2):
        result = timed_run.run(FISH_PAPER, folder / f"ranks_{ranks}", steps=steps, ranks=ranks)
        seconds.append(result.get_last_wall(steps - 1))
    report.add("", f"fish_paper.prm, {steps - 1} steps on {result.cells} cells: "
               f"{seconds[0]:.1f} s on one rank, {seconds[1]:.1f} s on two, "
               f"{seconds[0] / seconds[1]:.2f} times faster.")


def count_instructions(report, folder):
    """Instructions of one step of the ring: the same whatever else the machine does."""
    counts = []
    for steps in (2, 3):
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={scratch}/out",
                       str(timed_run.PROGRAM), SMALL, "-D", f"Output/Folder={scratch}/run",
                       "-D", f"Time/End time={steps * 0.01}", "-D", "Time/Step=0.01"]
            try:
                result = subprocess.run(command, cwd=timed_run.ROOT, capture_output=True,
                                        text=True, check=False, env=timed_run.ENVIRONMENT)
            except FileNotFoundError:
                report.add("", "Instructions of a step: not counted, valgrind is not installed.")
                return
        match = re.search(r"Collected : (\d+)", result.stderr)
        if result.returncode != 0 or not match:
            report.add("", "Instructions of a step: not counted, valgrind failed: "
                       + (result.stderr.strip().splitlines() or ["no message"])[-1])
            return
        counts.append(int(match.group(1)))
    report.add("", f"Instructions of one step of {SMALL}: {(counts[1] - counts[0]) / 1e6:.1f} "
               "million (callgrind).")


def main(arguments):
    options = parse(arguments)
    options.folder.mkdir(parents=True, exist_ok=True)
    report = Report()
    report.add(*describe_machine(timed_run.get_banner()))
    measure_cases(report, options.quick, options.folder)
    if options.peer:
        report.add_table(("FSI3 with other programs", "CPU s per simulated s"),
                         [(name, str(seconds)) for name, seconds in PEERS])
    measure_series(report, options.quick, options.folder)
    measure_ranks(report, options.quick, options.folder)
    count_instructions(report, options.folder)
    (options.folder / "speed.md").write_text("\n".join(report.lines) + "\n", encoding="utf-8")
    print(f"\nWritten to {options.folder / 'speed.md'}.")
    return 0
