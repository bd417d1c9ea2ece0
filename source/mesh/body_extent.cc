// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/body_grid.h>

#include <deal.II/base/tensor.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <limits>

namespace caudal
{
  namespace
  {
    /** A straight piece of the body's boundary: a line (2D) or a triangle (3D). */
    template <int dim>
    using Facet = std::array<Point<dim>, dim>;

    template <int dim>
    struct BoundaryFace
    {
      Point<dim>              centre;
      Tensor<1, dim>          inward_normal;
      unsigned int            region;
      double                  area;
      double                  cell_volume;
      std::vector<Facet<dim>> facets;
    };

    template <int dim>
    BoundaryFace<dim>
    make_boundary_face(const typename Triangulation<dim>::active_cell_iterator &cell,
                       const unsigned int                                       f)
    {
      const auto        face = cell->face(f);
      BoundaryFace<dim> result;
      result.centre      = face->center();
      result.region      = cell->material_id();
      result.area        = face->measure();
      result.cell_volume = cell->measure();
      if constexpr (dim == 2)
      {
        result.inward_normal = cross_product_2d(face->vertex(1) - face->vertex(0));
        result.facets        = {{{face->vertex(0), face->vertex(1)}}};
      }
      else
      {
        result.inward_normal =
            cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1));
        result.facets = {{{face->vertex(0), face->vertex(1), face->vertex(2)}},
                         {{face->vertex(3), face->vertex(1), face->vertex(2)}}};
      }
      result.inward_normal /= result.inward_normal.norm();
      if (result.inward_normal * (cell->center() - result.centre) < 0.)
        result.inward_normal *= -1.;
      return result;
    }

    /** The distance from @p origin along @p direction to the facet; infinite if it is missed. */
    template <int dim>
    double compute_distance(const Point<dim> &origin, const Tensor<1, dim> &direction,
                            const Facet<dim> &facet)
    {
      const double miss = std::numeric_limits<double>::infinity();

      // origin + t direction = facet[0] + sum_i a_i (facet[i] - facet[0])
      Tensor<2, dim> matrix;
      for (unsigned int row = 0; row < dim; ++row)
      {
        matrix[row][0] = direction[row];
        for (unsigned int i = 1; i < dim; ++i)
          matrix[row][i] = facet[0][row] - facet[i][row];
      }
      if (determinant(matrix) == 0.)
        return miss;

      const Tensor<1, dim> solution  = invert(matrix) * (facet[0] - origin);
      const double         tolerance = 1e-10;
      double               sum       = 0.;
      for (unsigned int i = 1; i < dim; ++i)
      {
        if (solution[i] < -tolerance)
          return miss;
        sum += solution[i];
      }
      return solution[0] > 0. && sum < 1. + tolerance ? solution[0] : miss;
    }

    /** Whether the facet reaches as far as the line along y through the point, in each direction.
     */
    template <int dim>
    bool may_meet_lateral_line(const Facet<dim> &facet, const Point<dim> &point)
    {
      for (unsigned int d = 0; d < dim; ++d)
      {
        double low = facet[0][d], high = facet[0][d];
        for (const Point<dim> &vertex : facet)
        {
          low  = std::min(low, vertex[d]);
          high = std::max(high, vertex[d]);
        }
        const double tolerance = 1e-9 * (1. + std::abs(high - low));
        if (d != 1 && (point[d] < low - tolerance || point[d] > high + tolerance))
          return false;
      }
      return true;
    }

    template <int dim>
    std::vector<BoundaryFace<dim>> collect_boundary(const Triangulation<dim> &tria)
    {
      std::vector<BoundaryFace<dim>> faces;
      for (const auto &cell : tria.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            faces.push_back(make_boundary_face<dim>(cell, f));
      return faces;
    }
  } // namespace

  template <int dim>
  BodyExtent<dim> compute_extent(const Triangulation<dim> &tria)
  {
    const auto      faces = collect_boundary<dim>(tria);
    BodyExtent<dim> extent;
    extent.length = GridTools::compute_bounding_box(tria).side_length(0);
    for (const BoundaryFace<dim> &face : faces)
    {
      double distance = std::numeric_limits<double>::infinity();
      for (const BoundaryFace<dim> &other : faces)
        if (face.inward_normal * other.inward_normal < 0.)
          for (const Facet<dim> &facet : other.facets)
            distance =
                std::min(distance, compute_distance<dim>(face.centre, face.inward_normal, facet));
      extent.faces.push_back({distance, face.cell_volume / face.area, face.centre,
                              face.inward_normal, face.area, face.region});
    }
    return extent;
  }

  template <int dim>
  std::vector<std::pair<double, double>> compute_lateral_ends(const Triangulation<dim>      &tria,
                                                              const std::vector<Point<dim>> &points)
  {
    const auto   faces    = collect_boundary<dim>(tria);
    const double infinity = std::numeric_limits<double>::infinity();
    // From outside, so that points on the surface find it, too.
    const BoundingBox<dim>                 box   = GridTools::compute_bounding_box(tria);
    const double                           start = box.lower_bound(1) - box.side_length(1);
    std::vector<std::pair<double, double>> ends;
    for (const Point<dim> &point : points)
    {
      double     low = infinity, high = -infinity;
      Point<dim> outside = point;
      outside[1]         = start;
      for (const BoundaryFace<dim> &face : faces)
        for (const Facet<dim> &facet : face.facets)
        {
          if (!may_meet_lateral_line<dim>(facet, point))
            continue;
          const double distance = compute_distance<dim>(outside, Point<dim>::unit_vector(1), facet);
          if (distance < infinity)
          {
            low  = std::min(low, start + distance);
            high = std::max(high, start + distance);
          }
        }
      ends.emplace_back(std::min(low, point[1]), std::max(high, point[1]));
    }
    return ends;
  }

  template <int dim>
  double compute_min_scaled_jacobian(const Triangulation<dim> &tria)
  {
    double minimum = std::numeric_limits<double>::max();
    for (const auto &cell : tria.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
      {
        // In lexicographic numbering, bit d of a vertex's number is its d-th
        // coordinate in the unit cell.
        Tensor<2, dim> edges;
        double         product = 1.;
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int low = v & ~(1u << d), high = v | (1u << d);
          edges[d] = cell->vertex(high) - cell->vertex(low);
          product *= edges[d].norm();
        }
        minimum = std::min(minimum, product > 0. ? determinant(edges) / product : 0.);
      }
    return minimum;
  }

  template BodyExtent<2> compute_extent(const Triangulation<2> &);
  template BodyExtent<3> compute_extent(const Triangulation<3> &);

  template std::vector<std::pair<double, double>>
  compute_lateral_ends(const Triangulation<2> &, const std::vector<Point<2>> &);
  template std::vector<std::pair<double, double>>
  compute_lateral_ends(const Triangulation<3> &, const std::vector<Point<3>> &);

  template double compute_min_scaled_jacobian(const Triangulation<2> &);
  template double compute_min_scaled_jacobian(const Triangulation<3> &);
} // namespace caudal
