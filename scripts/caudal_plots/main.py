# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: which figures there are, and what happens if one can't be made."""

import argparse
import pathlib
import sys

from caudal import Run

from . import BrokenData, MissingData, film, flow, history, passage, space, style

# Of the immersed model: file name in DIR/plots, what it shows, the function that draws it.
CHARTS = (
    ("speed", "speed and displacement of point A, or of the centre of mass", history.draw_speed),
    ("volume", "area change and range of J", history.draw_volume),
    ("energy", "energy ledger", history.draw_energy),
)
FIGURES = CHARTS + (
    ("vorticity", "vorticity and bodies at the last time", flow.draw_vorticity),
    ("start_up", "pressure, velocity and bodies while starting", flow.draw_start_up),
    ("cruise", "pressure, velocity and bodies in the last tail beat", flow.draw_cruise),
    ("body_wave", "outlines through the last tail beat", flow.draw_body_wave),
)
SPATIAL = (
    ("vortices", "surface of Q coloured by vorticity, in perspective and from three sides",
     space.draw_vortices),
    ("slices", "vorticity across planes, those of Output/Slices or three through the first body",
     space.draw_slices),
    ("surface", "pressure, traction and speed on the bodies (Output/Surfaces)", space.draw_surface),
)


def get_figures(run):
    """What can be drawn of a run of the immersed model."""
    return CHARTS + SPATIAL if run.is_spatial else FIGURES


def read_names(text):
    """The figures of --only, "cruise,energy"; argparse says what is wrong with it."""
    known = [name for name, _, _ in FIGURES + SPATIAL + passage.FIGURES]
    names = [name.strip() for name in text.split(",") if name.strip()]
    for name in names or [text]:
        if name not in known:
            raise argparse.ArgumentTypeError(f"<{name}> is no figure; there are {', '.join(known)}")
    return names


def find_obstacle(folder):
    """Why nothing can be drawn of the folder, and where its pictures are; None if it can be."""
    if not folder.is_dir():
        return f"{folder}: there is no such folder."
    if any((folder / f"sweep.{ending}").exists() for ending in ("csv", "json", "lock")):
        there = [str(folder / name) for name in ("sweep.png", "report.html") if (folder / name).is_file()]
        return (f"{folder} is the folder of a sweep, "
                + (f"whose pictures are in {' and '.join(there)}; " if there else "without pictures yet; ")
                + f"scripts/plot draws single runs, those in {folder / 'runs'}.")
    try:
        model = Run(folder).model
    except BrokenData as reason:
        return str(reason)
    except MissingData:
        model = None
    if model == "potential":
        return (f"{folder} is a run in an ideal fluid; scripts/report {folder} makes a page of it, with "
                "its pictures.")
    has_results = any((folder / name).exists() for name in
                      ("statistics.txt", "solution.pvd", "passage.json", "parameters.prm"))
    if has_results:
        return None
    runs = sorted({str(path.parent) for path in folder.glob("*/parameters.prm")})
    return f"{folder} holds no results of a run" + (
        f"; it has folders of runs in it: {', '.join(runs)}." if runs else
        ". Give the folder that Output/Folder of the run names.")


def save(figure, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)
    style.close(figure)
    print(path)


def main(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/plot", description="Draws the results of a run of Caudal as PNG files.",
        epilog="Figures: " + "; ".join(f"{name}: {text}" for name, text, _ in FIGURES)
        + ". In three dimensions, in place of those of the fields: "
        + "; ".join(f"{name}: {text}" for name, text, _ in SPATIAL)
        + ". Of a run with Model = passage: "
        + "; ".join(f"{name}: {text}" for name, text, _ in passage.FIGURES) + ".")
    parser.add_argument("folder", metavar="DIR", type=pathlib.Path,
                        help="the run's output folder; the pictures go to DIR/plots")
    parser.add_argument("--only", metavar="NAME,...", action="extend", type=read_names,
                        help="draw these figures only")
    parser.add_argument("--limit", metavar="VALUE", type=float,
                        help="end of the vorticity's colour scale [1/s], which else the wake decides")
    parser.add_argument("--level", metavar="VALUE", type=float,
                        help="Q of the vortices' surface [1/s^2], which else the wake decides")
    parser.add_argument("--movie", action="store_true",
                        help="make a film of the vorticity, DIR/plots/movie.mp4 and movie.gif, too")
    options = parser.parse_args(arguments)

    obstacle = find_obstacle(options.folder)
    if obstacle:
        print(obstacle, file=sys.stderr)
        return 1

    style.apply()
    is_passage = (options.folder / "passage.json").is_file()
    run = passage.Answers(options.folder) if is_passage else Run(options.folder)
    figures = passage.get_figures(options.folder) if is_passage else get_figures(run)
    limits = {"vorticity": {"limit": options.limit}, "slices": {"limit": options.limit},
              "vortices": {"limit": options.limit, "level": options.level}}
    tasks = [(name, lambda name=name, draw=draw: save(draw(run, **limits.get(name, {})),
                                                      run.folder / "plots" / f"{name}.png"))
             for name, _, draw in figures
             if not options.only or name in options.only]
    if options.movie:
        tasks.append(("movie", lambda: film.make(run, run.folder / "plots")))

    missing = [name for name in options.only or () if name not in [figure[0] for figure in figures]]
    for name in missing:
        print(f"{name}: not drawn. It is none of the pictures of this run, which are: "
              + ", ".join(figure[0] for figure in figures) + ".", file=sys.stderr)
    for name, draw in tasks:
        try:
            draw()
        except MissingData as reason:
            print(f"{name}: not drawn. {reason}", file=sys.stderr)
            missing.append(name)
    # What was asked for by name must be there; of all others, one.
    was_wanted = any(name == "movie" or options.only for name in missing)
    return 1 if was_wanted or len(missing) == len(tasks) else 0
