// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/round_grids.h>
#include <caudal/mesh/shape.h>

namespace caudal
{
  namespace
  {
    /** A disc, or a ball, round the origin. */
    template <int dim>
    class DiscShape : public Shape<dim>
    {
    public:
      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        require_positive(lengths.radius, path, "Radius");
      }

      void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                     const std::string &, Triangulation<dim>          &tria) const override
      {
        Tensor<1, dim> semi_axes;
        for (unsigned int d = 0; d < dim; ++d)
          semi_axes[d] = lengths.radius;
        make_ellipsoid(tria, semi_axes, divisions.count_elements());
        assign_regions(tria, divisions.region_boundaries);
      }
    };

    const DimensionalRegistration<Shape, DiscShape> registration("disc", "a disc (3D: a ball)");
  } // namespace
} // namespace caudal
