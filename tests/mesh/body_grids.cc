// SPDX-License-Identifier: LGPL-2.1-or-later
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

#include "../entries.h"

using namespace caudal;

double round_to(const double value, const double unit)
{
  return std::round(value / unit) * unit + 0.; // no negative zero
}

template <int dim>
struct ShapeFromEntries : BodyGridParameters<dim>
{
  explicit ShapeFromEntries(const Entries &entries)
  {
    set_entries(*this, "Shape", entries);
  }
};

template <int dim>
void report(const std::string &name, const Entries &entries, const double volume,
            const double spacing = dim == 2 ? 0.01 : 0.05)
{
  const ShapeFromEntries<dim> parameters(entries);
  const unsigned int          n_regions = parameters.shape.type.get().get_region_entry() != ""
                                              ? 2
                                              : parameters.region_boundaries.size() + 1;
  Triangulation<dim>          tria;
  make_body_grid(tria, parameters, spacing, std::vector<std::string>(n_regions, "x"), "Body x");
  AssertThrow(tria.get_boundary_ids() == std::vector<types::boundary_id>(1, 0),
              ExcMessage("All boundary ids should be 0."));

  std::vector<double> region_volumes(n_regions);
  for (const auto &cell : tria.active_cell_iterators())
    region_volumes[cell->material_id()] += cell->measure();
  const BodyExtent<dim> extent = compute_extent(tria);
  std::vector<double>   thickness(n_regions, std::numeric_limits<double>::infinity());
  for (const FaceThickness<dim> &face : extent.faces)
    thickness[face.region] = std::min(thickness[face.region], face.thickness);

  std::cout << name << ": " << tria.n_levels() << " level, " << tria.n_active_cells()
            << " cells, length " << round_to(extent.length, 1e-4) << " m, smallest scaled Jacobian "
            << round_to(compute_min_scaled_jacobian(tria), 1e-3) << ", volume off by "
            << round_to(1e2 * (GridTools::volume(tria) / volume - 1.), 1e-2) << " %\n  regions:";
  for (unsigned int r = 0; r < n_regions; ++r)
    std::cout << ' ' << round_to(region_volumes[r] / volume, 1e-4) << " of the volume, "
              << round_to(thickness[r], 1e-4) << " m thick;";
  std::cout << std::endl;
}

void report_shapes()
{
  const double naca_area =
      10. * 0.12 * (0.2969 * 2. / 3. - 0.1260 / 2. - 0.3516 / 3. + 0.2843 / 4. - 0.1015 / 5.);
  report<2>("naca 0012", {{"Region boundaries", "0.5, 0.96"}}, naca_area);
  report<2>("naca 0012, coarse, 2 m",
            {{"Region boundaries", "0.5, 0.96"}, {"Length", "2"}, {"Elements", "60, 4"}},
            4. * naca_area);
  report<2>("naca 6412 against 0012", {{"Region boundaries", "0.5, 0.96"}, {"Naca/Digits", "6412"}},
            naca_area);
  const double eel_area = numbers::PI / 2. * 0.04 * 0.04 + 0.05 * 0.91 + 0.01 * 0.05;
  report<2>("eel", {{"Type", "eel"}}, eel_area);
  report<2>("eel in large cells", {{"Type", "eel"}}, eel_area, 0.1);
  report<2>("eel in cells that are far too large", {{"Type", "eel"}}, eel_area, 1.);
  report<2>("disc", {{"Type", "disc"}}, numbers::PI * 0.01);
  report<2>("disc, coarse, halves",
            {{"Type", "disc"}, {"Elements", "20, 20"}, {"Region boundaries", "0.5"}},
            numbers::PI * 0.01);

  // The flag begins at the arc, which takes a segment of the circle away from it.
  const double angle = std::asin(0.2);
  const double gap   = 0.0025 * (angle - 0.5 * std::sin(2. * angle));
  const double root  = 0.02 * (0.4 - 0.05 * std::cos(angle));
  report<2>("cylinder with flag",
            {{"Type", "cylinder with flag"},
             {"Radius", "0.05"},
             {"Length", "0.35"},
             {"Thickness", "0.02"},
             {"Elements", "70, 4"}},
            numbers::PI * 0.0025 + root - gap);
  report<2>("ellipse", {{"Type", "ellipse"}, {"Thickness", "0.4"}}, numbers::PI * 0.1);
  report<2>("ring", {{"Type", "ring"}, {"Elements", "60, 4"}}, numbers::PI * (0.15 * 0.15 - 0.01));
  report<2>("ring, automatic", {{"Type", "ring"}}, numbers::PI * (0.15 * 0.15 - 0.01));
  report<2>("beam", {{"Type", "beam"}, {"Elements", "33, 2"}, {"Region boundaries", "0.25, 0.9"}},
            0.1);
  report<2>("rectangle", {{"Type", "rectangle"}}, 0.1);
  report<2>("quadrilateral",
            {{"Type", "quadrilateral"},
             {"Quadrilateral/Vertices", "0, 0; 6.5, 4.4; 6.5, 6; 0, 4.4"},
             {"Elements", "16, 8"},
             {"Region boundaries", "0.5"}},
            6.5 * 3.);

  report<3>("ball", {{"Type", "disc"}}, 4. / 3. * numbers::PI * 1e-3);
  report<3>("ellipsoid", {{"Type", "ellipse"}, {"Thickness", "0.5"}, {"Width", "0.5"}},
            numbers::PI / 6. * 0.25);
  report<3>("box", {{"Type", "beam"}}, 0.01);
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

template <int dim = 2>
void print_error(const std::string &type, Entries entries, const unsigned int n_regions = 1)
{
  entries["Type"] = type;
  Triangulation<dim> tria;
  print_error([&]() {
    make_body_grid(tria, ShapeFromEntries<dim>(entries), 0.05,
                   std::vector<std::string>(n_regions, "x"), "Body x");
  });
}

void print_bad_input()
{
  print_error("naca", {{"Length", "-1"}});
  print_error("naca", {{"Naca/Digits", "12"}});
  print_error("naca", {{"Naca/Digits", "0000"}});
  print_error("naca", {{"Naca/Digits", "2012"}});
  print_error("naca", {{"Elements", "100, 3"}});
  print_error("naca", {{"Region boundaries", "0.001"}}, 2);
  print_error("naca", {{"Region boundaries", "0.001"}, {"Elements", "100, 8"}}, 2);
  print_error("naca", {{"Elements", "100"}});
  print_error("naca", {{"Elements", "many"}});
  print_error("naca", {{"Elements", "1e2, 0.5"}});
  print_error("eel", {{"Region boundaries", "0.5, 0.2"}}, 3);
  print_error("eel", {{"Region boundaries", "0.5"}}, 3);
  print_error("disc", {{"Radius", "0"}});
  print_error("disc", {{"Region boundaries", "0.5, 0.501"}}, 3);
  print_error("ring", {{"Ring/Wall thickness", "0"}});
  print_error("ring", {{"Elements", "4, 1"}});
  print_error("beam", {{"Thickness", "-0.1"}});
  print_error("beam", {{"Elements", "1, 1"}, {"Region boundaries", "0.5"}}, 2);
  print_error<3>("naca", {});
  print_error<3>("beam", {{"Width", "0"}});

  print_error("file", {});
  print_error("file", {{"File/Name", "missing.msh"}});
  std::ofstream("broken.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0";
  print_error("file", {{"File/Name", "broken.msh"}});
  write_msh("triangles.msh", "1 1 0", true);
  print_error("file", {{"File/Name", "triangles.msh"}}, 2);
  std::ofstream("twice.msh")
      << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
      << "3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n2\n1 3 2 1 1 1 2 3 4\n"
      << "2 3 2 2 1 1 2 3 4\n$EndElements\n";
  print_error("file", {{"File/Name", "twice.msh"}}, 2);
  write_msh("dented.msh", "0.2 0.1 0");
  print_error("file", {{"File/Name", "dented.msh"}}, 2);
  write_msh("strip.msh");
  print_error("file", {{"File/Name", "strip.msh"}}, 3);
  print_error<3>("file", {{"File/Name", "strip.msh"}}, 2);
}

int main()
{
  std::cout << std::setprecision(6);
  report_shapes();

  write_msh("strip.msh", "1.2 1 0");
  report<2>("file", {{"Type", "file"}, {"File/Name", "strip.msh"}}, 2.);

  const Entries eel = {{"Type", "eel"},
                       {"Elements", "100, 6"},
                       {"Position", "1, 2"},
                       {"Rotation", "90"},
                       {"Region boundaries", "0.3, 0.6"}};
  report<2>("parsed eel", eel, 0.0486);
  const Point<2> placed = place_in_domain(ShapeFromEntries<2>(eel), Point<2>(0.5, 0.1));
  std::cout << "placed at " << round_to(placed[0], 1e-6) << ' ' << round_to(placed[1], 1e-6)
            << std::endl;

  print_bad_input();
}
