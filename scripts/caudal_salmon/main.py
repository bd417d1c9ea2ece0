# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of scripts/salmon."""

import argparse
import pathlib
import sys

from caudal_plots.program import PROGRAM, RESULTS
from caudal_sweep import SweepError

from . import study


def main(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/salmon", description="Makes the study of Yao et al. of the ideal-fluid salmon. What "
        "was computed already is not computed again.", epilog="Sweeps over parameters and mesh "
        "studies of this fish, as of any other: scripts/sweep.")
    parser.add_argument("--folder", type=pathlib.Path, default=RESULTS / "salmon_study",
                        help="of the results (output/salmon_study)")
    options = parser.parse_args(arguments)
    if not PROGRAM.is_file():
        print(f"There is no {PROGRAM}: scripts/setup builds it.", file=sys.stderr)
        return 1
    try:
        return study.main(options.folder.resolve())
    except SweepError as error:
        print(f"scripts/salmon: {error}", file=sys.stderr)
        return 1
