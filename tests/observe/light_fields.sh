# SPDX-License-Identifier: LGPL-2.1-or-later
# Surfaces of bodies, slices and additional fields, in two and in three dimensions, on one rank and
# on two, as VTU and as HDF5, where all is known: the initial flow is linear, u = A x with
#   A = (-a/2 -w 0; w -a/2 0; 0 0 a), in two dimensions (-a/2 -w; w a/2),
# so that Q = w^2 - 3/4 a^2 and lambda_2 = a^2/4 - w^2, in two dimensions w^2 - a^2/4 and -Q; without
# any pressure the traction is mu (A + A^T) n, the integral of t x over the surface mu (A + A^T) V.
# Then at rest under a body force f: the integral of the traction is that of the pressure, -rho f V.
set -e
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

# write_case DIMENSION: linear.prm and still.prm.
write_case() {
  if [ $1 = 2 ]; then
    ones="1, 1" twos="4, 4" middle="0.5, 0.5" planes="0.3, 0.5 : 1, 0; 0.5, 0.5 : 1, 1"
    flow="-0.5*x-1.5*y; 1.5*x+0.5*y" force="0; -2" elements="8, 8"
  else
    ones="1, 1, 1" twos="2, 2, 2" middle="0.5, 0.5, 0.5"
    planes="0.5, 0.5, 0.5 : 0, 0, 1; 1, 0.5, 0.5 : 1, 0, 0; 0.5, 0.5, 0.5 : 1, 1, 1"
    flow="-0.5*x-1.5*y; 1.5*x-0.5*y; z" force="0; -2; 0" elements="4, 4, 4"
  fi
  sides="left right bottom top"
  [ $1 = 2 ] || sides="$sides back front"
  cat >common.prm <<END
set Dimension = $1
set Bodies    = ball
subsection Time
  set End time = 0.01
  set Step     = 0.01
end
subsection Domain
  set Size   = $ones
  set Cells  = $twos
  set Levels = $((5 - $1))
end
subsection Fluid
  set Density             = 1
  set Kinematic viscosity = 0.5
end
subsection Body ball
  subsection Shape
    set Type     = disc
    set Radius   = 0.2
    set Elements = $elements
    set Position = $middle
  end
  subsection Region body
    set Young's modulus = 1
  end
end
subsection Coupling
  set Kernel                   = dirac
  set Accept unresolved bodies = true
end
subsection Output
  set Folder             = results
  set Interval of fields = 1
  set Existing results   = replace
  set Additional fields  = lambda_2, Q
  subsection Surfaces
    set Write = true
  end
  subsection Slices
    set Planes   = $planes
    set Interval = 0
  end
end
END
  cat >linear.prm <<END
include common.prm
subsection Fluid
  set Initial velocity = $flow
  set Inflow velocity  = $flow
  subsection Boundary conditions
$(for side in $sides; do echo "    set $side = inflow"; done)
  end
end
END
  cat >still.prm <<END
include common.prm
subsection Fluid
  set Body force = $force
end
END
}

cat >look.py <<'END'
"""What is in the files: look.py surface NUMBER | slices NUMBER | fluid NUMBER."""
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def read(name, number):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(f"results/fields/{name}-{number:05d}.vtu")
    reader.Update()
    grid = reader.GetOutput()
    data = grid.GetPointData()
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    corners = grid.GetCell(0).GetNumberOfPoints()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, corners)
    return points, cells, {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)).astype(float)
                           for k in range(data.GetNumberOfArrays())}


def get_sizes(points, cells):
    """Lengths, or areas of quadrilaterals."""
    p = [points[column] for column in cells.T]
    if len(p) == 2:
        return np.linalg.norm(p[1] - p[0], axis=1)
    return 0.5 * np.linalg.norm(np.cross(p[2] - p[0], p[3] - p[1]), axis=1)


def integrate(values, points, cells):
    return np.einsum("c,c...->...", get_sizes(points, cells), values[cells].mean(axis=1))


def show(values):
    return ", ".join(f"{value:.3f}" for value in np.ravel(values))


what, number, dim = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
if what == "surface":
    points, cells, data = read("surface_ball", number)
    centre = np.array([0.5, 0.5, 0.5 * (dim == 3)])
    arms = points - centre
    print("  surface", show(integrate(np.ones(len(points)), points, cells)),
          "data", *sorted(data), "speed", show(np.abs(data["velocity"]).max()))
    print("  mean traction", show(10 * integrate(data["traction"], points, cells)[:dim]),
          "moments", show(10 * integrate(np.einsum("ni,nj->nij", data["traction"], arms), points, cells)[:dim, :dim]))
else:
    a, w = 1., 1.5
    A = np.array([[-a / 2, -w, 0], [w, -a / 2 if dim == 3 else a / 2, 0], [0, 0, a * (dim == 3)]])
    names = ["fluid"] if what == "fluid" else [f"slice_{k}" for k in range(1, dim + 1)]
    for name in names:
        points, cells, data = read(name, number)
        error = np.abs(data["velocity"] - points @ A.T).max()
        vorticity = data["vorticity"] if dim == 2 else data["vorticity"][:, 2]
        print(f"  {name}", "" if what == "fluid" else "size " + show(integrate(np.ones(len(points)), points, cells)),
              f"velocity off by {error:.4f}", *(f"{key} {show([values.min(), values.max()])}" for key, values in
                                                (("vorticity", vorticity), ("Q", data["Q"]), ("lambda_2", data["lambda_2"]))))
END

for dimension in 2 3; do
  write_case $dimension
  for ranks in 1 2; do
    echo "* $dimension dimensions, $ranks ranks"
    mpirun -np $ranks "$CAUDAL" linear.prm >printed 2>&1 || cat printed
    for part in fluid slices surface; do
      /usr/bin/python3 look.py $part 0 $dimension
    done
    for distance in 0 1; do
      mpirun -np $ranks "$CAUDAL" still.prm -D "Output/Surfaces/Distance=$distance" >printed 2>&1 || cat printed
      /usr/bin/python3 look.py surface 1 $dimension
    done
  done
  sed -n 's/^<DataSet/  <DataSet/p' results/surfaces.pvd results/slices.pvd
  mpirun -np 2 "$CAUDAL" linear.prm -D "Output/Format=hdf5" >printed 2>&1 || cat printed
  for list in surfaces slices; do
    echo "  $list.xdmf: $(grep -c 'Grid Name="s[ul].*_' results/$list.xdmf) blocks"
  done
  ls results results/fields | grep -c "h5$" | sed 's/^/  files of HDF5: /'
done
