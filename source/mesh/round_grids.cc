// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/round_grids.h>

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

  template <int dim>
  void make_ellipsoid(Triangulation<dim> &tria, const Tensor<1, dim> &semi_axes,
                      const double n_cells)
  {
    Triangulation<dim> coarse;
    GridGenerator::hyper_ball_balanced(coarse);
    const double m = std::pow(n_cells / coarse.n_active_cells(), 1. / dim);
    subdivide(coarse, std::max(1L, std::lround(m)), tria);
    GridTools::transform(
        [&](Point<dim> p) {
          for (unsigned int d = 0; d < dim; ++d)
            p[d] *= semi_axes[d];
          return p;
        },
        tria);
  }

  template void subdivide(const Triangulation<2> &, unsigned int, Triangulation<2> &);
  template void subdivide(const Triangulation<3> &, unsigned int, Triangulation<3> &);
  template void make_ellipsoid(Triangulation<2> &, const Tensor<1, 2> &, double);
  template void make_ellipsoid(Triangulation<3> &, const Tensor<1, 3> &, double);
} // namespace caudal
