// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_generator.h>

namespace caudal
{
  namespace
  {
    /** A rectangle, or a box, along the axis. */
    template <int dim>
    class BoxShape : public Shape<dim>
    {
    public:
      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        lengths.check_sides<dim>(path);
      }

      void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                     const std::string &, Triangulation<dim>          &tria) const override
      {
        const Tensor<1, dim>             sides    = lengths.get_sides<dim>();
        const std::vector<unsigned int>  elements = divisions.get_elements(sides);
        std::vector<std::vector<double>> steps(dim);
        for (const double step : divisions.compute_steps_along(elements[0]))
          steps[0].push_back(sides[0] * step);

        Point<dim> lower, upper;
        lower[0] = -get_origin() * sides[0];
        upper[0] = lower[0] + sides[0];
        for (unsigned int d = 1; d < dim; ++d)
        {
          steps[d].assign(elements[d], sides[d] / elements[d]);
          lower[d] = -0.5 * sides[d];
          upper[d] = 0.5 * sides[d];
        }
        GridGenerator::subdivided_hyper_rectangle(tria, steps, lower, upper);
        assign_regions(tria, divisions.region_boundaries);
      }

    private:
      /** The origin's place along the length, as a fraction. */
      virtual double get_origin() const
      {
        return 0.;
      }
    };

    /** A box about its centre. */
    template <int dim>
    class RectangleShape : public BoxShape<dim>
    {
      double get_origin() const override
      {
        return 0.5;
      }
    };

    const DimensionalRegistration<Shape, BoxShape>
        beam("beam", "a rectangle (3D: a box) whose origin is the middle of its root");
    const DimensionalRegistration<Shape, RectangleShape>
        rectangle("rectangle", "a rectangle (3D: a box) about its centre");
  } // namespace
} // namespace caudal
