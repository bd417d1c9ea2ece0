// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/round_grids.h>
#include <caudal/mesh/shape.h>

namespace caudal
{
  namespace
  {
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
        make_ellipsoid(tria, 0.5 * lengths.get_sides<dim>(), divisions.count_elements());
        assign_regions(tria, divisions.region_boundaries);
      }
    };

    const DimensionalRegistration<Shape, EllipseShape>
        registration("ellipse", "an ellipse (3D: an ellipsoid) about its centre");
  } // namespace
} // namespace caudal
