// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrix of the divergence on a grid with hanging nodes: int div u dx of a field that it
// represents exactly, by the matrix and by its transpose, whatever stands in constrained entries.

#include <caudal/fluid/cellwise_matrix.h>
#include <caudal/fluid/fluid_space.h>
#include <caudal/mesh/domain.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <iostream>

using namespace caudal;

namespace
{
  /** u_d = x_d^2, whose divergence is 2 (x + y + z). */
  template <int dim>
  class Squares : public Function<dim>
  {
  public:
    Squares()
        : Function<dim>(dim)
    {}

    double value(const Point<dim> &x, const unsigned int d) const override
    {
      return x[d] * x[d];
    }
  };

  template <int dim>
  void test()
  {
    DomainParameters<dim> domain;
    domain.cells  = std::vector<unsigned int>(dim, 2);
    domain.levels = 2;
    const FluidParameters<dim>                fluid;
    parallel::distributed::Triangulation<dim> triangulation(MPI_COMM_WORLD);
    make_domain(triangulation, domain);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[0] < 0.5)
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
    FluidSpace<dim> space(triangulation, domain, fluid, /*grad_div=*/1);
    space.reinit();
    AffineConstraints<double> hanging_nodes = compatibility::make_constraints(
        space.velocity_dofs.locally_owned_dofs(),
        DoFTools::extract_locally_relevant_dofs(space.velocity_dofs));
    DoFTools::make_hanging_node_constraints(space.velocity_dofs, hanging_nodes);
    hanging_nodes.close();
    CellwiseMatrix divergence;
    divergence.reinit(space.pressure_dofs, space.velocity_dofs, hanging_nodes);
    std::vector<FullMatrix<double>> matrices;
    for (unsigned int level = 0; level < triangulation.n_global_levels(); ++level)
      matrices.push_back(space.get_cell_matrices(level).get_divergence());
    divergence.set_level_matrices(matrices);

    FieldVector velocity = space.make_velocity_vector(), gradient = space.make_velocity_vector();
    VectorTools::interpolate(space.velocity_dofs, Squares<dim>(), velocity);
    unsigned int n_constrained = 0;
    for (const auto dof : space.velocity_dofs.locally_owned_dofs())
      if (hanging_nodes.is_constrained(dof))
      {
        velocity[dof] = 1e3;
        ++n_constrained;
      }

    // The pressure 1: the first basis function of each cell.
    FieldVector one = space.make_pressure_vector(), moments = space.make_pressure_vector();
    std::vector<types::global_dof_index> dofs(space.pressure_element.n_dofs_per_cell());
    for (const auto &cell : space.pressure_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(dofs);
        one[dofs[0]] = 1;
      }

    divergence.vmult(moments, velocity);
    const double by_matrix = one * moments;
    divergence.Tvmult_add(gradient, one);
    const double by_transpose = gradient * velocity;
    divergence.Tvmult_add(gradient, one);
    const double twice = gradient * velocity;
    n_constrained      = Utilities::MPI::sum(n_constrained, MPI_COMM_WORLD);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << dim << "D: " << n_constrained << " constrained velocities, int div u "
                << by_matrix << ", by the transpose " << by_transpose << ", added " << twice
                << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
