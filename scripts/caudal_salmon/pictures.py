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


def read_series(folder, frequency):
    """(time [s], file) of the surface at one frequency."""
    folder = pathlib.Path(folder)
    names = (f"fish_{frequency:g}Hz", "fish")
    return [(float(entry.get("timestep")), folder / entry.get("file"))
            for entry in xml.parse(folder / "solution.pvd").iter("DataSet")
            if entry.get("name") in names]


def read_surface(path):
    """Corners of the quadrilaterals (n, 4, 3) and the mean pressure in each."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.Update()
    mesh = surface.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    pressure = vtk_to_numpy(mesh.GetPointData().GetArray("pressure"))
    return points[cells], pressure[cells].mean(axis=1)


def get_turn(series):
    """The rotation that makes the fish swim to the left: from its place at both ends."""
    first, last = (read_surface(series[k][1])[0].reshape(-1, 3)[:, :2].mean(axis=0)
                   for k in (0, -1))
    direction = (first - last) / np.linalg.norm(first - last)
    return np.array([direction, (-direction[1], direction[0])])


def draw_surface(axes, path, limit, turn, shift=(0., 0.)):
    """From above, in cm; returns the points."""
    corners, pressure = read_surface(path)
    order = np.argsort(corners[:, :, 2].mean(axis=1))  # the top covers the rest
    points = 100 * corners[order][:, :, :2] @ turn.T + shift
    axes.add_collection(PolyCollection(points, array=pressure[order], cmap=style.PRESSURE,
                                       clim=(-limit, limit), edgecolor="0.7", linewidth=0.15,
                                       rasterized=True))
    return points.reshape(-1, 2)


def draw_swimming(folder, swims, title):
    """Each swim in a row: the fish through its second stroke, and on its way of 20 s."""
    figure, axes = style.make_figure(len(swims), 2, 2.6 * len(swims))
    for row, (case, f) in enumerate(swims):
        series = read_series(folder / case, f)
        times = np.array([time for time, _ in series])
        turn = get_turn(series)
        limit = style.get_round_limit(np.percentile(
            np.abs(read_surface(series[len(series) // 2][1])[1]), 90))
        stroke, way = axes[row]
        seen = []
        for k in range(N_TIMES):
            nearest = int(np.argmin(abs(times - (1 + k / N_TIMES) / f)))
            column, line = k % 3, k // 3
            shift = np.array([13. * column, -7. * line])
            points = draw_surface(stroke, series[nearest][1], limit, turn, shift)
            stroke.annotate(f"{times[nearest]:.2f} s", (13. * column - 1., 3. - 7. * line), fontsize=7)
            seen.append(points)
        ways = [draw_surface(way, series[k][1], limit, turn)
                for k in (0, len(series) // 2, len(series) - 1)]
        for panel, group in ((stroke, seen), (way, ways)):
            points = np.concatenate(group)
            (x0, y0), (x1, y1) = points.min(axis=0) - 1, points.max(axis=0) + 1
            style.set_window(panel, (x0, x1, min(y0, -4.), max(y1, 4.)))
            panel.set_ylabel("[cm]")
        stroke.set_title(f"{case.replace('_', ' ')}, {f} Hz: one stroke; pressure to ±{limit:g} Pa")
        way.set_title(f"at {times[0]:.0f}, {times[len(times) // 2]:.0f} and {times[-1]:.0f} s, "
                      "swimming to the left")
    figure.suptitle(title)
    return figure
