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


def draw_surface(axes, path, limit):
    corners, pressure = read_surface(path)
    order = np.argsort(corners[:, :, 2].mean(axis=1))  # the top covers the rest
    axes.add_collection(PolyCollection(100 * corners[order][:, :, :2], array=pressure[order],
                                       cmap=style.PRESSURE, clim=(-limit, limit),
                                       edgecolor="face", linewidth=0.2, rasterized=True))
    return 100 * corners.reshape(-1, 3)[:, :2]


def draw_swimming(folder, swims, title):
    """Each swim in a row: the fish through its second stroke, then at the start and the end."""
    figure, axes = style.make_figure(len(swims), 2, 2.4 * len(swims),
                                     gridspec_kw={"width_ratios": (2, 1)})
    for row, (case, f) in enumerate(swims):
        series = read_series(folder / case, f)
        times = np.array([time for time, _ in series])
        limit = style.get_round_limit(np.percentile(
            np.abs(read_surface(series[len(series) // 2][1])[1]), 95))
        seen = []
        for k in range(N_TIMES):
            nearest = int(np.argmin(abs(times - (1 + k / N_TIMES) / f)))
            points = draw_surface(axes[row, 0], series[nearest][1], limit)
            shift = np.array([0., -3. * k])
            axes[row, 0].collections[-1].set_offsets([shift])
            axes[row, 0].collections[-1].set_offset_transform(axes[row, 0].transData)
            seen.append(points + shift)
            axes[row, 0].annotate(f"{times[nearest]:.2f} s", points.max(axis=0) + shift + (0.3, -1.2),
                                  fontsize=6)
        ends = [draw_surface(axes[row, 1], path, limit)
                for _, path in (series[0], series[len(series) // 2], series[-1])]
        for panel, group in ((axes[row, 0], seen), (axes[row, 1], ends)):
            points = np.concatenate(group)
            low, high = points.min(axis=0) - 0.6, points.max(axis=0) + 0.6
            style.set_window(panel, (low[0], high[0] + (2 if panel is axes[row, 0] else 0),
                                     low[1], high[1]))
            panel.set_xlabel("x [cm]")
        axes[row, 0].set_ylabel("y [cm], shifted")
        axes[row, 0].set_title(f"{case.replace('_', ' ')}, {f} Hz, one stroke; pressure to "
                               f"±{limit:g} Pa")
        axes[row, 1].set_title(f"at {times[0]:.0f}, {times[len(times) // 2]:.0f} and {times[-1]:.0f} s")
    figure.suptitle(title)
    return figure
