// SPDX-License-Identifier: LGPL-2.1-or-later
// The derivatives of the energy with respect to the coordinates of the deformation, for motions
// in all directions, against differences of the energies of neighbouring shapes: of the fluid,
// with and without the use of mirror symmetry, and of the body; the second derivatives of places.

#include <caudal/ideal/exterior_flow.h>

#include "../round_off.h"
#include "bodies.h"

#include <cmath>
#include <iostream>

using namespace caudal;
using namespace caudal::ideal;

double norm(const std::vector<double> &values)
{
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.));
}

// |a - b|/|b|
double compare(std::vector<double> a, const std::vector<double> &b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
  return norm(a) / norm(b);
}

// The gradient of a function of c, by differences of fourth order.
template <class Function>
std::vector<double> differentiate(const std::vector<double> &c, const Function &function)
{
  const double        step = 1e-3;
  std::vector<double> gradient;
  for (std::size_t i = 0; i < c.size(); ++i)
  {
    const auto at = [&](const double distance) {
      std::vector<double> moved = c;
      moved[i] += distance * step;
      return function(moved);
    };
    gradient.push_back((8. * (at(1.) - at(-1.)) - (at(2.) - at(-2.))) / (12. * step));
  }
  return gradient;
}

void check(const std::string &name, const Surface &surface, const TestBody &body,
           const bool is_root)
{
  const Gait        &gait        = *body.gait;
  const Deformation &deformation = *body.deformation;
  const GaitState    at          = gait.evaluate(0.7);
  const double       length      = deformation.get_length();
  BoundaryElements   elements(surface, MPI_COMM_WORLD);

  // Rotations, translations, modes
  std::vector<double> u = {0.8, -0.5, 1.1, 0.4 * length, -0.9 * length, 0.7 * length};
  u.insert(u.end(), at.rates.begin(), at.rates.end());
  const Vector<double> motion(u.begin(), u.end());
  const auto           rates = deformation.compute_mode_rates(at.c, at.rates);

  for (const double height : {0., 0.1})
  {
    const auto place = [&](const std::vector<double> &c) {
      SurfaceMotion moved = deformation.place(c);
      for (auto *const points : {&moved.positions, &moved.rest})
        for (Point<3> &point : *points)
          point[2] += height * length;
      return moved;
    };
    const auto differences = differentiate(at.c, [&](const std::vector<double> &c) {
      return 0.5 * elements.solve(place(c)).get_potentials().added_mass.matrix_norm_square(motion);
    });
    const auto gradient    = elements.solve(place(at.c)).compute_energy_gradient(u, rates);
    if (is_root)
      std::cout << name << (height > 0. ? ", moved" : "") << ": gradient of the fluid's energy "
                << in_units(1e-9, compare(gradient, differences)) << std::endl;
  }

  const auto differences = differentiate(at.c, [&](const std::vector<double> &c) {
    return 0.5 * deformation.compute_body_mass(c).matrix_norm_square(motion);
  });
  double     rate_error  = 0.;
  for (std::size_t i = 0; i < at.c.size(); ++i)
    for (const unsigned int node : {0u, 10u, surface.n_nodes() - 1})
      for (unsigned int d = 0; d < 3; ++d)
      {
        const auto   by_c = differentiate(at.c, [&](const std::vector<double> &c) {
          return deformation.place(c).modes[i][node][d];
        });
        const double rate = std::inner_product(by_c.begin(), by_c.end(), at.rates.begin(), 0.);
        rate_error        = std::max(rate_error, std::abs(rate - rates[i][node][d]) / length);
      }
  if (is_root)
    std::cout << name << ": gradient of the body's energy "
              << in_units(1e-9,
                          compare(deformation.compute_body_energy_gradient(at.c, u), differences))
              << ", second derivatives " << in_units(1e-9, rate_error) << std::endl;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                       is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  const Surface surface({3, 2});
  const Entries fish = {{"Stations/Table", "0.1, 3e-3, 4e-3; 0.5, 5e-3, 9e-3; 0.9, 1e-3, 8e-3"}};
  check("joints", surface, TestBody(surface, fish, {}), is_root);
  check("curvature", surface, TestBody(surface, fish, {{"Type", "curvature wave"}}), is_root);
  check("displacement", surface, TestBody(surface, fish, {{"Type", "travelling wave"}}), is_root);
  check("deforming sphere", surface, TestBody(surface, 0.1, 0.1), is_root);
}
