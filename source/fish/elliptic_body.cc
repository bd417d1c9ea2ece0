// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/elliptic_body.h>
#include <caudal/fish/graded_grid.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace caudal
{
  EllipticBody::EllipticBody(const double length)
      : length(length)
  {}

  double EllipticBody::get_end_factor(const double s, const double length)
  {
    return 2. * std::sqrt(std::max(0., s * (length - s))) / length;
  }

  Point<3> EllipticBody::place(const Point<3> &reference) const
  {
    const double s      = 0.5 * length * (1. + reference[0]);
    const auto [ga, gb] = get_scales(s);
    return Point<3>(s, ga * reference[1], gb * reference[2]);
  }

  double EllipticBody::half_width(const double s) const
  {
    return get_scales(s).first * get_end_factor(s, length);
  }

  std::vector<BodySlice> EllipticBody::compute_slices() const
  {
    const QIterated<1>     quadrature(QGauss<1>(3), 56);
    std::vector<BodySlice> slices;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      BodySlice slice;
      slice.s             = length * quadrature.point(q)[0];
      const auto [ga, gb] = get_scales(slice.s);
      const double a      = ga * get_end_factor(slice.s, length);
      const double b      = gb * get_end_factor(slice.s, length);
      const double volume = numbers::PI * a * b * length * quadrature.weight(q);
      slice.moments[0][0] = volume;
      slice.moments[1][1] = volume * a * a / 4.;
      slice.moments[2][2] = volume * b * b / 4.;
      slices.push_back(slice);
    }
    return slices;
  }

  namespace
  {
    /**
     * Where the point @p q of the square [-1,1]^(dim-1) of a section is in the unit disc (2D: the
     * interval); @p roundness 1 takes the square's edge to the circle, 0 keeps it straight.
     */
    template <int dim>
    Point<dim> place_in_section(const Point<dim> &q, const double roundness)
    {
      double         largest = 0., squares = 0.;
      Tensor<1, dim> direction;
      for (unsigned int d = 1; d < dim; ++d)
        largest = std::max(largest, std::abs(q[d]));
      if (largest == 0.)
        return Point<dim>();
      for (unsigned int d = 1; d < dim; ++d)
      {
        // Grid lines at equal angles
        direction[d] = std::tan(0.25 * numbers::PI * q[d] / largest);
        squares += direction[d] * direction[d];
      }
      Point<dim> place;
      for (unsigned int d = 1; d < dim; ++d)
        place[d] = (1. - roundness) * q[d] / std::sqrt(dim - 1.) +
                   roundness * largest * direction[d] / std::sqrt(squares);
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
    struct CubedBall
    {
      CubedBall(const std::vector<unsigned int> &core, const unsigned int n_layers)
          : core_share(1. - 2. * n_layers / (core[1] + 2. * n_layers))
          , end(1. / (core[0] + 2.))
      {}

      Point<dim> place_core(const Point<dim> &p) const
      {
        return place_in_ball((1. - 2. * end) * p[0],
                             Point<dim>(core_share * place_in_section(p, 0.5)));
      }

      /** For a point of the cube's surface that of the sphere. */
      Point<dim> place_on_sphere(const Point<dim> &p) const
      {
        double largest = 0.;
        for (unsigned int d = 1; d < dim; ++d)
          largest = std::max(largest, std::abs(p[d]));
        const Point<dim> section = place_in_section(p, 1.);
        const double     x       = (1. - end) * p[0];
        if (largest > 1. - 1e-9)
          return place_in_ball(x, section);
        Point<dim> place(std::sqrt(1. - x * x) * section); // on a round end
        place[0] = std::copysign(std::sqrt(1. - place.square()), p[0]);
        return place;
      }

      const double core_share; // of a section's width
      const double end;        // the length of a round end on the surface, half that of the core's
    };

    /**
     * The unit disc or ball as an image of a cube: a core of @p core elements in each direction,
     * from whose faces @p n_layers layers of elements reach to the circle or sphere. Its columns
     * along the first axis are normal to it, but for the layers at the two ends, so that it can be
     * stretched to a slender body.
     */
    template <int dim>
    void make_cubed_ball(Triangulation<dim> &tria, const std::vector<unsigned int> &core,
                         const unsigned int n_layers)
    {
      Triangulation<dim> cube;
      Point<dim>         corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = 1.;
      GridGenerator::subdivided_hyper_rectangle(cube, core, Point<dim>(-corner), corner);

      const CubedBall<dim>       ball(core, n_layers);
      std::vector<Point<dim>>    vertices;
      std::vector<CellData<dim>> cells;
      for (const Point<dim> &p : cube.get_vertices())
        vertices.push_back(ball.place_core(p));
      // The vertices of the layer k beyond the surface's vertex v.
      std::map<unsigned int, unsigned int> first;
      const auto get_vertex = [&](const unsigned int v, const unsigned int k) {
        if (k == 0)
          return v;
        const auto [entry, is_new] = first.insert({v, vertices.size()});
        if (is_new)
        {
          const Point<dim>     inner = vertices[v];
          const Tensor<1, dim> way   = ball.place_on_sphere(cube.get_vertices()[v]) - inner;
          for (unsigned int layer = 1; layer <= n_layers; ++layer)
            vertices.push_back(inner + static_cast<double>(layer) / n_layers * way);
        }
        return entry->second + k - 1;
      };
      for (const auto &cell : cube.active_cell_iterators())
      {
        cells.emplace_back();
        for (const unsigned int v : cell->vertex_indices())
          cells.back().vertices[v] = cell->vertex_index(v);
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            for (unsigned int k = 0; k < n_layers; ++k)
            {
              const unsigned int n = GeometryInfo<dim>::vertices_per_face;
              cells.emplace_back();
              for (unsigned int v = 0; v < n; ++v)
              {
                cells.back().vertices[v]     = get_vertex(cell->face(f)->vertex_index(v), k);
                cells.back().vertices[n + v] = get_vertex(cell->face(f)->vertex_index(v), k + 1);
              }
            }
      }
      GridTools::invert_cells_with_negative_measure(vertices, cells);
      GridTools::consistently_order_cells(cells);
      tria.create_triangulation(vertices, cells, SubCellData());
    }
  } // namespace

  template <int dim>
  void EllipticShape<dim>::check_divisions(const ShapeLengths &, const GridDivisions &divisions,
                                           const std::string &path) const
  {
    for (unsigned int d = 1; d < divisions.elements.size(); ++d)
      require(divisions.elements[d] >= 3, path, "Elements",
              "there are " + std::to_string(divisions.elements[d]) +
                  " elements across the body. Give at least three: a core and a layer round it.");
  }

  namespace
  {
    /** Length, largest width and, in 3D, largest height. */
    template <int dim>
    Tensor<1, dim> get_sides(const StraightBody &body)
    {
      Tensor<1, dim> sides;
      sides[0]             = body.get_length();
      const unsigned int n = 100;
      for (unsigned int i = 1; i < n; ++i)
        for (unsigned int d = 1; d < dim; ++d)
        {
          const double x = 2. * i / n - 1.;
          Point<3>     reference(x, 0., 0.);
          reference[d] = std::sqrt(1. - x * x);
          sides[d]     = std::max(sides[d], 2. * body.place(reference)[d]);
        }
      return sides;
    }

    /**
     * The outline of the half-widths of a body, as a fraction of its length. Its round tail is cut
     * off where it is @p cut thick, so that a column of elements ends in an edge, and the rest
     * stretched to the whole length.
     */
    class EllipticOutline : public Outline
    {
    public:
      EllipticOutline(const StraightBody &body, const double cut)
          : body(body)
          , end(find_zero(
                [&](const double s) {
                  return 2. * body.half_width(s * body.get_length()) / body.get_length() - cut;
                },
                0.5, 1.))
      {}

      double half_thickness(const double s) const override
      {
        return body.half_width(s * end * body.get_length()) / body.get_length();
      }

    private:
      const StraightBody &body;
      const double        end; // of the outline on the body
    };

    /**
     * The graded grid of a plane body of which the tail, and not the middle, is one element
     * across; false if it is not so, which leaves @p tria empty.
     */
    bool make_slender_grid(const StraightBody &body, const GridDivisions &divisions,
                           const std::string &path, Triangulation<2> &tria)
    {
      const double length = body.get_length(), size = divisions.spacing / length;
      const double tail = body.half_width((1. - size) * length);
      if (size > 0.1 || body.half_width(0.5 * length) < divisions.spacing ||
          2. * tail > 1.7 * divisions.spacing)
        return false;
      const double cut = std::min(0.4 * size, tail / length);
      make_graded_grid(EllipticOutline(body, cut), size, divisions.region_boundaries, path, tria);
      GridTools::scale(length, tria);
      return true;
    }

    /** The area of the outline of the half-widths [m^2]. */
    double compute_area(const StraightBody &body)
    {
      // Gauss points over the angle from nose to tail, where the round ends are smooth.
      const QIterated<1> quadrature(QGauss<1>(4), 50);
      const double       length = body.get_length();
      double             area   = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double angle = numbers::PI * quadrature.point(q)[0],
                     s     = 0.5 * length * (1. - std::cos(angle));
        area += 2. * body.half_width(s) * 0.5 * length * std::sin(angle) * numbers::PI *
                quadrature.weight(q);
      }
      return area;
    }

    /**
     * Gives a plane grid the length and the area of the outline. Its polygon has less area, and
     * with an odd number of elements across it ends in edges instead of points, which make it
     * shorter.
     */
    void fit_to_outline(Triangulation<2> &tria, const StraightBody &body)
    {
      const BoundingBox<2> box = GridTools::compute_bounding_box(tria);
      const double front = box.lower_bound(0), stretch = body.get_length() / box.side_length(0),
                   widen = compute_area(body) / (stretch * GridTools::volume(tria));
      GridTools::transform(
          [&](const Point<2> &p) { return Point<2>((p[0] - front) * stretch, widen * p[1]); },
          tria);
    }
  } // namespace

  template <int dim>
  void EllipticShape<dim>::make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                                     const std::string &path, Triangulation<dim> &tria) const
  {
    const auto body = this->make_straight_body(lengths);
    if constexpr (dim == 2)
      if (divisions.is_automatic() && make_slender_grid(*body, divisions, path, tria))
        return;
    std::vector<unsigned int> core = divisions.get_elements(get_sides<dim>(*body));
    for (unsigned int d = 1; d < dim; ++d)
      core[d] = std::max(3u, core[d]);
    const unsigned int n_layers = std::max(1u, *std::min_element(core.begin() + 1, core.end()) / 5);
    for (unsigned int d = 1; d < dim; ++d)
      core[d] -= 2 * n_layers;
    make_cubed_ball(tria, core, n_layers);
    GridTools::transform(
        [&body](const Point<dim> &reference) {
          Point<3> point;
          for (unsigned int d = 0; d < dim; ++d)
            point[d] = reference[d];
          point = body->place(point);
          Point<dim> result;
          for (unsigned int d = 0; d < dim; ++d)
            result[d] = point[d];
          return result;
        },
        tria);
    if constexpr (dim == 2)
      fit_to_outline(tria, *body);
    assign_regions(tria, divisions.region_boundaries);
  }

  template class EllipticShape<2>;
  template class EllipticShape<3>;
} // namespace caudal
