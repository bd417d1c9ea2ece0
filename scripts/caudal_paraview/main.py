# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line of scripts/paraview: what a view has to know of a run."""

import argparse
import pathlib
import sys

import numpy as np

from caudal import Run, fields
from caudal_plots import MissingData, flow, space, style
from caudal_salmon import pictures

VIEW = pathlib.Path(__file__).resolve().parent / "view.py"


def describe_immersed(run):
    """Fluid and bodies: the scale of the vorticity is that of scripts/plot."""
    time = run.times[-1]
    if run.is_spatial:
        return describe_spatial(run, time)
    body = flow.get_first_body(run, time)
    fluid = run.read_fluid(time)
    return {"FLUID": "fluid", "BODIES": list(run.read_bodies(time)), "COLOUR": "vorticity",
            "LIMIT": float(flow.get_vorticity_limit(fluid, run.read_bodies(time))), "UNIT": "1/s",
            "LENGTH": float(flow.get_length(body)), "LEVEL": None}


def describe_spatial(run, time):
    """The same in three dimensions, where a surface of equal Q shows the vortices."""
    bodies, fluid = run.read_volumes(time), run.read_volume(time, "fluid")
    length = flow.get_length(next(iter(bodies.values()))) if bodies else np.ptp(fluid.points[:, 0])
    return {"FLUID": "fluid", "BODIES": list(bodies), "COLOUR": "vorticity",
            "LIMIT": float(flow.get_vorticity_limit(fluid, bodies)), "UNIT": "1/s",
            "LENGTH": float(length), "LEVEL": float(space.find_level(fluid, bodies)),
            "CAMERA": space.PERSPECTIVE}


def describe_potential(run):
    """The swimming surfaces; the one in the middle of the frequencies is shown."""
    names = list(dict.fromkeys(name for blocks in run.files.values() for name in blocks))
    shown = names[len(names) // 2]
    times = sorted(time for time, blocks in run.files.items() if shown in blocks)
    path = run.files[times[len(times) // 2]][shown]
    fields.check_whole(path)
    corners, pressure = pictures.read_surface(path)
    return {"FLUID": None, "BODIES": [shown] + [name for name in names if name != shown],
            "COLOUR": "pressure", "UNIT": "Pa",
            "LIMIT": float(style.get_round_limit(np.percentile(abs(pressure), 90))),
            "LENGTH": float(np.ptp(corners.reshape(-1, 3), axis=0).max()), "LEVEL": None}


def main(arguments):
    parser = argparse.ArgumentParser(
        prog="scripts/paraview", description="Writes DIR/view.py, which opens a run of Caudal in "
        "ParaView: fluid and bodies together, coloured by vorticity, or by pressure in an ideal fluid; in three dimensions "
        "the vortices, a surface of equal Q.")
    parser.add_argument("folder", metavar="DIR", type=pathlib.Path, help="the run's output folder")
    options = parser.parse_args(arguments)
    folder = options.folder.resolve()
    if not folder.is_dir():
        print(f"{options.folder}: there is no such folder.", file=sys.stderr)
        return 1
    run = Run(folder)
    try:
        is_immersed = any("fluid" in blocks for blocks in run.files.values())
        facts = describe_immersed(run) if is_immersed else describe_potential(run)
        text = VIEW.read_text(encoding="utf-8")
        head, _, rest = text.partition("# FACTS\n")
        constants = {"FILE": str(folder / "solution.pvd"), **facts}
        lines = "".join(f"{name} = {value!r}\n" for name, value in constants.items())
        script = folder / "view.py"
        script.write_text(head + lines + rest, encoding="utf-8")
    except MissingData as reason:
        print(f"scripts/paraview: no view. {reason}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"scripts/paraview: {folder} can't be read or written: {error}.", file=sys.stderr)
        return 1
    print(f"paraview --script={script}")
    print(f"pvpython {script} picture.png    # without a display: xvfb-run -a -s -noreset pvpython ...")
    return 0
