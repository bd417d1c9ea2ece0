// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_plane_cut_h
#define caudal_observe_plane_cut_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** A plane through a point with a unit normal; in two dimensions a line. */
  template <int dim>
  struct Plane
  {
    Point<dim>     point;
    Tensor<1, dim> normal;

    double get_distance(const Point<dim> &place) const
    {
      return normal * (place - point);
    }
  };

  /**
   * The corners of a piece of a plane: of a quadrilateral, the corners in deal.II's order, the last
   * two being one where it is a triangle; in two dimensions the ends of a line.
   */
  template <int dim>
  using PlanePiece = std::array<Point<dim>, GeometryInfo<dim>::vertices_per_cell / 2>;

  /**
   * The pieces into which a plane cuts a box with one corner at @p lower and the sides @p size. A
   * plane on a face that two boxes share belongs to that below it, seen along the normal.
   */
  template <int dim>
  std::vector<PlanePiece<dim>> cut_box(const Plane<dim> &plane, const Point<dim> &lower,
                                       const Tensor<1, dim> &size);
} // namespace caudal

#endif
