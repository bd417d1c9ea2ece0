// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/mesh_body.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace caudal::ideal
{
  MeshBody::MeshBody(const Surface &surface)
      : surface(surface)
      , nose(std::numeric_limits<double>::max())
      , tail(-nose)
  {
    for (const Point<3> &point : surface.get_reference_points())
    {
      nose = std::min(nose, point[0]);
      tail = std::max(tail, point[0]);
    }
  }

  double MeshBody::half_width(const double s) const
  {
    double width = 0.;
    for (const Point<3> &point : surface.get_reference_points())
      if (std::abs(point[0] - nose - s) < 0.05 * get_length())
        width = std::max(width, std::abs(point[1]));
    return width;
  }

  std::vector<BodySlice> MeshBody::compute_slices() const
  {
    FEValues<2, 3>         at(surface.get_fe(), QGauss<2>(3),
                              update_quadrature_points | update_normal_vectors | update_JxW_values);
    std::vector<BodySlice> slices;
    for (const auto &cell : surface.get_dof_handler().active_cell_iterators())
    {
      at.reinit(cell);
      for (const unsigned int q : at.quadrature_point_indices())
      {
        const Point<3> point = place(at.quadrature_point(q));
        const double   y = point[1], z = point[2], N = at.JxW(q) * at.normal_vector(q)[1];
        BodySlice      slice;
        slice.s             = point[0];
        slice.moments[0][0] = N * y;
        slice.moments[0][1] = N * y * y / 2.;
        slice.moments[0][2] = N * y * z;
        slice.moments[1][1] = N * y * y * y / 3.;
        slice.moments[1][2] = N * y * y * z / 2.;
        slice.moments[2][2] = N * y * z * z;
        slices.push_back(slice);
      }
    }
    return slices;
  }
} // namespace caudal::ideal
