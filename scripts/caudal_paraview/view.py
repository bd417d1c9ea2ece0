# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens the results of a run of Caudal in ParaView; written by scripts/paraview.

paraview --script=view.py shows them; pvpython view.py picture.png draws a picture instead, of the
last time or of one in seconds that follows. Debian's ParaView needs a display for that: without
one, put xvfb-run -a -s -noreset (package xvfb) in front.
"""

import sys

from paraview.simple import (AnnotateTimeFilter, CellDatatoPointData, CleantoGrid, ColorBy, Contour,
                             ExtractBlock, GetActiveViewOrCreate, Gradient,
                             GetAnimationScene, GetColorTransferFunction, GetScalarBar, Hide,
                             PointDatatoCellData, PVDReader, Render, SaveScreenshot, Show)
from vtkmodules.vtkCommonDataModel import vtkDataAssembly

# FACTS

# Blue, white, red and purple, white, orange: no other hue than the sign needs.
COLOURS = {"vorticity": ((0.02, 0.19, 0.38), (0.57, 0.77, 0.87), (0.97, 0.97, 0.97),
                         (0.96, 0.65, 0.51), (0.40, 0.00, 0.12)),
           "pressure": ((0.33, 0.15, 0.53), (0.70, 0.67, 0.82), (0.97, 0.97, 0.97),
                        (0.99, 0.72, 0.39), (0.70, 0.35, 0.02))}


def extract(reader, name, title):
    """One block of the data as a source of its own."""
    node = vtkDataAssembly.MakeValidNodeName(name)
    return ExtractBlock(registrationName=title, Input=reader, Selectors=[f"/Root/{node}"])


def extract_smooth(reader, name):
    """The same; values that jump from cell to cell are averaged, so that colours have no seams."""
    cells = extract(reader, name, f"cells of {name}")
    means = PointDatatoCellData(registrationName=f"means of {name}", Input=cells)
    joined = CleantoGrid(registrationName=f"joined {name}", Input=means)
    return CellDatatoPointData(registrationName=name, Input=joined)


def make_vortices(reader):
    """The surface Q = LEVEL; Q is made of the velocity if the run has not written it."""
    smooth = extract_smooth(reader, FLUID)
    smooth.UpdatePipeline()
    if "Q" not in smooth.PointData.keys():
        smooth = Gradient(registrationName="Q", Input=smooth, ScalarArray=["POINTS", "velocity"],
                          ComputeGradient=0, ComputeQCriterion=1, QCriterionArrayName="Q")
    return Contour(registrationName="vortices", Input=smooth, ContourBy=["POINTS", "Q"],
                   Isosurfaces=[LEVEL])


def colour(display, view):
    """By COLOUR, from -LIMIT to LIMIT; in three dimensions by its component about z."""
    table = GetColorTransferFunction(COLOUR)
    if LEVEL:
        ColorBy(display, ("POINTS", COLOUR, "Z"))
        table.VectorMode, table.VectorComponent = "Component", 2
        display.Opacity = 0.7
    else:
        ColorBy(display, ("POINTS", COLOUR))
        display.Ambient, display.Diffuse = 1, 0  # no shadows on the colours
    steps = COLOURS[COLOUR]
    table.ColorSpace = "RGB"
    table.RGBPoints = [number for k, rgb in enumerate(steps)
                       for number in (LIMIT * (2 * k / (len(steps) - 1) - 1), *rgb)]
    bar = GetScalarBar(table, view)
    bar.Title = f"{COLOUR} about z [{UNIT}]" if LEVEL else f"{COLOUR} [{UNIT}]"
    bar.ComponentTitle = ""
    bar.Orientation, bar.WindowLocation, bar.Position = "Horizontal", "Any Location", [0.325, 0.04]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.35, 12
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%g", "%g"
    bar.TitleFontSize = bar.LabelFontSize = 14
    display.SetScalarBarVisibility(view, True)


def place_camera(view, bounds):
    """From above; a fish that swims towards -x at the left, its wake behind it."""
    width = 4 * LENGTH if FLUID else 1.6 * LENGTH
    middle = ((bounds[0] - 0.3 * LENGTH + width / 2) if FLUID else (bounds[0] + bounds[1]) / 2,
              (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2)
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle
    view.CameraPosition = (middle[0], middle[1], middle[2] + 10 * LENGTH)
    view.CameraViewUp = (0, 1, 0)
    view.CameraParallelScale = max(width / 2 * view.ViewSize[1] / view.ViewSize[0],
                                   0.7 * (bounds[3] - bounds[2]))


def place_camera_aside(view, bounds):
    """From aside and above, on the first body and two lengths of its wake."""
    direction, up = CAMERA
    middle = [(bounds[0] + bounds[1]) / 2 + LENGTH, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = middle
    view.CameraPosition = [m - 20 * LENGTH * d for m, d in zip(middle, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = 0.9 * LENGTH


def open_run(time=None):
    """Builds the view; at the last time unless another one is given."""
    reader = PVDReader(registrationName="run", FileName=FILE)
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1400, 460 if FLUID and not LEVEL else 700]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0

    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = reader.TimestepValues[-1] if time is None else time

    if LEVEL:
        colour(Show(make_vortices(reader), view), view)
    elif FLUID:
        colour(Show(extract_smooth(reader, FLUID), view), view)
    bodies = [extract(reader, name, name) for name in BODIES]
    for k, body in enumerate(bodies):
        display = Show(body, view)
        if FLUID:
            display.ColorArrayName = ["POINTS", ""]
            display.AmbientColor = display.DiffuseColor = [0.23, 0.25, 0.27]
            if not LEVEL:
                display.Position = [0, 0, 0.01 * LENGTH]  # on top of the plane of the fluid
        else:
            colour(display, view)
            if k > 0:
                Hide(body, view)
    clock = Show(AnnotateTimeFilter(registrationName="time", Input=reader, Format="t = {time:.3f} s"),
                 view)
    clock.Color, clock.FontSize = [0, 0, 0], 16
    Render(view)
    shown = bodies[0] if bodies else reader
    place = place_camera_aside if LEVEL else place_camera
    place(view, shown.GetDataInformation().GetBounds())
    Render(view)
    return view


view = open_run(float(sys.argv[2]) if len(sys.argv) > 2 else None)
if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
    SaveScreenshot(sys.argv[1], view)
