# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/benchmark scaling: what a step costs on more and more ranks, and a model for many."""

import argparse
import os
import pathlib
import sys

from . import scaling_model, scaling_run, timed_run
from .runs import RunError
from .scaling_run import Cost
from .scaling_series import SERIES
from .speed import Report, describe_machine

NOT_COUNTED = "-"


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/benchmark scaling",
        description="Prints what a step costs on several numbers of ranks, of one size and of sizes "
        "in proportion, in 2D and 3D: seconds by section, memory, messages, bytes, collective "
        "calls, iterations, and the difference of results from those of one rank; then a model "
        "for 16 to 1,024 ranks. Writes scaling.md to the folder. More ranks than cores give no "
        "times. Runs that were measured are not made again, so that a series can be measured in "
        "parts; remove the folder to measure anew.")
    parser.add_argument("--ranks", default="1,2,4,8", help="numbers of ranks [1,2,4,8]")
    parser.add_argument("--series", default=",".join(SERIES),
                        help=f"which of {', '.join(SERIES)} [all]")
    parser.add_argument("--folder", type=pathlib.Path,
                        default=timed_run.RESULTS / "benchmarks" / "scaling",
                        help="where results and tables go")
    parser.add_argument("--measured", action="store_true",
                        help="no new runs: tables of those that were measured before")
    options = parser.parse_args(arguments)
    try:
        options.ranks = sorted({int(ranks) for ranks in options.ranks.split(",")})
    except ValueError:
        options.ranks = [0]
    if options.ranks[0] < 1:
        parser.error("--ranks: give numbers from 1, such as 1,2,4")
    options.series = options.series.split(",")
    if unknown := [name for name in options.series if name not in SERIES]:
        parser.error(f"--series: there is no {', '.join(unknown)}; there are {', '.join(SERIES)}")
    return options


def count_cores():
    return len(os.sched_getaffinity(0))


def measure_series(series, ranks, folder, counter, only_known=False):
    """The Cost of a step on each number of ranks."""
    costs = {}
    for n in ranks:
        case = series.write_case(folder, n)
        records = [scaling_run.measure(case, series.get_overrides(n, steps),
                                       folder / f"{series.name}_{n}_{steps}", n, counter, only_known)
                   for steps in series.steps]
        if None not in records:
            costs[n] = Cost(*records)
    return costs


def format_number(value, digits=3):
    """Few digits, thousands with commas; a dash for what could not be counted."""
    if value is None:
        return NOT_COUNTED
    if abs(value) >= 100:
        return f"{value:,.0f}"
    return f"{value:.{digits}g}"


def format_range(values, digits=3):
    """Of rank 0 and the largest of the others."""
    if values is None:
        return NOT_COUNTED
    others = f", {format_number(max(values[1:]), digits)}" if len(values) > 1 else ""
    return format_number(values[0], digits) + others


def compare(record, reference):
    """The largest difference of the forces and that of the energy from those of the reference,
    relative to the largest component of each."""
    scales, differences = {}, {}
    for name, value in reference.figures.items():
        scales[get_quantity(name)] = max(abs(value), scales.get(get_quantity(name), 0.))
    for name, value in reference.figures.items():
        quantity = get_quantity(name)
        difference = abs(record.figures[name] - value) / (scales[quantity] or 1.)
        differences[quantity] = max(difference, differences.get(quantity, 0.))
    return list(differences.values())


def get_quantity(column):
    """The column's name without the component of a force."""
    return column.replace("force x", "force").replace("force y", "force").replace("force z", "force")


def make_rows(series, costs, cores):
    """A row for each number of ranks."""
    reference = costs.get(1) if series.grows == "nothing" else None
    for ranks, cost in costs.items():
        is_timed = ranks <= cores
        difference = NOT_COUNTED if reference is None or ranks == 1 else (
            ", ".join(f"{difference:.0e}" for difference in compare(cost.long, reference.long)))
        yield (f"{ranks}" + ("" if is_timed else " *"), f"{cost.long.cells:,}",
               f"{cost.iterations:.1f}", format_number(cost.wall) if is_timed else "*",
               format_range(cost.cpu) if is_timed else "*", format_range(cost.work),
               format_range(cost.long.memory), format_range(cost.messages),
               format_range(None if cost.bytes is None else [n / 1e6 for n in cost.bytes]),
               difference)


HEADER = ("ranks", "cells", "iterations", "wall s", "user CPU s: rank 0, others",
          "of these outside of MPI", "MiB: rank 0, others", "messages sent: rank 0, others",
          "MB sent: rank 0, others", "difference from one rank: force, energy")


def make_section_rows(costs, cores):
    timed = {ranks: cost for ranks, cost in costs.items() if ranks <= cores}
    names = sorted({name for cost in timed.values() for name in cost.sections})
    rows = [(name, *(f"{cost.sections.get(name, 0.):.3f}" for cost in timed.values()))
            for name in names]
    return ("wall s a step, rank 0", *(f"{n} rank{'s' * (n > 1)}" for n in timed)), rows


def make_call_rows(costs):
    """Collective calls a step by kind, and the all-to-all ones, which should be none."""
    counted = {ranks: cost.calls for ranks, cost in costs.items() if ranks > 1 and cost.calls}
    kinds = sorted({kind for calls in counted.values() for kind in calls} | {"Alltoall"})
    rows = [(kind, *(f"{calls.get(kind, 0.):.1f}" for calls in counted.values())) for kind in kinds]
    rows.append(("all", *(f"{sum(calls.values()):.1f}" for calls in counted.values())))
    rows.append(("all, an iteration of the solver",
                 *(f"{sum(calls.values()) / costs[n].iterations:.1f}" for n, calls in counted.items())))
    return ("collective calls a step", *(f"{n} ranks" for n in counted)), rows if counted else []


def report_series(report, series, costs, cores):
    first = next(iter(costs.values()))
    report.add("", f"## {series.title}", "",
               f"`{series.prm}`, {' x '.join(map(str, series.size))} m of "
               f"{' x '.join(map(str, series.cells))} cells"
               f"{'' if series.grows == 'nothing' else ' for each rank'}, "
               f"{series.levels} levels; the difference of runs of {first.long.steps} and "
               f"{first.short.steps} steps, a step.")
    report.add_table(HEADER, list(make_rows(series, costs, cores)))
    for header, rows in (make_section_rows(costs, cores), make_call_rows(costs)):
        if rows:
            report.add_table(header, rows)
    if max(costs) > 1 and any(cost.calls is None for n, cost in costs.items() if n > 1):
        report.add("", "Collective calls could not be counted: there is no mpicc, or not of this MPI.")
    if any(cost.messages is None for cost in costs.values()):
        report.add("", "Messages could not be counted: this MPI has no component pml_monitoring, "
                   "which Open MPI has.")


LEGEND = """
How to read the tables. Ranks with * are more than this machine's {cores} cores: they give no times, but memory, counts and
results. Wall time is that of the program's clock and holds whatever else the machine did; user CPU time does not. A rank that
waits sleeps for 20 us at a time, where mpicc is there, so that CPU time is hardly waiting. CPU time outside of MPI, user and
system, is work alone; it is told for all numbers of ranks, but is no time of a step: ranks that share cores share caches, and
what one does while the others wait is in its row only. "Others" is the largest of the other ranks. Memory is the largest
resident size in the run. Messages and bytes are those that a rank sends in a step, those within collective calls included.
The difference is that of the bodies' forces, relative to their largest component, and that of the kinetic energy, after the
longer run. The third step of the ellipsoid, of which its tables are, changes the grid and projects the velocity once."""


def main(arguments):
    options = parse(arguments)
    options.folder.mkdir(parents=True, exist_ok=True)
    options.folder = options.folder.resolve()
    counter = scaling_run.build_counter(options.folder)
    cores = count_cores()
    try:
        costs = {name: measure_series(SERIES[name], options.ranks, options.folder, counter,
                                      options.measured) for name in options.series}
    except RunError as error:
        print(f"scripts/benchmark scaling: {error}", file=sys.stderr)
        return 1
    costs = {name: its_costs for name, its_costs in costs.items() if its_costs}
    report = Report()
    report.add("# What a step costs on many ranks", "", "Written by `scripts/benchmark scaling`.", "",
               *describe_machine(timed_run.get_banner()), *LEGEND.format(cores=cores).split("\n"))
    for name, its_costs in costs.items():
        report_series(report, SERIES[name], its_costs, cores)
    scaling_model.report_model(report, {name: (SERIES[name], its_costs)
                                        for name, its_costs in costs.items()})
    (options.folder / "scaling.md").write_text("\n".join(report.lines) + "\n", encoding="utf-8")
    print(f"\nWritten to {options.folder / 'scaling.md'}.")
    return 0
