// SPDX-License-Identifier: LGPL-2.1-or-later
// Adapting the grid, by refining and by coarsening: what the transfer of the
// velocity does to mass (its discrete divergence), momentum and energy.

#include "../round_off.h"
#include <caudal/viscous/adaptation.h>

#include <iomanip>
#include <iostream>

using namespace caudal;

namespace
{
  template <int dim>
  void test()
  {
    // A vortex in the left half of the box, carried by a stream.
    RunParameters<dim> parameters(nullptr);
    parameters.bodies.clear();
    parameters.domain.cells  = std::vector<unsigned int>(dim, dim == 2 ? 8 : 4);
    parameters.domain.levels = 3;
    parameters.fluid.density = 2;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      parameters.fluid.sides[side].set_name(side < 2 ? "inflow" : "free slip");
    parameters.fluid.inflow.velocity  = dim == 2 ? "1; 0" : "1; 0; 0";
    parameters.fluid.initial_velocity = "1+if(x<0.5,sin(2*pi*x)^2*sin(2*pi*y),0);"
                                        "-if(x<0.5,2*sin(4*pi*x)*sin(pi*y)^2,0)";
    if (dim == 3)
      parameters.fluid.initial_velocity += ";0";
    parameters.refinement.vorticity_threshold     = 1.6;
    parameters.refinement.largest_number_of_cells = 4000;
    parameters.time.step                          = 0.01;

    Operators<dim> operators(parameters, MPI_COMM_WORLD);
    State<dim>     state     = make_initial_state(operators);
    const bool     is_root   = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const bool     is_needed = adaptation_is_needed(operators, state);
    if (is_root)
      std::cout << std::setprecision(7) << dim << "D: adaptation needed " << is_needed << '\n';

    // The first adaptation makes the velocity discretely divergence-free; then
    // cells are refined by a smaller threshold and coarsened by a larger one.
    parameters.refinement.vorticity_threshold = dim == 2 ? 0.4 : 0.8;
    adapt(operators, state);
    for (const double threshold : {0.2, 8.})
    {
      parameters.refinement.vorticity_threshold = threshold;
      state.fluid.old_velocity                  = state.fluid.velocity;
      state.fluid.update_ghost_values();
      const auto             before  = summarise_flow(operators.space, state.fluid.velocity);
      const unsigned int     n_cells = operators.triangulation.n_global_active_cells();
      const AdaptationReport report  = adapt(operators, state);
      const auto             after   = summarise_flow(operators.space, state.fluid.velocity);

      const double divergence =
          operators.momentum.compute_divergence(state.fluid.velocity).linfty_norm();
      const double old_divergence =
          operators.momentum.compute_divergence(state.fluid.old_velocity).linfty_norm();
      if (is_root)
        std::cout << "  threshold " << threshold << ": from " << n_cells << " cells to "
                  << report.n_cells << ", divergence " << in_units(1e-9, divergence) << " and "
                  << in_units(1e-9, old_divergence) << ", momentum off by "
                  << in_units(1e-8,
                              (after.momentum - before.momentum).norm() / before.momentum.norm())
                  << ", energy times " << after.kinetic_energy / before.kinetic_energy
                  << ", reported but for "
                  << in_units(1e-12, after.kinetic_energy - before.kinetic_energy -
                                         report.kinetic_energy_change)
                  << '\n';
    }

    // The number of cells is bounded, nearly, also after they have become too many.
    parameters.refinement.vorticity_threshold = 0.2;
    adapt(operators, state);
    const unsigned int n_most = 2 * operators.triangulation.n_global_active_cells() / 3;
    parameters.refinement.largest_number_of_cells = n_most;
    for (unsigned int k = 0; k < 3; ++k)
      adapt(operators, state);
    const unsigned int n_cells = operators.triangulation.n_global_active_cells();
    if (is_root)
      std::cout << "  bounded by " << n_most << ": " << n_cells << " cells\n";
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
