// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/cubed_ball.h>

#include <deal.II/base/tensor.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace caudal
{
  namespace
  {
    /** Angles, in a section, from its first axis (y) to the corners of a square's image [rad]. */
    constexpr double diagonal = 0.25 * numbers::PI;

    /** The angle of the corners for which all edges of the section's circle are equal. */
    double get_even_angle(const std::vector<unsigned int> &core)
    {
      return core.size() < 3 ? diagonal : 0.5 * numbers::PI * core[2] / (core[1] + core[2]);
    }

    /**
     * Where the point @p q of the square [-1,1]^(dim-1) of a section is in the unit disc (2D: the
     * interval), whose corners go to the angle @p corner; @p roundness 1 takes the square's edge
     * to the circle, 0 keeps it straight.
     */
    template <int dim>
    Point<dim> place_in_section(const Point<dim> &q, const double roundness, const double corner)
    {
      unsigned int largest = 1;
      for (unsigned int d = 2; d < dim; ++d)
        if (std::abs(q[d]) > std::abs(q[largest]))
          largest = d;
      const double radius = std::abs(q[largest]);
      if (radius == 0.)
        return Point<dim>();
      // Grid lines at equal angles
      const double   reach = largest == 1 ? corner : 0.5 * numbers::PI - corner;
      Tensor<1, dim> direction;
      for (unsigned int d = 1; d < dim; ++d)
        direction[d] = d == largest ? q[d] / radius : std::tan(reach * q[d] / radius);
      direction /= direction.norm();
      Point<dim> place;
      for (unsigned int d = 1; d < dim; ++d)
      {
        const double edge = dim == 2 ? 1. : d == 1 ? std::cos(corner) : std::sin(corner);
        place[d]          = (1. - roundness) * edge * q[d] + roundness * radius * direction[d];
      }
      return place;
    }

    /** The point of the unit ball at @p x along the axis and @p section times the radius there. */
    template <int dim>
    Point<dim> place_in_ball(const double x, const Point<dim> &section)
    {
      Point<dim> place(std::sqrt(1. - x * x) * section);
      place[0] = x;
      return place;
    }

    /** Where the cubed ball has the points of the cube that its core is made from. */
    template <int dim>
    class CubedBall
    {
    public:
      explicit CubedBall(const CubedBallDivisions &divisions)
          : divisions(divisions)
          , nose(divisions.n_tail == 0 ? End{0.5, 0.5} : End{0.75, 0.25})
          , column(2. / (divisions.core[0] + divisions.n_tail + 2.))
          , core_corner(0.5 * (diagonal + get_even_angle(divisions.core)))
          , tail_corner(get_even_angle(divisions.core))
      {}

      Point<dim> place_core(const Point<dim> &p) const
      {
        Point<dim> section = place_in_section(p, dim == 2 ? 0.5 : 0.8, core_corner);
        for (unsigned int d = 1; d < dim; ++d)
          section[d] *=
              1. - 2. * divisions.n_layers / (divisions.core[d] + 2. * divisions.n_layers);
        return place_in_ball(get_core_x(p[0]), section);
      }

      /** For a point of the cube's surface that of the sphere, or of the front of the tail. */
      Point<dim> place_on_sphere(const Point<dim> &p) const
      {
        const double lean    = column * (p[0] < 0. ? nose.cap : 0.5);
        const double x       = get_core_x(p[0]) + lean * p[0];
        Point<dim>   place   = place_in_ball(x, place_in_section(p, 1., core_corner));
        double       largest = 0.;
        for (unsigned int d = 1; d < dim; ++d)
          largest = std::max(largest, std::abs(p[d]));
        const bool on_round_end = largest < 1. - 1e-9 && (p[0] < 0. || divisions.n_tail == 0);
        if (on_round_end)
        {
          place[0] = 0.;
          place[0] = std::copysign(std::sqrt(1. - place.square()), p[0]);
        }
        return place;
      }

      /** For a point of the cube's end that of the section at the end of a tail's column. */
      Point<dim> place_in_tail(const Point<dim> &p, const unsigned int i) const
      {
        const double share  = std::min(1., (i + 1.) / std::min(4u, divisions.n_tail));
        const double corner = core_corner + share * (tail_corner - core_corner);
        return place_in_ball(1. + (i + 0.5 - divisions.n_tail) * column,
                             place_in_section(p, 1., corner));
      }

    private:
      double get_core_x(const double p) const
      {
        return -1. + column * (1. + 0.5 * (p + 1.) * divisions.core[0]);
      }

      /** Lengths on the axis at an end, in columns: together one. */
      struct End
      {
        double cut; // beyond the surface's last edges
        double cap; // of the layers between these and the core
      };

      const CubedBallDivisions &divisions;
      const End                 nose;   // the tail's are equal
      const double              column; // length of a column of elements
      const double              core_corner, tail_corner;
    };

    /** The grid as lists of vertices and cells. */
    template <int dim>
    class CubedBallGrid
    {
    public:
      explicit CubedBallGrid(const CubedBallDivisions &divisions)
          : divisions(divisions)
          , ball(divisions)
      {
        Point<dim> corner;
        for (unsigned int d = 0; d < dim; ++d)
          corner[d] = 1.;
        GridGenerator::subdivided_hyper_rectangle(cube, divisions.core, Point<dim>(-corner),
                                                  corner);
        for (const Point<dim> &p : cube.get_vertices())
          vertices.push_back(ball.place_core(p));
        for (const auto &cell : cube.active_cell_iterators())
        {
          cells.emplace_back();
          for (const unsigned int v : cell->vertex_indices())
            cells.back().vertices[v] = cell->vertex_index(v);
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f))
              add_columns_on(cell->face(f), f == 1);
        }
      }

      std::vector<Point<dim>>    vertices;
      std::vector<CellData<dim>> cells;

    private:
      using Face = typename Triangulation<dim>::face_iterator;

      /** The layers on a face of the core, and the tail behind its end. */
      void add_columns_on(const Face &face, const bool is_end)
      {
        const unsigned int n       = GeometryInfo<dim>::vertices_per_face;
        const unsigned int n_cells = divisions.n_layers + (is_end ? divisions.n_tail : 0);
        for (unsigned int k = 0; k < n_cells; ++k)
        {
          cells.emplace_back();
          for (unsigned int v = 0; v < n; ++v)
          {
            cells.back().vertices[v]     = get_vertex(face->vertex_index(v), k);
            cells.back().vertices[n + v] = get_vertex(face->vertex_index(v), k + 1);
          }
        }
      }

      /** The @p k th vertex on the way from the core's vertex @p v out, or into the tail. */
      unsigned int get_vertex(const unsigned int v, const unsigned int k)
      {
        if (k == 0)
          return v;
        if (k <= divisions.n_layers)
        {
          const auto [entry, is_new] = first_in_layers.insert({v, vertices.size()});
          if (is_new)
          {
            const Point<dim>     inner = vertices[v];
            const Tensor<1, dim> way   = ball.place_on_sphere(cube.get_vertices()[v]) - inner;
            for (unsigned int layer = 1; layer <= divisions.n_layers; ++layer)
              vertices.push_back(inner + static_cast<double>(layer) / divisions.n_layers * way);
          }
          return entry->second + k - 1;
        }
        const auto [entry, is_new] = first_in_tail.insert({v, vertices.size()});
        if (is_new)
          for (unsigned int i = 0; i < divisions.n_tail; ++i)
            vertices.push_back(ball.place_in_tail(cube.get_vertices()[v], i));
        return entry->second + k - divisions.n_layers - 1;
      }

      const CubedBallDivisions            &divisions;
      const CubedBall<dim>                 ball;
      Triangulation<dim>                   cube; // of the core
      std::map<unsigned int, unsigned int> first_in_layers, first_in_tail;
    };
  } // namespace

  template <int dim>
  void make_cubed_ball(Triangulation<dim> &tria, const CubedBallDivisions &divisions)
  {
    CubedBallGrid<dim> grid(divisions);
    GridTools::invert_cells_with_negative_measure(grid.vertices, grid.cells);
    GridTools::consistently_order_cells(grid.cells);
    tria.create_triangulation(grid.vertices, grid.cells, SubCellData());
  }

  template void make_cubed_ball(Triangulation<2> &, const CubedBallDivisions &);
  template void make_cubed_ball(Triangulation<3> &, const CubedBallDivisions &);
} // namespace caudal
