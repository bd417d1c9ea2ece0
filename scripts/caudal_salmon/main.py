# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of scripts/salmon."""

import argparse
import pathlib
import sys

from . import mesh, runs, study, sweep


def main(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/salmon", description="Makes the paper's study of the ideal-fluid salmon, or "
        "a study of one case. What was computed already is not computed again.")
    parser.add_argument("case", nargs="?", type=pathlib.Path,
                        default=runs.ROOT / "prm" / "salmon" / "salmon.prm",
                        help="for --sweep and --mesh (prm/salmon/salmon.prm)")
    parser.add_argument("--sweep", metavar="SECTION/ENTRY=A:B:N",
                        help="N values from A to B: a table and a plot of the results")
    parser.add_argument("--mesh", action="store_true",
                        help="130 to 4,610 panels: observed order and Richardson's value")
    parser.add_argument("--finest", action="store_true", help="--mesh up to 8,194 panels (minutes)")
    parser.add_argument("-D", dest="overrides", metavar="SECTION/ENTRY=VALUE", action="append",
                        default=[], help="set a parameter, in --sweep and --mesh")
    parser.add_argument("--folder", type=pathlib.Path, help="of the results (output/salmon_...)")
    options = parser.parse_args(arguments)
    if not runs.PROGRAM.is_file():
        print(f"There is no {runs.PROGRAM}: scripts/setup builds it.", file=sys.stderr)
        return 1
    kind = "sweep" if options.sweep else "mesh" if options.mesh else "study"
    folder = (options.folder or runs.RESULTS / f"salmon_{kind}").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    try:
        if options.sweep:
            return sweep.main(options.sweep, options.case.resolve(), folder, options.overrides)
        if options.mesh:
            return mesh.main(options.case.resolve(), folder, options.overrides, options.finest)
        return study.main(folder)
    except runs.RunError as error:
        print(error, file=sys.stderr)
        return 1
