// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_generator.h>

namespace caudal
{
  namespace
  {
    /** A circular ring round the origin. */
    template <int dim>
    class RingShape : public Shape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Wall thickness", wall_thickness, "Outer minus inner radius [m].");
      }

      bool has_grid() const override
      {
        return dim == 2;
      }

      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        require_positive(lengths.radius, path, "Radius");
        require_positive(wall_thickness, path, "Ring/Wall thickness");
      }

      void check_divisions(const ShapeLengths &, const GridDivisions &divisions,
                           const std::string &path) const override
      {
        if (divisions.is_automatic())
          return;
        require(divisions.elements[0] >= 8, path, "Elements",
                "there are " + std::to_string(divisions.elements[0]) +
                    " elements round the ring. Give at least eight.");
      }

      void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                     const std::string &, Triangulation<dim>          &tria) const override
      {
        const double inner = lengths.radius, outer = inner + wall_thickness;
        if constexpr (dim == 2)
        {
          const auto elements =
              divisions.get_elements(Tensor<1, 2>({numbers::PI * (inner + outer), wall_thickness}));
          GridGenerator::concentric_hyper_shells(tria, Point<2>(), inner, outer, elements[1], 0.,
                                                 std::max(8u, elements[0]));
          scale_to_volume(tria, numbers::PI * (outer * outer - inner * inner));
        }
        assign_regions(tria, divisions.region_boundaries);
      }

    private:
      double wall_thickness = 0.05;
    };

    const DimensionalRegistration<Shape, RingShape> registration("ring", "a circular ring (2D)");
  } // namespace
} // namespace caudal
