# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/benchmark [NAME...]: runs benchmarks and prints their figures beside the references."""

import argparse
import pathlib
import sys

from caudal_plots import MissingData

from . import report, runs
from .cases import CASES


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/benchmark",
        description="Runs cases and prints: case, quantity, value, reference, error, gate, ok or "
        "off. Results go to output/benchmarks: a folder for each case, table.md and plots. A case "
        "that has ended is not run again unless its .prm or the program has changed. Exit code 1 "
        "if a gate is missed.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="cases; all by default")
    parser.add_argument("--list", action="store_true", help="lists the cases and what they cost")
    parser.add_argument("--ranks", type=int, default=1, help="MPI processes of each run")
    parser.add_argument("--folder", type=pathlib.Path,
                        default=runs.RESULTS / "benchmarks", help="where results go")
    options = parser.parse_args(arguments)
    unknown = [name for name in options.names if name not in CASES]
    if unknown:
        parser.error(f"no case is called {', '.join(unknown)}; there are "
                     f"{', '.join(CASES)}, and salmon and others on their own")
    return options


def measure(case, options):
    """Runs a case, prints its rows and draws its curves; returns its figures."""
    results = []
    for number, overrides in enumerate(case.variants):
        name = case.name if len(case.variants) == 1 else f"{case.name}_{number + 1}"
        results.append(runs.run(case.prm, options.folder / name, overrides, options.ranks))
    figures = case.evaluate(results)
    for figure in figures:
        print(report.format_row(report.make_row(case.name, figure)), flush=True)
    for note in dict.fromkeys(figure.note for figure in figures if figure.note):
        print(f"{'':22}({note})")
    if case.curves:
        report.plot(options.folder / f"{case.name}.png", case, results, figures)
    if case.plot:
        case.plot(options.folder / f"{case.name}.png", figures)
    return figures


def main(arguments):
    options = parse(arguments)
    if options.list:
        print("Costs on one core of an AMD EPYC (2026); a slow shared Xeon took three times as long.")
        for case in CASES.values():
            print(f"{case.name:20}{case.purpose:52}{case.cost}")
        return 0
    options.folder.mkdir(parents=True, exist_ok=True)
    print(report.format_row(report.HEADER))
    tables, failed = {}, []
    for name in options.names or CASES:
        try:
            tables[name] = measure(CASES[name], options)
        except (runs.RunError, MissingData) as error:
            failed.append(name)
            print(f"{name}: {error}", file=sys.stderr)
    report.write_markdown(options.folder / "table.md", tables)
    missed = [name for name, figures in tables.items() if not all(f.is_ok for f in figures)]
    if missed:
        print("Gates missed: " + ", ".join(missed))
    return 1 if missed or failed else 0
