// SPDX-License-Identifier: LGPL-2.1-or-later
// Outlines through points: the points of a NACA 2412 in percent of the chord, in the order of
// airfoil files, give the body of the shape naca; what is no outline of that kind is refused.

#include <caudal/base/collective.h>
#include <caudal/mesh/body_grid.h>

#include <deal.II/grid/grid_tools.h>

#include "../entries.h"

#include <cmath>
#include <iostream>

using namespace caudal;

void make(const std::string &what, const Entries &entries)
{
  BodyGridParameters<2> parameters;
  Triangulation<2>      grid;
  set_entries(parameters, "Shape", entries);
  const std::string error =
      catch_error([&]() { make_body_grid(grid, parameters, 0.05, {"body"}, "Body x"); });
  std::cout << what << ": ";
  if (!error.empty())
    std::cout << error << '\n';
  else
    std::cout << grid.n_active_cells() << " cells, area " << GridTools::volume(grid)
              << ", least scaled Jacobian "
              << std::round(100 * compute_min_scaled_jacobian(grid)) / 100 << '\n';
}

int main()
{
  // From the tail over the upper side to the nose, and back below.
  const unsigned int n = 60;
  std::ostringstream points;
  for (int k = -static_cast<int>(n); k <= static_cast<int>(n); ++k)
  {
    const double u = static_cast<double>(k) / n, s = u * u;
    const double h =
        0.6 * (0.2969 * std::abs(u) + s * (-0.1260 + s * (-0.3516 + s * (0.2843 - s * 0.1015))));
    const double c =
        s < 0.4 ? 0.02 / 0.16 * (0.8 * s - s * s) : 0.02 / 0.36 * (0.2 + 0.8 * s - s * s);
    points << (k > -static_cast<int>(n) ? "; " : "") << 100 * s << ", "
           << 100 * (c + (k < 0 ? h : -h));
  }
  const Entries size        = {{"Length", "2"}, {"Elements", "60, 8"}};
  const auto    make_points = [&](const std::string &what, const std::string &table) {
    Entries entries         = size;
    entries["Type"]         = "points";
    entries["Points/Table"] = table;
    make(what, entries);
  };
  Entries naca        = size;
  naca["Type"]        = "naca";
  naca["Naca/Digits"] = "2412";
  make("naca", naca);
  make_points("points", points.str());
  make_points("a tail that is a point", "0,0; 1,1; 4,2; 10,0; 4,-2; 1,-1");
  make_points("too few points", "0,0; 1,1; 2,0; 1,-1");
  make_points("an outline with a bay", "0,0; 5,1; 3,2; 10,3; 10,-1; 5,-1; 1,-0.5");
  make_points("sides that touch", "0,0; 1,1; 5,0; 8,1; 10,0; 8,-1; 5,0; 1,-1");
  make_points("no points", "");
}
