// The grid of each shape: size against the exact one, quality, regions. A gmsh
// file. The sentences for input that can't work.

#include <deal.II/grid/grid_tools.h>

#include <caudal/mesh/body_grid.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace caudal;

double round_to(const double value, const double unit)
{
  return std::round(value / unit) * unit + 0.; // no negative zero
}

template <int dim>
void report(const std::string &name, const BodyGridParameters<dim> &parameters, const double volume)
{
  const unsigned int n_regions =
      parameters.type == "file" || parameters.type == "cylinder with flag"
          ? 2
          : parameters.region_boundaries.size() + 1;
  Triangulation<dim> tria;
  make_body_grid(tria, parameters, n_regions, "Body x");
  AssertThrow(tria.get_boundary_ids() == std::vector<types::boundary_id>(1, 0),
              ExcMessage("All boundary ids should be 0."));

  std::vector<double> region_volumes(n_regions);
  for (const auto &cell : tria.active_cell_iterators())
    region_volumes[cell->material_id()] += cell->measure();
  const BodyExtent extent = compute_extent(tria);

  std::cout << name << ": " << tria.n_levels() << " level, " << tria.n_active_cells()
            << " cells, length " << round_to(extent.length, 1e-4) << " m, smallest scaled Jacobian "
            << round_to(compute_min_scaled_jacobian(tria), 1e-3) << ", volume off by "
            << round_to(1e2 * (GridTools::volume(tria) / volume - 1.), 1e-2) << " %\n  regions:";
  for (unsigned int r = 0; r < n_regions; ++r)
    std::cout << ' ' << round_to(region_volumes[r] / volume, 1e-4) << " of the volume, "
              << round_to(extent.region_thickness[r], 1e-4) << " m thick;";
  std::cout << std::endl;
}

template <int dim>
BodyGridParameters<dim> make_parameters(const std::string &type)
{
  BodyGridParameters<dim> parameters;
  parameters.type = type;
  return parameters;
}

void report_shapes()
{
  auto         naca = make_parameters<2>("naca");
  const double naca_area =
      10. * 0.12 * (0.2969 * 2. / 3. - 0.1260 / 2. - 0.3516 / 3. + 0.2843 / 4. - 0.1015 / 5.);
  naca.region_boundaries = {0.5, 0.96};
  report("naca 0012", naca, naca_area);
  naca.length   = 2.;
  naca.elements = {60, 4};
  report("naca 0012, coarse, 2 m", naca, 4. * naca_area);
  naca.length      = 1.;
  naca.elements    = {209, 10};
  naca.naca_digits = "6412";
  report("naca 6412 against 0012", naca, naca_area);

  auto         eel      = make_parameters<2>("eel");
  const double eel_area = numbers::PI / 2. * 0.04 * 0.04 + 0.05 * 0.91 + 0.01 * 0.05;
  report("eel", eel, eel_area);

  auto disc = make_parameters<2>("disc");
  report("disc", disc, numbers::PI * 0.01);
  disc.elements          = {20, 20};
  disc.region_boundaries = {0.5};
  report("disc, coarse, halves", disc, numbers::PI * 0.01);

  auto flag      = make_parameters<2>("cylinder with flag");
  flag.radius    = 0.05;
  flag.length    = 0.35;
  flag.thickness = 0.02;
  flag.elements  = {70, 4};
  // The flag begins at the arc, which takes a segment of the circle away from it.
  const double angle = std::asin(0.2);
  const double gap   = 0.0025 * (angle - 0.5 * std::sin(2. * angle));
  const double root  = 0.02 * (0.4 - 0.05 * std::cos(angle));
  report("cylinder with flag", flag, numbers::PI * 0.0025 + root - gap);

  auto ellipse      = make_parameters<2>("ellipse");
  ellipse.thickness = 0.4;
  report("ellipse", ellipse, numbers::PI * 0.1);

  auto ring     = make_parameters<2>("ring");
  ring.elements = {60, 4};
  report("ring", ring, numbers::PI * (0.15 * 0.15 - 0.01));

  auto beam              = make_parameters<2>("beam");
  beam.elements          = {33, 2};
  beam.region_boundaries = {0.25, 0.9};
  report("beam", beam, 0.1);
  report("rectangle", make_parameters<2>("rectangle"), 0.1);
  auto cook              = make_parameters<2>("quadrilateral");
  cook.vertices          = {{0., 0.}, {6.5, 4.4}, {6.5, 6.}, {0., 4.4}};
  cook.elements          = {16, 8};
  cook.region_boundaries = {0.5};
  report("quadrilateral", cook, 6.5 * 3.);

  report("ball", make_parameters<3>("disc"), 4. / 3. * numbers::PI * 1e-3);
  auto ellipsoid      = make_parameters<3>("ellipse");
  ellipsoid.thickness = ellipsoid.width = 0.5;
  report("ellipsoid", ellipsoid, numbers::PI / 6. * 0.25);
  report("box", make_parameters<3>("beam"), 0.01);
}

/** A strip of two cells, [0,1]x[0,1] with physical id 7 and [1,2]x[0,1] with 3. */
void write_msh(const std::string &name, const std::string &vertex = "1 1 0",
               const bool split = false)
{
  std::ofstream(name) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n"
                      << "3 2 0 0\n4 0 1 0\n5 " << vertex << "\n6 2 1 0\n$EndNodes\n$Elements\n"
                      << (split ? "4\n3 2 2 7 1 1 2 5\n4 2 2 7 1 1 5 4\n"
                                : "3\n1 3 2 7 1 1 2 5 4\n")
                      << "2 3 2 3 1 2 3 6 5\n5 1 2 9 1 1 2\n$EndElements\n";
}

void print_error(const std::function<void()> &action)
{
  try
  {
    action();
    std::cout << "  no error" << std::endl;
  }
  catch (const ExceptionBase &exception)
  {
    exception.print_info(std::cout);
  }
}

template <int dim>
void print_error(const std::string                                    &type,
                 const std::function<void(BodyGridParameters<dim> &)> &change,
                 const unsigned int                                    n_regions = 1)
{
  auto parameters = make_parameters<dim>(type);
  change(parameters);
  Triangulation<dim> tria;
  print_error([&]() { make_body_grid(tria, parameters, n_regions, "Body x"); });
}

void print_bad_input()
{
  using Parameters = BodyGridParameters<2>;
  print_error<2>("naca", [](Parameters &p) { p.length = -1.; });
  print_error<2>("naca", [](Parameters &p) { p.naca_digits = "12"; });
  print_error<2>("naca", [](Parameters &p) { p.naca_digits = "0000"; });
  print_error<2>("naca", [](Parameters &p) { p.naca_digits = "2012"; });
  print_error<2>("naca", [](Parameters &p) { p.elements = {100, 3}; });
  print_error<2>(
      "naca", [](Parameters &p) { p.region_boundaries = {0.001}; }, 2);
  print_error<2>(
      "eel",
      [](Parameters &p) {
        p.region_boundaries = {0.5, 0.2};
      },
      3);
  print_error<2>(
      "eel", [](Parameters &p) { p.region_boundaries = {0.5}; }, 3);
  print_error<2>("disc", [](Parameters &p) { p.radius = 0.; });
  print_error<2>(
      "disc",
      [](Parameters &p) {
        p.region_boundaries = {0.5, 0.501};
      },
      3);
  print_error<2>("ring", [](Parameters &p) { p.wall_thickness = 0.; });
  print_error<2>("ring", [](Parameters &p) { p.elements = {4, 1}; });
  print_error<2>("beam", [](Parameters &p) { p.thickness = -0.1; });
  print_error<2>(
      "beam",
      [](Parameters &p) {
        p.elements          = {1, 1};
        p.region_boundaries = {0.5};
      },
      2);
  print_error<3>("naca", [](BodyGridParameters<3> &) {});
  print_error<3>("beam", [](BodyGridParameters<3> &p) { p.width = 0.; });

  print_error<2>("file", [](Parameters &) {});
  print_error<2>("file", [](Parameters &p) { p.file = "missing.msh"; });
  std::ofstream("broken.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0";
  print_error<2>("file", [](Parameters &p) { p.file = "broken.msh"; });
  write_msh("triangles.msh", "1 1 0", true);
  print_error<2>(
      "file", [](Parameters &p) { p.file = "triangles.msh"; }, 2);
  std::ofstream("twice.msh")
      << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
      << "3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n2\n1 3 2 1 1 1 2 3 4\n"
      << "2 3 2 2 1 1 2 3 4\n$EndElements\n";
  print_error<2>(
      "file", [](Parameters &p) { p.file = "twice.msh"; }, 2);
  write_msh("dented.msh", "0.2 0.1 0");
  print_error<2>(
      "file", [](Parameters &p) { p.file = "dented.msh"; }, 2);
  write_msh("strip.msh");
  print_error<2>(
      "file", [](Parameters &p) { p.file = "strip.msh"; }, 3);
  print_error<3>(
      "file", [](BodyGridParameters<3> &p) { p.file = "strip.msh"; }, 2);
}

int main()
{
  std::cout << std::setprecision(6);
  report_shapes();

  write_msh("strip.msh", "1.2 1 0");
  auto file = make_parameters<2>("file");
  file.file = "strip.msh";
  report("file", file, 2.);

  ParameterHandler      prm;
  BodyGridParameters<2> parsed;
  parsed.add_parameters(prm);
  prm.parse_input_from_string("subsection Shape\n set Type = eel\n set Elements = 100, 6\n"
                              " set Position = 1, 2\n set Rotation = 90\n"
                              " set Region boundaries = 0.3, 0.6\nend");
  report("parsed eel", parsed, 0.0486);
  const Point<2> placed = place_in_domain(parsed, Point<2>(0.5, 0.1));
  std::cout << "placed at " << round_to(placed[0], 1e-6) << ' ' << round_to(placed[1], 1e-6)
            << std::endl;

  print_bad_input();
}
