// SPDX-License-Identifier: LGPL-2.1-or-later
// Added masses of ellipsoids against Lamb (Hydrodynamics, 6th ed. 1932, sections 114 and 121):
// k of the translations, I/(rho V) of the rotations; their order of convergence; the same
// without the mirror symmetry, which halves the work; the volume.

#include <caudal/ideal/exterior_flow.h>

#include <cmath>
#include <iomanip>
#include <iostream>

#include "../round_off.h"

using namespace caudal;
using namespace caudal::ideal;

struct Ellipsoid
{
  double axes[3], k[3], inertia[3];
};

const Ellipsoid ellipsoids[] = {
    {{1, 1, 1}, {.5, .5, .5}, {0, 0, 0}},
    {{2, 1, 1}, {.21001505, .70421043, .70421043}, {0, .23942389, .23942389}},
    {{5, 1, 1}, {.05912117, .89426054, .89426054}, {0, 3.63922528, 3.63922528}},
    {{4, 2, 1}, {.12657072, .39817213, 1.51806128}, {.40619816, 3.31372639, .58072194}}};

Potentials compute(const Surface &surface, const Ellipsoid &ellipsoid, const Point<3> &centre)
{
  SurfaceMotion motion;
  for (const Point<3> &reference : surface.get_reference_points())
  {
    motion.positions.push_back(centre);
    for (unsigned int d = 0; d < 3; ++d)
      motion.positions.back()[d] += ellipsoid.axes[d] * reference[d];
  }
  return BoundaryElements(surface, MPI_COMM_WORLD).solve(motion).get_potentials();
}

double get_volume(const Ellipsoid &e)
{
  return 4. / 3. * numbers::PI * e.axes[0] * e.axes[1] * e.axes[2];
}

// The largest relative errors of translation and rotation.
std::pair<double, double> get_errors(const Ellipsoid &e, const Potentials &flow)
{
  double translation = 0., rotation = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double k = flow.added_mass(3 + d, 3 + d) / get_volume(e);
    const double I = flow.added_mass(d, d) / get_volume(e);
    translation    = std::max(translation, std::abs(k / e.k[d] - 1.));
    rotation       = std::max(rotation, std::abs(e.inertia[d] > 0. ? I / e.inertia[d] - 1. : I));
  }
  return {translation, rotation};
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                       is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const Surface                    surfaces[] = {Surface({3, 3}), Surface({6, 6}), Surface({8, 7})};

  for (const Ellipsoid &e : ellipsoids)
  {
    const auto [first_k, first_I]   = get_errors(e, compute(surfaces[0], e, Point<3>()));
    const auto [second_k, second_I] = get_errors(e, compute(surfaces[1], e, Point<3>()));
    const Potentials flow           = compute(surfaces[2], e, Point<3>());
    const auto [k, I]               = get_errors(e, flow);
    // The same, moved, so that z -> -z is no symmetry any more.
    const Point<3>   moved(0.1, 0.2, 0.3);
    const Potentials other = compute(surfaces[0], e, moved), base = compute(surfaces[0], e, {});
    double           difference = 0.;
    for (unsigned int i = 3; i < 6; ++i)
      for (unsigned int j = 3; j < 6; ++j)
        difference = std::max(difference, std::abs(other.added_mass(i, j) - base.added_mass(i, j)));
    if (is_root)
      std::cout << "axes " << e.axes[0] << ", " << e.axes[1] << ", " << e.axes[2] << " with "
                << surfaces[2].n_nodes() << " panels: translation " << as_multiple(1e-4, k)
                << ", rotation " << as_multiple(1e-4, I) << ", volume "
                << as_multiple(1e-5, flow.volume / get_volume(e) - 1.) << ", order "
                << with_two_decimals(std::log2(first_k / second_k)) << " and "
                << with_two_decimals(std::log2(first_I / second_I)) << ", without symmetry "
                << as_multiple(1e-5, difference / get_volume(e)) << std::endl;
  }
}
