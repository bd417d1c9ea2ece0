# SPDX-License-Identifier: LGPL-2.1-or-later
"""Animations: the vorticity of the wake with the bodies, and the swimming surface."""

import dataclasses
import io

import matplotlib
import numpy as np
from matplotlib import font_manager
from PIL import Image, ImageDraw, ImageFont
from vtkmodules.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkProbeFilter

from caudal_plots import MissingData, flow, space, style

from . import page

WIDTH = 1140       # of a picture [pixels]
MOST_HEIGHT = 520
WIDEST = 8.        # a window that stands still is at most that many bodies long
COLOURS = "RdBu_r"


@dataclasses.dataclass
class Movie:
    """Pictures of the same size, each with its caption."""

    title: str
    kind: str      # image/...
    frames: list   # bytes
    captions: list
    scale: page.Html  # what the colours mean


def choose(items, count):
    """At most so many of the items, evenly, the first and the last included."""
    if len(items) <= count:
        return list(items)
    return [items[k] for k in np.unique(np.linspace(0, len(items) - 1, count).round().astype(int))]


def encode(image):
    data = io.BytesIO()
    image.save(data, "WEBP", quality=82, method=3)
    return data.getvalue()


def make_mesh(field):
    """A field as a VTK data set whose cells share their points: values without seams."""
    mesh = vtkPolyData()
    points, cells = vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(np.column_stack([field.points, np.zeros(len(field.points))]),
                                deep=True))
    ends = np.arange(0, 3 * len(field.triangles) + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(ends, deep=True),
                  numpy_to_vtkIdTypeArray(field.triangles.astype(np.int64).ravel(), deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def sample(field, name, window, size):
    """Point data on the pixels of a window, the upper row first; nan outside of the mesh."""
    x0, x1, y0, y1 = window
    lattice = vtkImageData()
    lattice.SetDimensions(*size, 1)
    mesh = make_mesh(field)
    values = numpy_to_vtk(flow.get_data(field, name), deep=True)
    values.SetName(name)
    mesh.GetPointData().AddArray(values)
    spacing = (x1 - x0) / size[0], (y1 - y0) / size[1]
    lattice.SetOrigin(x0 + spacing[0] / 2, y0 + spacing[1] / 2, 0)
    lattice.SetSpacing(*spacing, 1)
    probe = vtkProbeFilter()
    probe.SetInputData(lattice)
    probe.SetSourceData(mesh)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    values = vtk_to_numpy(data.GetArray(name)).reshape(size[1], size[0])
    is_valid = vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())).reshape(values.shape)
    return np.where(is_valid > 0, values, np.nan)[::-1]


def get_font(size):
    return ImageFont.truetype(font_manager.findfont("DejaVu Sans"), size)


class Camera:
    """What a picture shows: the whole way of the bodies or, if it is long, what is near to one."""

    def __init__(self, run, times):
        first, last = (run.read_bodies(time) for time in (times[0], times[-1]))
        points = np.concatenate([body.points for bodies in (first, last) for body in bodies.values()])
        self.length = flow.get_length(next(iter(first.values())))
        margin = 0.5 * self.length
        x0, x1, y0, y1 = flow.get_limits(points)
        self.domain = flow.get_limits(run.read_fluid(times[-1]).points)
        self.is_fixed = x1 - x0 + 2 * margin <= WIDEST * self.length
        if self.is_fixed:
            window = x0 - margin, x1 + margin, y0 - margin, y1 + margin
        else:
            window = 0, 5 * self.length, 0, y1 - y0 + 2 * margin
        self.extent = window[1] - window[0], min(window[3] - window[2],
                                                 (window[1] - window[0]) * MOST_HEIGHT / WIDTH)
        self.corner = window[0], (window[2] + window[3] - self.extent[1]) / 2
        self.size = WIDTH, 2 * round(WIDTH * self.extent[1] / self.extent[0] / 2)

    def get_window(self, body):
        x, y = self.corner
        if not self.is_fixed:
            x0, x1, y0, y1 = flow.get_limits(body.points)
            x, y = x0 - 0.5 * self.length, (y0 + y1 - self.extent[1]) / 2
        return x, x + self.extent[0], y, y + self.extent[1]


def draw_frame(run, time, camera, limit):
    """The vorticity in colours with the bodies on it and a scale bar."""
    bodies = run.read_bodies(time)
    window = camera.get_window(next(iter(bodies.values())))
    values = sample(run.read_fluid(time), "vorticity", window, camera.size)
    colours = matplotlib.colormaps[COLOURS](np.clip(0.5 + 0.5 * values / limit, 0, 1), bytes=True)
    colours[np.isnan(values)] = (225, 228, 231, 255)
    image = Image.fromarray(np.ascontiguousarray(colours[..., :3]))
    draw = ImageDraw.Draw(image)
    scale = camera.size[0] / camera.extent[0]
    for name, body in bodies.items():
        for polygon in body.outline:
            pixels = [((x - window[0]) * scale, (window[3] - y) * scale) for x, y in polygon]
            if len(pixels) > 2:
                draw.polygon(pixels, fill=style.BODY, outline="black")
        if len(bodies) > 1:
            x, y = body.points[:, 0].mean(), body.points[:, 1].max()
            draw.text(((x - window[0]) * scale, (window[3] - y) * scale - 4), name, fill="black",
                      font=get_font(13), anchor="mb")
    height = camera.size[1]
    draw.line([(16, height - 16), (16 + camera.length * scale, height - 16)], fill="black", width=2)
    draw.text((16, height - 36), f"{camera.length:.3g} m", fill="black", font=get_font(14))
    return encode(image)


def make_scale(limit, label):
    """The colour scale as HTML."""
    stops = ", ".join(matplotlib.colors.to_hex(matplotlib.colormaps[COLOURS](k / 12))
                      for k in range(13))
    return page.Html('<div class="scale">{0} −{1} <span class="bar" style="background: '
                     'linear-gradient(to right, {2})"></span> {1}, red: anticlockwise '
                     '<span class="blob"></span> body</div>').format(label, f"{limit:g}", stops)


def make_wake_movie(run, count):
    """The vorticity of all outputs, or of @p count of them."""
    times = choose(run.times, count)
    if not run.read_bodies(times[0]):
        raise MissingData("solution.pvd lists no body beside the fluid.")
    limit = flow.get_vorticity_limit(run.read_fluid(times[-1]), run.read_bodies(times[-1]))
    camera = Camera(run, times)
    frames = [draw_frame(run, time, camera, limit) for time in times]
    title = (f"The wake: {len(times)} of {len(run.times)} outputs, at rest in the domain"
             if camera.is_fixed else
             f"The wake: {len(times)} of {len(run.times)} outputs, the picture moves with the fish")
    return Movie(title, "webp", frames, [f"t = {time:.3f} s" for time in times],
                 make_scale(limit, "vorticity [1/s]"))


def make_vortex_movie(run, count):
    """The vortices of all outputs in three dimensions, or of @p count of them."""
    times = choose(run.times, count)
    sequence = space.Sequence(run)
    width = min(WIDTH, round(MOST_HEIGHT / sequence.shape))
    frames = [encode(Image.fromarray(sequence.render(time, width)[0])) for time in times]
    return Movie(f"Vortices, Q = {sequence.last.level:g} s⁻²: {len(times)} of {len(run.times)} outputs, "
                 "the picture moves with the body", "webp", frames,
                 [f"t = {time:.3f} s" for time in times],
                 make_scale(sequence.last.limit, "vorticity about z [1/s]"))
