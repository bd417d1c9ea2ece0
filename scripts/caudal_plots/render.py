# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of surfaces in space by VTK, without a screen."""

import atexit
import os
import shutil
import subprocess
import sys

import numpy as np

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: what draws
from caudal_setup import SETUP
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

from . import MissingData

NO_DISPLAY = ("Pictures of three dimensions need a display or the program Xvfb, which stands in for one: "
              "Debian's package xvfb has it.")
SERVERS = []  # that were started; the last one is in use


def find_xvfb():
    """The program; it is installed where scripts/setup can."""
    if not shutil.which("Xvfb") and SETUP.exists() and shutil.which("dpkg-query"):
        subprocess.run([str(SETUP), "--no-build", "xvfb"], stdout=sys.stderr, check=False)
    return shutil.which("Xvfb")


def open_display():
    """A display in memory, which no window can disturb; without the program for it that of the user."""
    if SERVERS and SERVERS[-1].poll() is None:
        return
    xvfb = find_xvfb()
    if xvfb is None:
        if os.environ.get("DISPLAY"):
            return
        raise MissingData(NO_DISPLAY)
    reader, writer = os.pipe()
    server = subprocess.Popen([xvfb, "-displayfd", str(writer), "-screen", "0", "1280x1024x24",
                               "-nolisten", "tcp", "-noreset"], pass_fds=(writer,), stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    SERVERS.append(server)
    atexit.register(server.terminate)
    os.close(writer)
    with os.fdopen(reader) as file:  # a line when it is ready, nothing if it ends before
        number = file.readline().strip()
    if not number:
        raise MissingData(f"{xvfb} does not start. " + NO_DISPLAY)
    os.environ["DISPLAY"] = f":{number}"


def make_table(colours, low, high):
    """A colour map of matplotlib for VTK."""
    table = vtkLookupTable()
    table.SetTableRange(low, high)
    rgba = np.round(255 * colours(np.linspace(0, 1, 256))).astype(np.uint8)
    table.SetTable(numpy_to_vtk(rgba, deep=True))
    return table


def make_actor(mesh, colour=(0.23, 0.25, 0.27), opacity=1., name=None, table=None):
    """A surface in one colour, or in those of its point data @p name."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarVisibility(name is not None)
    if name is not None:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(name)
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetOpacity(opacity)
    # Colours that mean something are shaded less.
    actor.GetProperty().SetAmbient(0.35 if name is None else 0.6)
    actor.GetProperty().SetDiffuse(0.7 if name is None else 0.42)
    return actor


def get_axes(direction, up):
    """Right and up of a picture whose camera looks along the direction, as unit vectors."""
    direction = np.asarray(direction, dtype=float) / np.linalg.norm(direction)
    right = np.cross(direction, up)
    right /= np.linalg.norm(right)
    return right, np.cross(right, direction)


def get_extent(box, direction, up):
    """(x0, x1, y0, y1) that a box (3, 2) takes on the picture along its right and up."""
    corners = np.stack(np.meshgrid(*box, indexing="ij"), axis=-1).reshape(-1, 3)
    right, above = get_axes(direction, up)
    x, y = corners @ right, corners @ above
    return x.min(), x.max(), y.min(), y.max()


def render(actors, box, direction, up, width):
    """The actors as pixels (height, width, 3) by parallel projection, and the extent that these show
    along right and up of the picture."""
    open_display()
    extent = get_extent(box, direction, up)
    height = max(round(width * (extent[3] - extent[2]) / (extent[1] - extent[0])), 16)
    middle, depth = np.mean(box, axis=1), np.linalg.norm(np.ptp(box, axis=1))
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle - 2 * depth * np.asarray(direction) / np.linalg.norm(direction)))
    camera.SetViewUp(*up)
    camera.SetParallelScale((extent[3] - extent[2]) / 2)
    camera.SetClippingRange(0.1 * depth, 4 * depth)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)  # more pixels than are shown make up for it
    window.SetAlphaBitPlanes(1)  # surfaces that can be seen through are drawn in their order
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(6)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    pixels = pixels.reshape(image.GetDimensions()[1], image.GetDimensions()[0], -1)[::-1, :, :3]
    pixels = np.array(pixels)
    window.Finalize()
    return pixels, extent


def crop(pixels, extent, margin=0.02):
    """The picture without the white round what it shows."""
    is_drawn = (pixels < 255).any(axis=2)
    if not is_drawn.any():
        return pixels, extent
    limits, (height, width) = [], is_drawn.shape
    for axis, size in ((0, width), (1, height)):
        places = np.flatnonzero(is_drawn.any(axis=axis))
        border = round(margin * max(width, height))
        limits += [max(places[0] - border, 0), min(places[-1] + 1 + border, size)]
    left, right, top, bottom = limits
    x0, x1, y0, y1 = extent
    x, y = (x1 - x0) / width, (y1 - y0) / height
    return pixels[top:bottom, left:right], (x0 + left * x, x0 + right * x, y1 - bottom * y, y1 - top * y)
