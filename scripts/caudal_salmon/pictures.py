# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the swimming surface, from above."""

import pathlib
import xml.etree.ElementTree as xml

import numpy as np
from matplotlib.collections import PolyCollection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from caudal_plots import style

N_TIMES = 6
PARTS = 4  # of a cell's sides, for smooth colours
LATTICE = np.array([13., 6.5])  # between the pictures of one stroke [cm]


def read_series(folder, frequency):
    """(time [s], file) of the surface at one frequency."""
    folder = pathlib.Path(folder)
    names = (f"fish_{frequency:g}Hz", "fish")
    return [(float(entry.get("timestep")), folder / entry.get("file"))
            for entry in xml.parse(folder / "solution.pvd").iter("DataSet")
            if entry.get("name") in names]


def divide(values, parts):
    """Of values at the corners of quadrilaterals (n, 4, ...) those at the corners of their parts by
    parts equal pieces, bilinearly."""
    t = np.linspace(0, 1, parts + 1)
    x, y = np.meshgrid(t, t)
    weights = np.stack([(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y])
    nodes = np.einsum("cij,nc...->nij...", weights, values)
    pieces = np.stack([nodes[:, :-1, :-1], nodes[:, :-1, 1:], nodes[:, 1:, 1:], nodes[:, 1:, :-1]], axis=3)
    return pieces.reshape(-1, 4, *values.shape[2:])


def read_surface(path, parts=1):
    """Corners of the quadrilaterals (n, 4, 3) and the mean pressure in each; divided into parts by
    parts pieces, so that colours are smooth."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.Update()
    mesh = surface.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    pressure = vtk_to_numpy(mesh.GetPointData().GetArray("pressure"))
    return divide(points[cells], parts), divide(pressure[cells], parts).mean(axis=1)


def get_turn(series):
    """The rotation that makes the fish swim to the left: from its place at both ends."""
    first, last = (read_surface(series[k][1])[0].reshape(-1, 3)[:, :2].mean(axis=0)
                   for k in (0, -1))
    direction = (first - last) / np.linalg.norm(first - last)
    return np.array([direction, (-direction[1], direction[0])])


def draw_surface(axes, path, limit, turn, shift=(0., 0.)):
    """From above, in cm; returns the points."""
    corners, pressure = read_surface(path, PARTS)
    order = np.argsort(corners[:, :, 2].mean(axis=1))  # the top covers the rest
    points = 100 * corners[order][:, :, :2] @ turn.T + shift
    # Their edges stick out from below: an outline.
    axes.add_collection(PolyCollection(points, facecolor="0.55", edgecolor="0.55", linewidth=0.9,
                                       rasterized=True))
    axes.add_collection(PolyCollection(points, array=pressure[order], cmap=style.PRESSURE,
                                       clim=(-limit, limit), edgecolor="face", linewidth=0.2,
                                       rasterized=True))
    return points.reshape(-1, 2)


def draw_named(axes, series, index, limit, turn, shift):
    """The fish at one time, which is written above it; returns the points."""
    time, path = series[index]
    points = draw_surface(axes, path, limit, turn, shift)
    axes.annotate(f"{time:.1f} s", (points[:, 0].mean(), points[:, 1].max() + 0.4), fontsize=7,
                  ha="center")
    return points


def draw_stroke(axes, series, f, limit, turn):
    """The fish at equal steps of its second stroke: two lines of three."""
    times = np.array([time for time, _ in series])
    nearest = [int(np.argmin(abs(times - (1 + k / N_TIMES) / f))) for k in range(N_TIMES)]
    return np.concatenate([draw_named(axes, series, index, limit, turn, LATTICE * (k % 3, -(k // 3)))
                           for k, index in enumerate(nearest)])


def draw_way(axes, series, limit, turn):
    """The fish at the start, in the middle and at the end of the swim, stacked."""
    return np.concatenate([draw_named(axes, series, index, limit, turn, LATTICE * (0, -k))
                           for k, index in enumerate((0, len(series) // 2, len(series) - 1))])


def draw_swimming(folder, swims, title):
    """Each swim in a row: the fish through its second stroke, and on its way of 20 s."""
    figure, axes = style.make_figure(len(swims), 2, 2.4 * len(swims) + 0.4)
    seen = {0: [], 1: []}
    for panels, (case, f) in zip(axes, swims):
        series = read_series(folder / case, f)
        turn = get_turn(series)
        limit = style.get_round_limit(np.percentile(
            np.abs(read_surface(series[len(series) // 2][1])[1]), 80))
        seen[0].append(draw_stroke(panels[0], series, f, limit, turn))
        seen[1].append(draw_way(panels[1], series, limit, turn))
        panels[0].set_title(f"{case.replace('_', ' ')}, {f} Hz: second stroke")
        panels[1].set_title("start, middle and end of the swim, to the left")
        figure.colorbar(panels[1].collections[-1], ax=panels[1], label="pressure [Pa]", shrink=0.6,
                        aspect=12, ticks=(-limit, 0, limit), extend="both")
    for column, groups in seen.items():  # in the same scale and window
        points = np.concatenate(groups)
        (x0, y0), (x1, y1) = points.min(axis=0) - 1, points.max(axis=0) + (1, 2.5)
        for panel in axes[:, column]:
            style.set_window(panel, (x0, x1, y0, y1))
            panel.set_yticks([])
        axes[-1, column].set_xlabel("[cm]")
    figure.suptitle(title)
    return figure
