// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/shape.h>

#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace caudal
{
  unsigned int GridDivisions::count_elements(const double length) const
  {
    return length < 1.6 * spacing ? 1 : std::lround(length / spacing);
  }

  template <int dim>
  std::vector<unsigned int> GridDivisions::get_elements(const Tensor<1, dim> &sides) const
  {
    if (!is_automatic())
      return elements;
    std::vector<unsigned int> result;
    for (unsigned int d = 0; d < dim; ++d)
      result.push_back(count_elements(sides[d]));
    result[0] = std::max<unsigned int>(result[0], region_boundaries.size() + 1);
    return result;
  }

  std::vector<double> GridDivisions::compute_steps_along(const unsigned int n_along) const
  {
    const std::vector<double> columns = compute_columns(0., region_boundaries, n_along);
    std::vector<double>       steps;
    for (unsigned int i = 1; i < columns.size(); ++i)
      steps.push_back(columns[i] - columns[i - 1]);
    return steps;
  }

  template <int dim>
  ShapeParameters<dim>::ShapeParameters(const std::string &default_type,
                                        const double       default_length)
      : type("Type", default_type, "Shape of the body")
  {
    lengths.length = default_length;
  }

  template <int dim>
  void ShapeParameters<dim>::add_entries(ParameterHandler &prm)
  {
    type.add_parameters(prm);
    prm.add_parameter("Length", lengths.length,
                      "Length along the axis [m]: chord of naca, length of eel, stations, beam and "
                      "rectangle, full axis of ellipse, part of the flag that sticks out of the "
                      "cylinder. The half-axes of stations grow with it if their Table length is "
                      "given.",
                      Patterns::Double());
    prm.add_parameter("Thickness", lengths.thickness,
                      "Extent across the axis [m]: height of beam, rectangle and flag, full second "
                      "axis of ellipse.",
                      Patterns::Double());
    prm.add_parameter("Width", lengths.width,
                      "Extent in the third direction [m] of beam, rectangle and ellipse; 3D only.",
                      Patterns::Double());
    prm.add_parameter("Radius", lengths.radius,
                      "Radius of disc and cylinder, inner radius of ring [m].", Patterns::Double());
  }

  template <int dim>
  void ShapeParameters<dim>::check(const std::string &path) const
  {
    type.check(path);
    type.get().check_lengths(lengths, path);
  }

  template <int dim>
  std::unique_ptr<StraightBody>
  ShapeParameters<dim>::make_straight_body(const std::string &path) const
  {
    AssertThrow(type.get().has_surface(), ExcMessage(path + "/Type: the shape <" + type.get_name() +
                                                     "> has no closed surface. Choose one of " +
                                                     list_shapes<dim>([](const Shape<dim> &shape) {
                                                       return shape.has_surface();
                                                     }) +
                                                     "."));
    return type.get().make_straight_body(lengths);
  }

  void require(const bool condition, const std::string &path, const std::string &entry,
               const std::string &sentences)
  {
    AssertThrow(condition, ExcMessage(path + "/" + entry + ": " + sentences));
  }

  void require_positive(const double value, const std::string &path, const std::string &entry)
  {
    std::string name = entry.substr(entry.rfind('/') + 1);
    name[0]          = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    std::ostringstream sentences;
    sentences << "the " << name << " is " << value << " m. Give a positive " << name << ".";
    require(value > 0. && std::isfinite(value), path, entry, sentences.str());
  }

  unsigned int get_region(const double s, const std::vector<double> &region_boundaries)
  {
    return std::upper_bound(region_boundaries.begin(), region_boundaries.end(), s) -
           region_boundaries.begin();
  }

  template <int dim>
  void assign_regions(Triangulation<dim> &tria, const std::vector<double> &region_boundaries)
  {
    const BoundingBox<dim> box    = GridTools::compute_bounding_box(tria);
    const double           begin  = box.lower_bound(0);
    const double           length = box.side_length(0);
    for (const auto &cell : tria.active_cell_iterators())
      cell->set_material_id(get_region((cell->center()[0] - begin) / length, region_boundaries));
  }

  std::vector<double> compute_columns(const double               first,
                                      const std::vector<double> &region_boundaries,
                                      const unsigned int         n_columns)
  {
    const unsigned int n_regions = region_boundaries.size() + 1;
    AssertThrow(n_columns >= n_regions, ExcMessage("Each region needs a column of cells."));

    std::vector<double> columns(1, first);
    for (unsigned int region = 0; region < n_regions; ++region)
    {
      const double begin = columns.back();
      const double end   = region + 1 < n_regions ? region_boundaries[region] : 1.;

      const unsigned int done = columns.size() - 1;
      const unsigned int last =
          std::clamp<long>(std::lround(n_columns * (end - first) / (1. - first)), done + 1,
                           n_columns - (n_regions - 1 - region));
      for (unsigned int i = done + 1; i < last; ++i)
        columns.push_back(begin + (end - begin) * (i - done) / (last - done));
      columns.push_back(end);
    }
    return columns;
  }

  template <int dim>
  void scale_to_volume(Triangulation<dim> &tria, const double volume)
  {
    GridTools::scale(std::pow(volume / GridTools::volume(tria), 1. / dim), tria);
  }

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

  template struct ShapeParameters<2>;
  template struct ShapeParameters<3>;
  template void assign_regions(Triangulation<2> &, const std::vector<double> &);
  template void assign_regions(Triangulation<3> &, const std::vector<double> &);
  template std::vector<unsigned int> GridDivisions::get_elements(const Tensor<1, 2> &) const;
  template std::vector<unsigned int> GridDivisions::get_elements(const Tensor<1, 3> &) const;
  template void                      scale_to_volume(Triangulation<2> &, double);
  template void                      scale_to_volume(Triangulation<3> &, double);
  template void subdivide(const Triangulation<2> &, unsigned int, Triangulation<2> &);
  template void subdivide(const Triangulation<3> &, unsigned int, Triangulation<3> &);
} // namespace caudal
