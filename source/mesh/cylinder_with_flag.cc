// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** The point of the segment y >= @p a of the unit circle for a point of the half disc. */
    Point<2> map_to_segment(const Point<2> &p, const double a)
    {
      const double radius = p.norm();
      if (radius == 0.)
        return Point<2>(0., a);
      const double smallest = std::asin(a);
      const double angle = smallest + (1. - 2. * smallest / numbers::PI) * std::atan2(p[1], p[0]);
      return Point<2>(radius * std::cos(angle), a + radius * (std::sin(angle) - a));
    }

    /** The half disc y >= 0 of unit radius: 4 n^2 cells. */
    void make_half_disc(Triangulation<2> &tria, const unsigned int n)
    {
      Triangulation<2> coarse;
      GridGenerator::half_hyper_ball(coarse);
      subdivide(coarse, n, tria);
      GridTools::rotate(0.5 * numbers::PI, tria);
    }

    /** The x of the vertices on the half disc's straight side, increasing. */
    std::vector<double> get_stations(const Triangulation<2> &half_disc)
    {
      std::vector<double> stations;
      for (const Point<2> &vertex : half_disc.get_vertices())
        if (std::abs(vertex[1]) < 1e-8)
          stations.push_back(vertex[0]);
      std::sort(stations.begin(), stations.end());
      return stations;
    }

    /**
     * The strip |y| <= @p a of the unit circle and the flag behind it, with
     * columns at @p stations in the circle and @p n_along more up to x = @p end.
     */
    void make_strip(Triangulation<2> &tria, const double a, const double end,
                    const std::vector<double> &stations, const unsigned int n_along,
                    const unsigned int n_across)
    {
      const unsigned int n_inside = stations.size() - 1;
      GridGenerator::subdivided_hyper_rectangle(tria, {n_inside + n_along, n_across},
                                                Point<2>(0., -a), Point<2>(n_inside + n_along, a));
      for (const auto &cell : tria.active_cell_iterators())
        cell->set_material_id(cell->center()[0] < n_inside ? 0 : 1);
      GridTools::transform(
          [&](const Point<2> &p) {
            const unsigned int column = std::lround(p[0]);
            const double       arc    = std::sqrt(1. - p[1] * p[1]);
            if (column > n_inside)
              return Point<2>(arc + (end - arc) * (column - n_inside) / n_along, p[1]);
            return Point<2>(stations[column] * arc, p[1]);
          },
          tria);
    }

    /**
     * A cylinder round the origin with a flag that ends at x = @p radius + @p length
     * and is @p thickness thick [m]. The flag has @p n_along times @p n_across
     * cells; it goes on through the cylinder as a strip of as many layers, on
     * which the rest of the cylinder rests as two segments. Material ids: 0 in
     * the cylinder, 1 in the flag.
     */
    void make_cylinder_with_flag(Triangulation<2> &tria, const double radius, const double length,
                                 const double thickness, const unsigned int n_along,
                                 const unsigned int n_across)
    {
      // In units of the radius. A half disc has three cells of the coarse grid along its side.
      const double     a = 0.5 * thickness / radius;
      const double     n = 2. / 3. / (2. * a / n_across);
      Triangulation<2> strip, upper, lower;
      make_half_disc(upper, std::max(2L, std::lround(n)));
      make_strip(strip, a, 1. + length / radius, get_stations(upper), n_along, n_across);
      GridTools::transform([a](const Point<2> &p) { return map_to_segment(p, a); }, upper);
      lower.copy_triangulation(upper);
      GridTools::rotate(numbers::PI, lower);
      GridGenerator::merge_triangulations({&strip, &upper, &lower}, tria, 1e-7);
      GridTools::scale(radius, tria);
    }

    /** The body of Turek and Hron's benchmark (2006, doi:10.1007/3-540-34596-5_15). */
    template <int dim>
    class CylinderWithFlag : public Shape<dim>
    {
    public:
      bool has_grid() const override
      {
        return dim == 2;
      }

      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        require_positive(lengths.radius, path, "Radius");
        require_positive(lengths.length, path, "Length");
        require_positive(lengths.thickness, path, "Thickness");
        require(lengths.thickness < lengths.radius, path, "Thickness",
                "the flag is thicker than the cylinder's radius. Give a thinner flag or a larger "
                "Shape/Radius.");
      }

      std::string get_region_entry() const override
      {
        return "Type";
      }

      void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                     const std::string &, Triangulation<dim>          &tria) const override
      {
        const Tensor<1, 2> flag({lengths.length, lengths.thickness});
        const auto         elements = divisions.get_elements(flag);
        if constexpr (dim == 2)
          make_cylinder_with_flag(tria, lengths.radius, lengths.length, lengths.thickness,
                                  elements[0], elements[1]);
      }
    };

    const DimensionalRegistration<Shape, CylinderWithFlag>
        registration("cylinder with flag", "Turek and Hron's (2D), with the regions cylinder and "
                                           "flag");
  } // namespace
} // namespace caudal
