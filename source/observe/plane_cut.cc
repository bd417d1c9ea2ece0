// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/plane_cut.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    const double round_off = 1e-9; // of a box's size

    /** Where the plane meets the edges of the box, in any order. */
    template <int dim>
    std::vector<Point<dim>> cut_edges(const Plane<dim> &plane, const Point<dim> &lower,
                                      const Tensor<1, dim> &size)
    {
      std::array<Point<dim>, GeometryInfo<dim>::vertices_per_cell> corners;
      std::array<double, GeometryInfo<dim>::vertices_per_cell>     distances;
      for (unsigned int v = 0; v < corners.size(); ++v)
      {
        for (unsigned int d = 0; d < dim; ++d)
          corners[v][d] = lower[d] + ((v >> d) & 1) * size[d];
        distances[v] = plane.get_distance(corners[v]);
        if (std::abs(distances[v]) < round_off * size.norm())
          distances[v] = 0;
      }
      std::vector<Point<dim>> points;
      for (unsigned int line = 0; line < GeometryInfo<dim>::lines_per_cell; ++line)
      {
        const unsigned int a = GeometryInfo<dim>::line_to_cell_vertices(line, 0);
        const unsigned int b = GeometryInfo<dim>::line_to_cell_vertices(line, 1);
        if ((distances[a] < 0) == (distances[b] < 0))
          continue;
        const double     share = distances[a] / (distances[a] - distances[b]);
        const Point<dim> point = corners[a] + share * (corners[b] - corners[a]);
        if (std::none_of(points.begin(), points.end(), [&](const Point<dim> &other) {
              return other.distance(point) < round_off * size.norm();
            }))
          points.push_back(point);
      }
      return points;
    }

    /** Orders the corners of a convex polygon with this normal round its middle. */
    template <int dim>
    void order_round_middle(std::vector<Point<dim>> &points, const Tensor<1, dim> &normal)
    {
      if constexpr (dim == 3)
      {
        Point<dim> middle;
        for (const Point<dim> &point : points)
          middle += point / static_cast<double>(points.size());
        const Tensor<1, dim> first = points[0] - middle, second = cross_product_3d(normal, first);
        const auto           angle = [&](const Point<dim> &point) {
          return std::atan2(second * (point - middle), first * (point - middle));
        };
        std::sort(points.begin(), points.end(),
                  [&](const auto &a, const auto &b) { return angle(a) < angle(b); });
      }
    }
  } // namespace

  template <int dim>
  std::vector<PlanePiece<dim>> cut_box(const Plane<dim> &plane, const Point<dim> &lower,
                                       const Tensor<1, dim> &size)
  {
    std::vector<Point<dim>> points = cut_edges(plane, lower, size);
    if (points.size() < dim) // at most a corner or an edge
      return {};
    order_round_middle(points, plane.normal);
    std::vector<PlanePiece<dim>> pieces;
    if constexpr (dim == 2)
      pieces.push_back({{points[0], points[1]}});
    else
      for (unsigned int k = 1; k + 1 < points.size(); k += 2)
        pieces.push_back(
            {{points[0], points[k], points[std::min<std::size_t>(k + 2, points.size() - 1)],
              points[k + 1]}});
    return pieces;
  }

  template std::vector<PlanePiece<2>> cut_box(const Plane<2> &, const Point<2> &,
                                              const Tensor<1, 2> &);
  template std::vector<PlanePiece<3>> cut_box(const Plane<3> &, const Point<3> &,
                                              const Tensor<1, 3> &);
} // namespace caudal
