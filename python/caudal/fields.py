# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTU files as numpy arrays: points, triangles or hexahedra, and point data."""

import dataclasses
import functools

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_QUAD, vtkCellArray, vtkImageData,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkProbeFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from .errors import BrokenData, MissingData


@dataclasses.dataclass(eq=False)
class Field:
    """Data on a plane mesh whose cells share their points.

    deal.II writes each cell with points of its own; here the values of the cells
    that meet in a point are averaged, so that colours have no seams.
    """

    points: np.ndarray     # (n, 2) [m]
    triangles: np.ndarray  # (m, 3)
    data: dict             # name -> (n,) or (n, 3)
    grid: object           # the VTK data set, for sampling

    @property
    def cells(self):
        """The triangles, as other fields call theirs."""
        return self.triangles

    @property
    def sizes(self):
        return self.areas

    @functools.cached_property
    def areas(self):
        """Of the triangles [m^2]."""
        a, b, c = (self.points[self.triangles[:, i]] for i in range(3))
        return abs(np.cross(b - a, c - a)) / 2

    @functools.cached_property
    def outline(self):
        """The boundary as closed polygons (k, 2): edges that belong to one triangle only."""
        edges = np.concatenate([self.triangles[:, [0, 1]], self.triangles[:, [1, 2]],
                                self.triangles[:, [2, 0]]])
        _, first, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True,
                                    return_counts=True)
        neighbours = {}
        for a, b in edges[first[count == 1]]:
            neighbours.setdefault(a, []).append(b)
            neighbours.setdefault(b, []).append(a)
        polygons = []
        while neighbours:
            start, polygon = next(iter(neighbours)), []
            while start in neighbours and neighbours[start]:
                polygon.append(start)
                following = neighbours[start].pop()
                neighbours[following].remove(start)
                if not neighbours[start]:
                    del neighbours[start]
                start = following
            neighbours.pop(start, None)
            polygons.append(self.points[polygon])
        return polygons

    def clip(self, window):
        """Indices of the triangles that touch (x0, x1, y0, y1)."""
        x0, x1, y0, y1 = window
        corners = self.points[self.triangles]
        low, high = corners.min(axis=1), corners.max(axis=1)
        return ((high[:, 0] >= x0) & (low[:, 0] <= x1) &
                (high[:, 1] >= y0) & (low[:, 1] <= y1))

    def sample(self, name, x, y):
        """Point data at the nodes of the lattice x times y; nan outside the mesh."""
        lattice = vtkImageData()
        lattice.SetDimensions(len(x), len(y), 1)
        lattice.SetOrigin(x[0], y[0], 0)
        lattice.SetSpacing(x[1] - x[0], y[1] - y[0], 1)
        probe = vtkProbeFilter()
        probe.SetInputData(lattice)
        probe.SetSourceData(self.grid)
        probe.Update()
        data = probe.GetOutput().GetPointData()
        values = vtk_to_numpy(data.GetArray(name)).astype(float)
        is_valid = vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName()))
        values[is_valid == 0] = np.nan
        return values.reshape(len(y), len(x), -1)


def check_whole(path):
    """A VTU file that is not there or was cut off: of the latter VTK complains on stderr only."""
    if not path.is_file():
        raise BrokenData(f"There is no {path}, which solution.pvd lists.")
    with open(path, "rb") as file:
        file.seek(max(path.stat().st_size - 100, 0))
        if b"</VTKFile>" not in file.read():
            raise BrokenData(f"{path} is cut off: its end is missing.")


def merge_points(points):
    """Points that are one, as the first of each and the number of the one that each becomes: their
    coordinates agree to about a millionth of the extent."""
    spacing = 1.234567e-6 * np.ptp(points, axis=0).max()  # lattices don't lie on its roundings
    keys = np.zeros(len(points), dtype=np.int64)
    for column in (points - points.min(axis=0)).T:
        keys = keys * 2_000_000 + np.round(column / spacing).astype(np.int64)
    _, first, merged = np.unique(keys, return_index=True, return_inverse=True)
    return first, merged


def average(values, merged):
    """Of points that are merged the mean values."""
    count = np.bincount(merged)
    if values.ndim == 1:
        return np.bincount(merged, values) / count
    return np.stack([np.bincount(merged, component) / count for component in values.T], axis=1)


def get_arrays(data, merged):
    """Point data of VTK by name, averaged where points are merged."""
    return {data.GetArrayName(i): average(vtk_to_numpy(data.GetArray(i)), merged)
            for i in range(data.GetNumberOfArrays())}


def read_grid(path):
    """A VTU file as the data set of VTK."""
    check_whole(path)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetOutput().GetNumberOfCells() == 0:
        raise BrokenData(f"{path} can't be read or has no cells.")
    return reader.GetOutput()


def read(path):
    """The field in a VTU file; cells of higher order are divided."""
    grid = read_grid(path)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    triangulation = vtkTriangleFilter()
    triangulation.SetInputConnection(surface.GetOutputPort())
    triangulation.Update()
    mesh = triangulation.GetOutput()

    if mesh.GetNumberOfPolys() == 0:
        raise BrokenData(f"{path} can't be read or has no cells.")
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    if np.ptp(points[:, 2]) > 0:
        raise MissingData(f"{path} is three-dimensional: look at it in ParaView.")
    points = points[:, :2]
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    first, merged = merge_points(points)
    return Field(points[first], merged[triangles], get_arrays(mesh.GetPointData(), merged), grid)


@dataclasses.dataclass(eq=False)
class Volume:
    """Data on cells in space that share their points: hexahedra, or the quadrilaterals of a surface;
    values are averaged where cells meet, so that surfaces of equal values have no seams."""

    points: np.ndarray  # (n, 3) [m]
    cells: np.ndarray   # (m, 8) or (m, 4), the order of VTK
    data: dict          # name -> (n,) or (n, 3)

    @functools.cached_property
    def sizes(self):
        """Volumes of the cells of a fluid, which are boxes [m^3]."""
        return np.ptp(self.points[self.cells], axis=1).prod(axis=1)

    def smooth(self, values):
        """Values at the points (n,): means of the mean values of the cells that meet there. Gradients
        jump between cells and are the least exact at their corners."""
        corners = self.cells.ravel()
        means = np.repeat(values[self.cells].mean(axis=1), self.cells.shape[1])
        return np.bincount(corners, means) / np.bincount(corners)

    @functools.cached_property
    def grid(self):
        """The same as a data set of VTK."""
        grid, points, cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(self.points), deep=True))
        n, corners = self.cells.shape
        cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, n * corners + 1, corners, dtype=np.int64),
                                              deep=True),
                      numpy_to_vtkIdTypeArray(self.cells.astype(np.int64).ravel(), deep=True))
        grid.SetPoints(points)
        grid.SetCells(VTK_HEXAHEDRON if corners == 8 else VTK_QUAD, cells)
        for name, values in self.data.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        return grid


def read_volume(path):
    """The fields in a VTU file of three dimensions: of the fluid, of a body, or of a surface."""
    grid = read_grid(path)
    corners = grid.GetCell(0).GetNumberOfPoints()
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    if corners not in (4, 8) or len(cells) != corners * grid.GetNumberOfCells():
        raise BrokenData(f"{path} has cells that are neither hexahedra nor quadrilaterals.")
    first, merged = merge_points(points)
    return Volume(points[first], merged[cells.reshape(-1, corners)],
                  get_arrays(grid.GetPointData(), merged))
