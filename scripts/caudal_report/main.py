# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of scripts/report."""

import argparse
import os
import pathlib
import sys

from caudal import MissingData, read_model
from caudal_plots import style

from . import fish, page, passage, salmon


def main(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/report", description="Writes the report of a run of Caudal, of any of its "
        "models, as one HTML page that needs no network.")
    parser.add_argument("folder", metavar="DIR", type=pathlib.Path, help="the run's output folder")
    parser.add_argument("--output", metavar="FILE", type=pathlib.Path,
                        help="the page (DIR/report.html)")
    parser.add_argument("--frames", metavar="N", type=int, default=100,
                        help="largest number of pictures in the animation (100; 0: none)")
    parser.add_argument("--no-pictures", action="store_true",
                        help="leave out what scripts/plot draws: faster")
    parser.add_argument("--lone", metavar="DIR", type=pathlib.Path,
                        help="the run of a lone fish, over which the gain of a school is told")
    options = parser.parse_args(arguments)
    if options.frames < 0:
        parser.error("--frames: give 0 or more.")
    for folder in filter(None, (options.folder, options.lone)):
        if not folder.is_dir():
            print(f"{folder}: there is no such folder.", file=sys.stderr)
            return 1

    style.apply()
    output = options.output or options.folder / "report.html"
    try:
        what = (options.folder, options.frames, not options.no_pictures)
        model = read_model(options.folder)
        if options.lone and model != "immersed":
            raise MissingData("--lone: only the immersed model has schools.")
        if model == "potential":
            report = salmon.describe(*what)
        elif model == "passage":
            report = passage.describe(options.folder)
        else:
            report = fish.describe(*what, options.lone)
        text = page.render(report)
        temporary = output.with_name(output.name + ".tmp")
        temporary.write_text(text, encoding="utf-8")
        os.replace(temporary, output)
    except MissingData as reason:
        print(f"scripts/report: no report. {reason}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"scripts/report: {output} can't be written: {error.strerror}.", file=sys.stderr)
        return 1
    print(f"{output} ({len(text.encode()) / 1e6:.1f} MB)")
    for trouble in dict.fromkeys(report.troubles):
        print(f"scripts/report: {trouble} The page says what is missing.", file=sys.stderr)
    return 1 if report.troubles else 0
