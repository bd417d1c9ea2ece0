// Adapting the grid, by refining and by coarsening: what the transfer of the
// velocity does to mass (its discrete divergence), momentum and energy.

#include <caudal/viscous/adaptation.h>
#include <caudal/viscous/advance.h>

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
      std::cout << dim << "D: adaptation needed " << is_needed << '\n';

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
        std::cout << "  threshold " << threshold << ": "
                  << (report.n_cells > n_cells ? "more" : "fewer") << " cells, divergence "
                  << (divergence < 1e-9) << (old_divergence < 1e-9) << ", momentum "
                  << ((after.momentum - before.momentum).norm() < 1e-8 * before.momentum.norm())
                  << ", energy "
                  << (std::abs(after.kinetic_energy / before.kinetic_energy - 1) < 1e-3)
                  << ", both as reported "
                  << (std::abs(after.kinetic_energy - before.kinetic_energy -
                               report.kinetic_energy_change) < 1e-12)
                  << '\n';
    }

    // The number of cells is bounded also after they have become too many.
    parameters.refinement.vorticity_threshold = 0.2;
    adapt(operators, state);
    const unsigned int n_most = 2 * operators.triangulation.n_global_active_cells() / 3;
    parameters.refinement.largest_number_of_cells = n_most;
    for (unsigned int k = 0; k < 3; ++k)
      adapt(operators, state);
    const unsigned int n_cells = operators.triangulation.n_global_active_cells();
    if (is_root)
      std::cout << "  bounded " << (n_cells < 1.05 * n_most && n_cells > 0.8 * n_most) << '\n';
  }

  /**
   * Refined cells that move to their mirror image at t = 0.01 s and back later, beside the line
   * where the two ranks meet, leave each rank's number of unknowns as it is, but not where they
   * are: fields and their ghost entries have to follow. A plane shear flow, which is steady,
   * survives exactly.
   */
  void test_moving_refinement(const std::string &scheme)
  {
    constexpr int      dim = 2;
    RunParameters<dim> parameters(nullptr);
    parameters.bodies.clear();
    parameters.domain.size[0] = 2;
    parameters.domain.cells   = {2, 1};
    parameters.domain.levels  = 4;
    for (auto &side : parameters.fluid.sides)
      side.set_name("inflow");
    parameters.fluid.inflow.velocity          = "1+y; 0";
    parameters.fluid.initial_velocity         = parameters.fluid.inflow.velocity;
    parameters.refinement.vorticity_threshold = 0;

    parameters.time.scheme   = scheme;
    parameters.time.end_time = 1;
    parameters.time.step     = 0.01;
    parameters.refinement.level_expression =
        "2+(abs(x-1)<0.25)*if(abs(t-0.01)<0.005, (y>0.5)*(y<0.75), (y>0.25)*(y<0.5))";
    Operators<dim>  operators(parameters, MPI_COMM_WORLD);
    State<dim>      state = make_initial_state(operators);
    FluidState<dim> exact;
    const IndexSet  owned = operators.space.velocity_dofs.locally_owned_dofs();

    double     error      = 0;
    int        same_range = 1, at_place = 1;
    const auto step    = [&] { state = advance(operators, state, state.time.get_step()).state; };
    const auto compare = [&] {
      exact.reinit(operators.space);
      set_initial_velocity(operators.space, exact);
      exact.velocity -= state.fluid.velocity;
      error = std::max(error, exact.velocity.linfty_norm());
    };
    for (const bool is_above : {true, false})
    {
      step();
      compare();
      adapt(operators, state);
      same_range = same_range && operators.space.velocity_dofs.locally_owned_dofs() == owned;
      for (const auto &cell : operators.triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->level() == 3)
          at_place = at_place && (cell->center()[1] > 0.5) == is_above;
      compare();
    }
    step();
    compare();
    same_range = Utilities::MPI::min(same_range, MPI_COMM_WORLD);
    at_place   = Utilities::MPI::min(at_place, MPI_COMM_WORLD);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << "Moving refinement, " << scheme << ": ranges as before " << same_range
                << ", refined where it is asked for " << at_place << ", flow unchanged "
                << (error < 1e-6) << '\n';
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  test_moving_refinement("semi-implicit");
  test_moving_refinement("explicit");
}
