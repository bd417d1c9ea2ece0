# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of scripts/sweep."""

import argparse
import os
import pathlib
import re
import shlex
import sys

from caudal_plots import style
from caudal_plots.program import PROGRAM, RESULTS
from caudal_report import page as html

from . import SweepError, design, estimate, figures, jobs, mesh, page, plot, table
from .case import Case
from .records import ANEW, GOES_ON, KNOWN, NEW, Records, refuse_others, show_folder

# All of these from one table of phases: one run has them.
JOINED = re.compile(r"(Body [^/]+/)?Gait/Frequency")

EPILOG = """
A sweep that is called again makes only what is missing: finished runs are kept, stopped ones go on
from their checkpoints. With a longer -D "Time/End time=..." all go on from where they are; other
settings need another --folder. Results: sweep.csv (units in the headers), sweep.png, report.html,
and runs/<name>/results with what the run printed in runs/<name>/results.txt. Exit codes: 0 all runs
finished; 1 an error, or a run failed (the table tells why); 2 stopped on request.
"""


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/sweep", description="Runs a case of any model with all combinations of the "
        "values of some entries, side by side: a table, plots and a page.", epilog=EPILOG)
    parser.add_argument("case", type=pathlib.Path, metavar="CASE.prm")
    parser.add_argument("axes", nargs="*", metavar="ENTRY=VALUES",
                        help="\"Section/Entry=first:last:number\", \"Section/Entry=v1,v2\", or v1|v2 "
                        "if the values have commas")
    parser.add_argument("--list", type=pathlib.Path, metavar="CSV",
                        help="instead: entries in the first row, below it a row for each run")
    parser.add_argument("--mesh", action="store_true",
                        help="three grids: observed order, convergence index, error bars")
    parser.add_argument("--grids", metavar="A,B,C", help="of --mesh: levels more than in the case "
                        "(-2,-1,0); in the model potential multiples of 3 by 2 cells (1,2,4)")
    parser.add_argument("-D", dest="overrides", action="append", default=[],
                        metavar="ENTRY=VALUE", help="set a parameter in all runs; repeatable")
    parser.add_argument("--figures", metavar="NAMES", help="columns of the table, separated by commas: "
                        "of swim.txt or summary.csv, \"mean of COLUMN\" (last, least, largest) of "
                        "statistics.txt, or all")
    parser.add_argument("--folder", type=pathlib.Path, help="of the results (output/sweep_<case>)")
    parser.add_argument("--jobs", type=int, metavar="N", help="runs at a time (cores over ranks)")
    parser.add_argument("--ranks", type=int, default=1, metavar="N", help="MPI ranks of each run (1)")
    parser.add_argument("--steady-only", action="store_true",
                        help="plot steady beats only; otherwise others have hollow points")
    parser.add_argument("--retry", action="store_true", help="make failed runs again, too")
    parser.add_argument("--no-pages", action="store_true", help="no page for each run: faster")
    parser.add_argument("--dry-run", action="store_true", help="only tell the runs, their "
                        "costs and what is doubtful; write nothing")
    options = parser.parse_args(arguments)
    for name in ("jobs", "ranks"):
        if getattr(options, name) is not None and getattr(options, name) < 1:
            raise SweepError(f"--{name}: the value is {getattr(options, name)}. Give 1 or more.")
    if bool(options.axes) + bool(options.list) + options.mesh != 1:
        raise SweepError("Give either entries with values, or --list, or --mesh: see scripts/sweep "
                         "--help.")
    options.wanted = tuple(name.strip() for name in (options.figures or "").split(",") if name.strip())
    if options.grids and not options.mesh:
        raise SweepError("--grids belongs to --mesh. Give both, or neither.")
    return options


def make_design(case, options):
    """The axes, the points, and the entry whose values are all of one run, if there is one."""
    if options.list:
        return *design.read_list(options.list), None
    axes = [design.parse_axis(text) for text in options.axes]
    joined = next((axis for axis in axes if case.model == "potential" and len(axis.values) > 1
                   and JOINED.fullmatch(axis.entry)), None)
    points = design.combine([design.Axis(axis.entry, (",".join(axis.values),)) if axis is joined
                             else axis for axis in axes])
    return axes, points, joined and joined.entry


def write(case, options, axes, runs, joined, spacings, folder, arguments):
    """Table, plots and pages; what went wrong with pages."""
    entries = list(dict.fromkeys([*(axis.entry for axis in axes), *runs[0].point]))
    results = table.make_table(runs, entries, case.model, options.wanted, joined)
    table.write(results, folder / "sweep.csv")
    print(folder / "sweep.csv")
    unknown = table.find_unknown(runs, case.model, options.wanted)
    troubles = [figures.describe_unknown(unknown)] if unknown else []
    troubles += [] if options.no_pages else page.make_run_pages(runs, case.model)
    command = shlex.join(["scripts/sweep", *arguments])
    if spacings:
        study = mesh.Study(axes[0], spacings, results, entries, case.model)
        figure = study.write(folder)
    else:
        study, figure = None, None
        varied = [axis for axis in axes if len(axis.values) > 1]
        if varied:
            figure = plot.draw(results, varied, entries, case.model, options.steady_only)
    if figure is not None:
        figure.savefig(folder / "sweep.png")
        print(folder / "sweep.png")
    else:
        print("No plot: no figure has a point over an entry with several values."
              if any(job.state == "finished" for job in runs) else "No plot: no run is finished yet.")
        (folder / "sweep.png").unlink(missing_ok=True)  # of an earlier call
    report = page.describe(case, axes, entries, runs, results, figure, folder)
    if study:
        study.describe(report)
    page.add_next_steps(report, command)
    (folder / "report.html").write_text(html.render(report), encoding="utf-8")
    print(folder / "report.html")
    return troubles


def work(arguments):
    options = parse(arguments)
    if not PROGRAM.is_file():
        raise SweepError(f"There is no {PROGRAM}: scripts/setup builds it.")
    case = Case(options.case, options.overrides)
    joined, spacings = None, None
    if options.mesh:
        points, axis, spacings = mesh.make_design(case, options.grids)
        axes = [axis]
    else:
        axes, points, joined = make_design(case, options)
    kind = "mesh" if options.mesh else "sweep"
    folder = (options.folder or RESULTS / f"{kind}_{case.name}").resolve()
    runs = jobs.make_jobs(case, points, folder)
    runner = jobs.Runner(Records(folder, is_read_only=True), options.ranks, options.jobs, options.retry)
    runner.make_plans(runs)
    refuse_others([job.plan for job in runs], folder)
    if any(job.plan.kind != KNOWN for job in runs):
        case.check(points[0])
    if unknown := table.find_unknown(runs, case.model, options.wanted):
        raise SweepError(figures.describe_unknown(unknown) + " No run was started.")
    if options.dry_run:
        return tell_costs(runs, runner.n_at_once, options.mesh)
    runner.check_values(runs)
    runner.records = Records(folder)  # from here on the folder is ours
    runner.make_plans(runs)
    print(*describe_plans(runs, runner.n_at_once, folder), sep="\n", flush=True)
    has_ended = runner.run(runs, lambda job: warn_of_figures(job, options.wanted))
    style.apply()
    axes = design.name_axes(axes, case.read_units())
    troubles = write(case, options, axes, runs, joined, spacings, folder, arguments)
    return finish(runner, runs, troubles, has_ended)


def warn_of_figures(job, wanted):
    """Tells, once a run has finished, of names of figures that it does not have: others go on, as
    their results are not in vain."""
    unknown = table.find_unknown([job], job.case.model, wanted)
    if unknown:
        print(figures.describe_unknown(unknown) + " The table is written without; called again with "
              "other --figures, nothing is run twice.", file=sys.stderr, flush=True)


def tell_costs(runs, n_at_once, is_mesh):
    """--dry-run: what would be made, at which costs, and what is doubtful; the exit code."""
    costs = estimate.check_jobs(runs)
    print(*estimate.list_warnings(costs), *estimate.describe(costs, n_at_once), sep="\n")
    if is_mesh:
        print(mesh.STEP_STAYS)
    return 1 if costs["state"].str.startswith("can't").any() else 0


def describe_plans(runs, n_at_once, folder):
    """What will be done, in lines."""
    kinds = [job.plan.kind for job in runs]
    counts = {"to be made": sum(kind in (NEW, ANEW) for kind in kinds),
              "going on": kinds.count(GOES_ON), "known already": kinds.count(KNOWN)}
    n_missing = len(runs) - counts["known already"]
    told = ", ".join(f"{count} {word}" for word, count in counts.items() if count)
    at_once = f", {min(n_at_once, n_missing)} at a time" if n_missing else ""
    words = "run" if len(runs) == 1 else "runs"
    return [f"{len(runs)} {words} in {show_folder(folder)}: {told}{at_once}."] + \
        [f"{job.name}: {job.plan.describe()}" for job in runs if job.plan.kind == GOES_ON]


def finish(runner, runs, troubles, has_ended):
    """Says what is missing and what to do about it; the exit code."""
    for trouble in troubles:
        print(trouble, file=sys.stderr)
    for version in runner.find_other_versions(runs):
        print(f"Some runs are of another program, {version}; this is {runner.version}. To make them "
              "again, give another --folder.", file=sys.stderr)
    if not has_ended:
        print("Stopped: the same command goes on.", file=sys.stderr)
        return jobs.STOPPED
    failed = [job for job in runs if job.state == "failed"]
    if failed:
        print(f"{len(failed)} of {len(runs)} runs failed: column `remark` of sweep.csv tells why. "
              "--retry makes them again, from their checkpoints if they have any.", file=sys.stderr)
    return 1 if failed or troubles else 0


def main(arguments):
    try:
        return work(arguments)
    except SweepError as error:
        print(f"scripts/sweep: {error}", file=sys.stderr)
    except KeyboardInterrupt:  # not while runs are made: these stop with checkpoints
        print("Stopped: the same command goes on.", file=sys.stderr)
        return jobs.STOPPED
    except OSError as error:
        print(f"scripts/sweep: {error.filename}: {os.strerror(error.errno)}.", file=sys.stderr)
    return 1
