#include <caudal/mesh/cylinder_with_flag.h>

#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  template <int dim>
  void subdivide(const Triangulation<dim> &coarse, const unsigned int n, Triangulation<dim> &tria)
  {
    Triangulation<dim> pattern;
    GridGenerator::subdivided_hyper_cube(pattern, n);

    // Degree 8 meets a circle of eight arcs to 1e-9.
    const MappingQ<dim>        mapping(8);
    std::vector<Point<dim>>    vertices;
    std::vector<CellData<dim>> cells;
    for (const auto &coarse_cell : coarse.active_cell_iterators())
    {
      const unsigned int first = vertices.size();
      for (const Point<dim> &unit_point : pattern.get_vertices())
        vertices.push_back(mapping.transform_unit_to_real_cell(coarse_cell, unit_point));
      for (const auto &cell : pattern.active_cell_iterators())
      {
        cells.emplace_back();
        for (const unsigned int v : cell->vertex_indices())
          cells.back().vertices[v] = first + cell->vertex_index(v);
      }
    }
    SubCellData               no_faces;
    std::vector<unsigned int> all_vertices;
    GridTools::delete_duplicated_vertices(vertices, cells, no_faces, all_vertices, 1e-8);
    tria.create_triangulation(vertices, cells, no_faces);
  }

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
  } // namespace

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

  template void subdivide<2>(const Triangulation<2> &, unsigned int, Triangulation<2> &);
  template void subdivide<3>(const Triangulation<3> &, unsigned int, Triangulation<3> &);
} // namespace caudal
