// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/fluid_state.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  void FluidState<dim>::reinit(const FluidSpace<dim> &space)
  {
    for (FieldVector *field : get_velocities())
      field->reinit(space.make_velocity_vector());
    pressure.reinit(space.make_pressure_vector());
  }

  template <int dim>
  void FluidState<dim>::update_ghost_values() const
  {
    for (const FieldVector *field : get_velocities())
      field->update_ghost_values();
    pressure.update_ghost_values();
  }

  template <int dim>
  FlowSummary<dim> summarise_flow(const FluidSpace<dim> &space, const FieldVector &velocity,
                                  const Tensor<1, dim> &grid_velocity)
  {
    const FESystem<dim>        &element    = space.velocity_element;
    const auto                 &parameters = space.get_parameters();
    const unsigned int          n = element.n_dofs_per_cell(), n_s = n / dim;
    Vector<double>              values(n), scalar(n_s), product(n_s), grad_div_product(n);
    std::vector<Tensor<1, dim>> nodal(n_s);
    FlowSummary<dim>            summary;
    double                      divergence = 0;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const CellMatrices<dim> &matrices = space.get_cell_matrices(cell->level());
        cell->get_dof_values(velocity, values);
        for (unsigned int d = 0; d < dim; ++d)
        {
          for (unsigned int s = 0; s < n_s; ++s)
            nodal[s][d] = scalar[s] = values[element.component_to_system_index(d, s)];
          matrices.get_mass().vmult(product, scalar);
          summary.kinetic_energy += 0.5 * parameters.density * (scalar * product);
          summary.momentum[d] += parameters.density * product.size() * product.mean_value();
          matrices.get_stiffness().vmult(product, scalar);
          summary.viscous_dissipation += parameters.get_viscosity() * (scalar * product);
        }
        matrices.get_grad_div().vmult(grad_div_product, values);
        divergence += values * grad_div_product;
        for (const Tensor<1, dim> &u : nodal)
        {
          summary.largest_velocity = std::max(summary.largest_velocity, u.norm());
          for (unsigned int d = 0; d < dim; ++d)
            summary.largest_rate =
                std::max(summary.largest_rate,
                         std::abs(u[d] - grid_velocity[d]) / (0.5 * matrices.get_cell_size()[d]));
        }
      }
    MPI_Comm communicator       = space.get_communicator();
    summary.kinetic_energy      = Utilities::MPI::sum(summary.kinetic_energy, communicator);
    summary.viscous_dissipation = Utilities::MPI::sum(summary.viscous_dissipation, communicator);
    summary.largest_velocity    = Utilities::MPI::max(summary.largest_velocity, communicator);
    summary.largest_rate        = Utilities::MPI::max(summary.largest_rate, communicator);
    summary.momentum            = Utilities::MPI::sum(summary.momentum, communicator);
    divergence                  = Utilities::MPI::sum(divergence, communicator);
    // Round-off can make a vanishing sum of squares negative.
    summary.divergence_norm = std::sqrt(std::max(divergence, 0.));
    summary.grad_div_dissipation =
        parameters.density * space.get_grad_div() * std::max(divergence, 0.);
    return summary;
  }

  template <int dim>
  double compute_kinetic_energy(const FluidSpace<dim> &space, const FieldVector &velocity)
  {
    const FESystem<dim> &element = space.velocity_element;
    const unsigned int   n = element.n_dofs_per_cell(), n_s = n / dim;
    Vector<double>       values(n), scalar(n_s), product(n_s);
    double               energy = 0;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_values(velocity, values);
        for (unsigned int d = 0; d < dim; ++d)
        {
          for (unsigned int s = 0; s < n_s; ++s)
            scalar[s] = values[element.component_to_system_index(d, s)];
          space.get_cell_matrices(cell->level()).get_mass().vmult(product, scalar);
          energy += 0.5 * space.get_parameters().density * (scalar * product);
        }
      }
    return Utilities::MPI::sum(energy, space.get_communicator());
  }

  template <int dim>
  double compute_stabilisation_dissipation(const FluidSpace<dim> &space,
                                           const FieldVector &velocity, const double rate,
                                           const Tensor<1, dim> &grid_velocity)
  {
    const auto    &parameters = space.get_parameters();
    Vector<double> values(space.velocity_element.n_dofs_per_cell());
    double         dissipation = 0;
    if (parameters.convection_stabilisation > 0)
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_values(velocity, values);
          dissipation += space.get_cell_matrices(cell->level())
                             .compute_stabilisation_dissipation(values, parameters.density,
                                                                parameters.convection_stabilisation,
                                                                rate, grid_velocity);
        }
    return Utilities::MPI::sum(dissipation, space.get_communicator());
  }

#define INSTANTIATE(dim)                                                                           \
  template struct FluidState<dim>;                                                                 \
  template FlowSummary<dim> summarise_flow(const FluidSpace<dim> &, const FieldVector &,           \
                                           const Tensor<1, dim> &);                                \
  template double           compute_kinetic_energy(const FluidSpace<dim> &, const FieldVector &);  \
  template double compute_stabilisation_dissipation(const FluidSpace<dim> &, const FieldVector &,  \
                                                    double, const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
