// SPDX-License-Identifier: LGPL-2.1-or-later
// Grids in space of bodies of elliptic sections: nose, length and volume are those of the body that
// is described, pi int a b ds; elements are convex, and a thin tail is as many of them across as
// suit it.

#include <deal.II/grid/grid_tools.h>

#include <caudal/mesh/body_grid.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "../entries.h"

using namespace caudal;

double round_to(const double value, const double unit)
{
  return std::round(value / unit) * unit + 0.; // no negative zero
}

/** The share of the boundary's area where the first layer is lower than 0.8 of @p spacing [1]. */
double get_low_share(const Triangulation<3> &tria, const double spacing)
{
  double low = 0., area = 0.;
  for (const FaceThickness<3> &face : compute_extent(tria).faces)
  {
    area += face.area;
    if (face.height < 0.8 * spacing && face.height < 0.75 * face.thickness)
      low += face.area;
  }
  return low / area;
}

void report(const std::string &name, const Entries &entries, const double length,
            const double spacing)
{
  BodyGridParameters<3> parameters;
  set_entries(parameters, "Shape", entries);
  Triangulation<3> tria;
  make_body_grid(tria, parameters, spacing * length, {"x"}, "Body x");

  double volume = 0.;
  for (const BodySlice &slice :
       parameters.shape.make_straight_body("Body x/Shape")->compute_slices())
    volume += slice.moments[0][0];
  const BoundingBox<3> box = GridTools::compute_bounding_box(tria);
  // How much of the volume lies in the last fifth, behind the peduncle.
  double tail = 0.;
  for (const auto &cell : tria.active_cell_iterators())
    if (cell->center()[0] > 0.8 * length)
      tail += cell->measure();
  std::cout << name << ", elements of L/" << std::lround(1. / spacing) << ": "
            << tria.n_active_cells() << " cells, nose "
            << round_to(box.lower_bound(0) / length, 1e-6) << " L, length "
            << round_to(box.side_length(0) / length, 1e-6) << " L, volume "
            << round_to(GridTools::volume(tria) / volume, 1e-6) << ", height "
            << round_to(box.side_length(2) / length, 1e-4) << " L, tail "
            << round_to(tail / volume, 1e-3) << ", smallest scaled Jacobian "
            << round_to(compute_min_scaled_jacobian(tria), 1e-3) << ", low on "
            << round_to(get_low_share(tria, spacing * length), 1e-2) << std::endl;
}

int main()
{
  std::cout << std::setprecision(7);
  const Entries salmon = {{"Type", "stations"},
                          {"Length", "0.1"},
                          {"Stations/Table",
                           "0.0714, 2.5e-3, 3.5e-3; 0.2143, 5e-3, 9e-3; 0.3571, 6e-3, 11e-3;"
                           "0.5, 5e-3, 9.5e-3; 0.6429, 3.2e-3, 6.5e-3; 0.7857, 1.7e-3, 3.5e-3;"
                           "0.9286, 1e-3, 10e-3"}};
  for (const double n : {16., 25.6, 40., 64., 100.})
    report("salmon", salmon, 0.1, 1. / n);
  Entries given     = salmon;
  given["Elements"] = "40, 8, 10";
  report("salmon, 40 x 8 x 10", given, 0.1, 1. / 40.);
  const Entries spheroid = {{"Type", "ellipsoid"}, {"Ellipsoid/Axes", "0.5, 0.1, 0.15"}};
  for (const double n : {8., 16., 40.})
    report("ellipsoid", spheroid, 1., 1. / n);
}
