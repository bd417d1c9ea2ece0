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
    /** The unit disc or ball of 12 m^2 or 32 m^3 elements. */
    template <int dim>
    void make_ball(Triangulation<dim> &tria, const unsigned int m)
    {
      Triangulation<dim> coarse;
      GridGenerator::hyper_ball_balanced(coarse);
      subdivide(coarse, m, tria);
    }

    /** An ellipse, or an ellipsoid, round the origin. */
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
        const Tensor<1, dim> axes = get_axes(lengths);
        make_ball(tria, count_subdivisions(axes, divisions));
        GridTools::transform(
            [&](Point<dim> p) {
              for (unsigned int d = 0; d < dim; ++d)
                p[d] *= 0.5 * axes[d];
              return p;
            },
            tria);
        double volume = dim == 2 ? numbers::PI : 4. / 3. * numbers::PI;
        for (unsigned int d = 0; d < dim; ++d)
          volume *= 0.5 * axes[d];
        scale_to_volume(tria, volume);
        assign_regions(tria, divisions.region_boundaries);
      }

    private:
      /** m of make_ball() */
      static unsigned int count_subdivisions(const Tensor<1, dim> &axes,
                                             const GridDivisions  &divisions)
      {
        double m;
        if (divisions.is_automatic())
        {
          double mean_radius = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            mean_radius *= std::pow(0.5 * axes[d], 1. / dim);
          // The outermost layer of the unit ball is so high (measured for m from 4 to 16).
          const double height_times_m = dim == 2 ? 0.43 : 0.40;
          m                           = height_times_m * mean_radius / divisions.spacing;
        }
        else
        {
          const auto &elements = divisions.elements;
          m = std::accumulate(elements.begin(), elements.end(), 1., std::multiplies<double>());
          m = std::pow(m / (dim == 2 ? 12 : 32), 1. / dim);
        }
        return std::max(1L, std::lround(m));
      }

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
