#include <caudal/fish/elliptic_body.h>

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

  double EllipticBody::get_length() const
  {
    return length;
  }

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
    const unsigned int     n_slices = 56;
    const QGauss<1>        gauss(3);
    std::vector<BodySlice> slices;
    for (unsigned int i = 0; i < n_slices; ++i)
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        BodySlice slice;
        slice.s             = length * (i + gauss.point(q)[0]) / n_slices;
        const auto [ga, gb] = get_scales(slice.s);
        const double a      = ga * get_end_factor(slice.s, length);
        const double b      = gb * get_end_factor(slice.s, length);
        const double volume = numbers::PI * a * b * length / n_slices * gauss.weight(q);
        slice.moments[0][0] = volume;
        slice.moments[1][1] = volume * a * a / 4.;
        slice.moments[2][2] = volume * b * b / 4.;
        slices.push_back(slice);
      }
    return slices;
  }

  bool EllipticBody::is_symmetric() const
  {
    return true;
  }

  namespace
  {
    unsigned int get_n_layers(const GridDivisions &divisions)
    {
      return std::max(
          1u, *std::min_element(divisions.elements.begin() + 1, divisions.elements.end()) / 5);
    }

    /** From the cube [-1,1]^dim's surface to the unit sphere, grid lines at equal angles. */
    template <int dim>
    Point<dim> project_to_sphere(const Point<dim> &p)
    {
      Tensor<1, dim> direction;
      for (unsigned int d = 0; d < dim; ++d)
        direction[d] = std::tan(0.25 * numbers::PI * p[d]);
      return Point<dim>(direction / direction.norm());
    }

    /** Where the core of a cubed ball has the point @p p of the cube [-size,size]^dim. */
    template <int dim>
    Point<dim> place_in_core(const Point<dim> &p, const double size)
    {
      // Half-way between a cube and a ball: the core's edges stay well below 180 degrees.
      double largest = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max(largest, std::abs(p[d]));
      if (largest == 0.)
        return p;
      const Point<dim> on_surface(p / largest);
      return Point<dim>(largest * size *
                        (0.5 / std::sqrt(dim) * on_surface + 0.5 * project_to_sphere(on_surface)));
    }
  } // namespace

  template <int dim>
  void make_cubed_ball(Triangulation<dim> &tria, const std::vector<unsigned int> &core,
                       const unsigned int n_layers)
  {
    Triangulation<dim> cube;
    Point<dim>         corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = 1.;
    GridGenerator::subdivided_hyper_rectangle(cube, core, Point<dim>(-corner), corner);

    const double               core_size = 1. - 2. * n_layers / (core[1] + 2. * n_layers);
    std::vector<Point<dim>>    vertices;
    std::vector<CellData<dim>> cells;
    for (const Point<dim> &p : cube.get_vertices())
      vertices.push_back(place_in_core(p, core_size));
    // The vertices of the layer k beyond the surface's vertex v.
    std::map<unsigned int, unsigned int> first;
    const auto get_vertex = [&](const unsigned int v, const unsigned int k) {
      if (k == 0)
        return v;
      const auto [entry, is_new] = first.insert({v, vertices.size()});
      if (is_new)
        for (unsigned int layer = 1; layer <= n_layers; ++layer)
          vertices.push_back(vertices[v] +
                             static_cast<double>(layer) / n_layers *
                                 (project_to_sphere(cube.get_vertices()[v]) - vertices[v]));
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

  template <int dim>
  bool EllipticShape<dim>::has_surface() const
  {
    return true;
  }

  template <int dim>
  void EllipticShape<dim>::check_divisions(const ShapeLengths &, const GridDivisions &divisions,
                                           const std::string &path) const
  {
    for (unsigned int d = 1; d < dim; ++d)
      require(divisions.elements[d] >= 3, path, "Elements",
              "there are " + std::to_string(divisions.elements[d]) +
                  " elements across the body. Give at least three: a core and a layer round it.");
  }

  template <int dim>
  void EllipticShape<dim>::make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                                     const std::string &, Triangulation<dim>          &tria) const
  {
    const unsigned int        n_layers = get_n_layers(divisions);
    std::vector<unsigned int> core     = divisions.elements;
    for (unsigned int d = 1; d < dim; ++d)
      core[d] -= 2 * n_layers;
    make_cubed_ball(tria, core, n_layers);
    const auto body = this->make_straight_body(lengths);
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
    assign_regions(tria, divisions.region_boundaries);
  }

  template class EllipticShape<2>;
  template class EllipticShape<3>;
  template void make_cubed_ball(Triangulation<2> &, const std::vector<unsigned int> &,
                                unsigned int);
  template void make_cubed_ball(Triangulation<3> &, const std::vector<unsigned int> &,
                                unsigned int);
} // namespace caudal
