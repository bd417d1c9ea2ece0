// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/safe_file.h>
#include <caudal/ideal/surface.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>

#include <map>

namespace caudal::ideal
{
  namespace
  {
    /** From the cube [-1,1]^3 to the unit sphere; grid lines at equal angles on each face. */
    Point<3> project_to_sphere(const Point<3> &p)
    {
      Tensor<1, 3> direction;
      for (unsigned int d = 0; d < 3; ++d)
        direction[d] = std::tan(0.25 * numbers::PI * p[d]);
      return Point<3>(direction / direction.norm());
    }

    /** Each edge has to belong to two cells that run through it in opposite directions. */
    void check_closed(const Triangulation<2, 3> &triangulation, const std::string &file_name)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        AssertThrow(cell->direction_flag(),
                    ExcMessage("Shape/File/Name: the mesh <" + file_name +
                               "> is inverted in a part: two neighbouring quadrilaterals have "
                               "opposite normals. Orient all of them outwards."));
        AssertThrow(!cell->at_boundary(),
                    ExcMessage("Shape/File/Name: the mesh <" + file_name +
                               "> is open: an edge belongs to one quadrilateral only. Close the "
                               "surface and merge nodes that coincide."));
      }
    }

    /** V = (1/3) int x.n dS of the surface of bilinear cells [m^3]. */
    double compute_volume(const Triangulation<2, 3> &triangulation)
    {
      double volume = 0.;
      for (const auto &cell : triangulation.active_cell_iterators())
        volume +=
            cell->center() *
            cross_product_3d(cell->vertex(3) - cell->vertex(0), cell->vertex(2) - cell->vertex(1)) /
            6.;
      return volume;
    }
  } // namespace

  void SurfaceParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Surface");
    prm.add_parameter("Cells along", n_along,
                      "Curved quadrilaterals along the flanks of the body, between its two ends "
                      "[1].",
                      Patterns::Integer(1));
    prm.add_parameter("Cells across", n_across,
                      "Quadrilaterals along a quarter of the girth, and in each direction on the "
                      "two ends of the body [1]. There are 4 along across + 2 across^2 cells and "
                      "16 along across + 8 across^2 + 2 nodes, each with an unknown (`panels`).",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }

  void SurfaceParameters::check() const
  {
    const std::string remedy = "Give at most 64: the matrices are dense.";
    check_value(n_along <= 64, "Surface/Cells along", n_along, remedy);
    check_value(n_across <= 64, "Surface/Cells across", n_across, remedy);
  }

  Surface::Surface(const SurfaceParameters &parameters, const std::string &file)
      : from_file(!file.empty())
      , fe(degree)
      , dof_handler(triangulation)
  {
    if (from_file)
      read(file);
    else
      make_cubed_sphere(parameters.n_along, parameters.n_across);
    number_nodes();
  }

  void Surface::make_cubed_sphere(const unsigned int n_along, const unsigned int n_across)
  {
    Triangulation<3> cube;
    GridGenerator::subdivided_hyper_rectangle(cube, {n_along, n_across, n_across},
                                              Point<3>(-1, -1, -1), Point<3>(1, 1, 1));
    GridGenerator::extract_boundary_mesh(cube, triangulation);
    AssertThrow(compute_volume(triangulation) > 0., ExcInternalError());
  }

  void Surface::read(const std::string &file_name)
  {
    const std::string reason = catch_file_error([&]() { read_whole_file(file_name); });
    AssertThrow(reason.empty(), ExcMessage("Shape/File/Name: the mesh can't be read: " + reason +
                                           ". Give an existing file."));
    try
    {
      GridIn<2, 3> grid_in(triangulation);
      grid_in.read(file_name);
    }
    catch (const ExceptionBase &exception)
    {
      AssertThrow(false, ExcMessage("Shape/File/Name: the mesh <" + file_name +
                                    "> can't be understood. Give a mesh of quadrilaterals in "
                                    "three dimensions (.msh, .ucd, .vtk)."));
    }
    check_closed(triangulation, file_name);
    AssertThrow(compute_volume(triangulation) > 0.,
                ExcMessage("Shape/File/Name: the mesh <" + file_name +
                           "> is inverted: its normals point into the body. Reverse the order of "
                           "the nodes of each cell."));
  }

  void Surface::number_nodes()
  {
    dof_handler.distribute_dofs(fe);
    for (const auto &cell : dof_handler.active_cell_iterators())
    {
      nodes.emplace_back(n_nodes_per_cell);
      cell->get_dof_indices(nodes.back());
    }
    reference_points.resize(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ<2, 3>(1), dof_handler, reference_points);
    if (!from_file)
      for (Point<3> &point : reference_points)
        point = project_to_sphere(point);
    mirror_images = find_mirror_images(reference_points, 2);
  }

  std::vector<Tensor<1, 3>> SurfaceMotion::compute_velocities(const Screw               &rigid,
                                                              const std::vector<double> &rates,
                                                              const double               rate) const
  {
    std::vector<Tensor<1, 3>> velocities;
    for (unsigned int node = 0; node < positions.size(); ++node)
    {
      velocities.push_back(get_linear(rigid) +
                           cross_product_3d(get_angular(rigid), Tensor<1, 3>(positions[node])));
      for (unsigned int i = 0; i < rates.size(); ++i)
        velocities.back() += rate * rates[i] * modes[i][node];
    }
    return velocities;
  }

  std::vector<unsigned int> find_mirror_images(const std::vector<Point<3>> &points,
                                               const unsigned int           d)
  {
    double size = 0.;
    for (const Point<3> &point : points)
      size = std::max(size, point.norm());
    const auto get_key = [&](Point<3> p, const double sign) {
      p[d] *= sign;
      std::array<long, 3> key;
      for (unsigned int e = 0; e < 3; ++e)
        key[e] = std::lround(1e7 * p[e] / size);
      return key;
    };
    std::map<std::array<long, 3>, unsigned int> numbers;
    for (unsigned int i = 0; i < points.size(); ++i)
      numbers[get_key(points[i], 1.)] = i;
    std::vector<unsigned int> images;
    for (const Point<3> &point : points)
    {
      const auto image = numbers.find(get_key(point, -1.));
      if (image == numbers.end())
        return {};
      images.push_back(image->second);
    }
    return images;
  }
} // namespace caudal::ideal
