// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace caudal
{
  namespace
  {
    /** An ellipse, or an ellipsoid, round the origin: 12 m^2 (2D) or 32 m^3 (3D) elements. */
    template <int dim>
    class EllipseShape : public Shape<dim>
    {
    public:
      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        lengths.check_sides<dim>(path);
      }

      void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                     const std::string &, Triangulation<dim>          &tria) const override
      {
        const Tensor<1, dim> axes     = get_axes(lengths);
        const auto          &elements = divisions.elements;
        const double         n_elements =
            std::accumulate(elements.begin(), elements.end(), 1., std::multiplies<double>());
        Triangulation<dim> coarse;
        GridGenerator::hyper_ball_balanced(coarse);
        const double m = std::pow(n_elements / coarse.n_active_cells(), 1. / dim);
        subdivide(coarse, std::max(1L, std::lround(m)), tria);
        GridTools::transform(
            [&](Point<dim> p) {
              for (unsigned int d = 0; d < dim; ++d)
                p[d] *= 0.5 * axes[d];
              return p;
            },
            tria);
        assign_regions(tria, divisions.region_boundaries);
      }

    private:
      virtual Tensor<1, dim> get_axes(const ShapeLengths &lengths) const
      {
        return lengths.get_sides<dim>();
      }
    };

    /** A disc, or a ball, round the origin. */
    template <int dim>
    class DiscShape : public EllipseShape<dim>
    {
    public:
      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        require_positive(lengths.radius, path, "Radius");
      }

    private:
      Tensor<1, dim> get_axes(const ShapeLengths &lengths) const override
      {
        Tensor<1, dim> axes;
        for (unsigned int d = 0; d < dim; ++d)
          axes[d] = 2. * lengths.radius;
        return axes;
      }
    };

    const DimensionalRegistration<Shape, EllipseShape>
        ellipse("ellipse", "an ellipse (3D: an ellipsoid) about its centre");
    const DimensionalRegistration<Shape, DiscShape> disc("disc", "a disc (3D: a ball)");
  } // namespace
} // namespace caudal
