// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/interior.h>

#include <deal.II/numerics/rtree.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    std::vector<Point<dim>> get_surface_vertices(const Triangulation<dim> &triangulation)
    {
      std::vector<Point<dim>> vertices;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (unsigned int v = 0; v < face->n_vertices(); ++v)
              vertices.push_back(face->vertex(v));
      return vertices;
    }
  } // namespace

  template <int dim>
  std::vector<bool> find_interior(const SolidBody<dim> &body, const double depth)
  {
    namespace index                             = boost::geometry::index;
    const Triangulation<dim>     &triangulation = body.get_triangulation();
    const std::vector<Point<dim>> surface       = get_surface_vertices(triangulation);
    const auto                    tree          = pack_rtree(surface);
    std::vector<bool>             interior;
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      bool is_deep = true;
      for (const unsigned int v : cell->vertex_indices())
        for (const Point<dim> &nearest :
             tree | index::adaptors::queried(index::nearest(cell->vertex(v), 1)))
          is_deep = is_deep && nearest.distance(cell->vertex(v)) > depth;
      interior.push_back(is_deep);
    }
    return interior;
  }

  template std::vector<bool> find_interior(const SolidBody<2> &, double);
  template std::vector<bool> find_interior(const SolidBody<3> &, double);
} // namespace caudal
