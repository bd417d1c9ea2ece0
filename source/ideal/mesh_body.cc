// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/mesh_body.h>
#include <caudal/ideal/surface_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

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

  double MeshBody::get_length() const
  {
    return tail - nose;
  }

  Point<3> MeshBody::place(const Point<3> &reference) const
  {
    return Point<3>(reference[0] - nose, reference[1], reference[2]);
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
    const ReferenceRule    rule(QGauss<2>(3), surface.get_fe());
    std::vector<BodySlice> slices;
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      CellArray<Point<3>> nodes;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        nodes[k] = place(surface.get_reference_points()[surface.get_nodes(cell)[k]]);
      const PlacedRule at(rule, nodes);
      for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double y = at.points[q][1], z = at.points[q][2], N = at.areas[q][1];
        BodySlice    slice;
        slice.s             = at.points[q][0];
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

  bool MeshBody::is_symmetric() const
  {
    return false; // not known
  }
} // namespace caudal::ideal
