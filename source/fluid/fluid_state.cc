// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/fluid_state.h>

#include <caudal/base/collective.h>
#include <caudal/base/expression.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  void FluidState<dim>::reinit(const FluidSpace<dim> &space)
  {
    velocity.reinit(space.make_velocity_vector());
    old_velocity.reinit(velocity);
    pressure.reinit(space.make_pressure_vector());
  }

  template <int dim>
  void FluidState<dim>::update_ghost_values() const
  {
    velocity.update_ghost_values();
    old_velocity.update_ghost_values();
    pressure.update_ghost_values();
  }

  template <int dim>
  void set_initial_velocity(const FluidSpace<dim> &space, FluidState<dim> &state)
  {
    VectorTools::interpolate(
        space.velocity_dofs,
        Expression<dim>("Fluid/Initial velocity", space.get_parameters().initial_velocity, dim),
        state.velocity);
    space.get_constraints(0).distribute(state.velocity);
    state.update_ghost_values();
  }

  template <int dim>
  FlowSummary<dim> summarise_flow(const FluidSpace<dim> &space, const FieldVector &velocity)
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
            summary.largest_rate = std::max(summary.largest_rate,
                                            std::abs(u[d]) / (0.5 * matrices.get_cell_size()[d]));
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
        parameters.density * parameters.grad_div * std::max(divergence, 0.);
    return summary;
  }

  template <int dim>
  double compute_stabilisation_dissipation(const FluidSpace<dim> &space,
                                           const FieldVector &velocity, const double rate)
  {
    const auto    &parameters = space.get_parameters();
    Vector<double> values(space.velocity_element.n_dofs_per_cell());
    double         dissipation = 0;
    if (parameters.convection_stabilisation > 0)
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_values(velocity, values);
          dissipation +=
              space.get_cell_matrices(cell->level())
                  .compute_stabilisation_dissipation(values, parameters.density,
                                                     parameters.convection_stabilisation, rate);
        }
    return Utilities::MPI::sum(dissipation, space.get_communicator());
  }

  template <int dim>
  ProbeValues<dim> evaluate_at(const FluidSpace<dim> &space, const FluidState<dim> &state,
                               const Point<dim> &point)
  {
    Vector<double>   velocities(space.velocity_element.n_dofs_per_cell());
    Vector<double>   pressures(space.pressure_element.n_dofs_per_cell());
    ProbeValues<dim> sum;
    double           n_cells = 0;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        // Place in the cell, which is a box; a little outside is on its side.
        Point<dim> place;
        bool       is_inside = true;
        for (unsigned int d = 0; d < dim; ++d)
        {
          place[d]  = (point[d] - cell->vertex(0)[d]) / space.get_cell_size(cell->level())[d];
          is_inside = is_inside && place[d] > -1e-8 && place[d] < 1 + 1e-8;
        }
        if (!is_inside)
          continue;
        ++n_cells;
        cell->get_dof_values(state.velocity, velocities);
        for (unsigned int i = 0; i < velocities.size(); ++i)
          sum.velocity[space.velocity_element.system_to_component_index(i).first] +=
              velocities[i] * space.velocity_element.shape_value(i, place);
        typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs)
            ->get_dof_values(state.pressure, pressures);
        for (unsigned int i = 0; i < pressures.size(); ++i)
          sum.pressure += pressures[i] * space.pressure_element.shape_value(i, place);
      }
    MPI_Comm communicator = space.get_communicator();
    n_cells               = Utilities::MPI::sum(n_cells, communicator);
    Assert(n_cells > 0, ExcMessage("The point is outside of the domain."));
    ProbeValues<dim> mean;
    mean.velocity = Utilities::MPI::sum(sum.velocity, communicator) / n_cells;
    mean.pressure = Utilities::MPI::sum(sum.pressure, communicator) / n_cells;
    return mean;
  }

  namespace
  {
    /** The vorticity of a velocity gradient, as a vector with one or three components. */
    template <int dim>
    Tensor<1, dim == 2 ? 1 : 3> compute_vorticity(const Tensor<2, dim> &gradient)
    {
      Tensor<1, dim == 2 ? 1 : 3> vorticity;
      if constexpr (dim == 2)
        vorticity[0] = gradient[1][0] - gradient[0][1];
      else
        for (unsigned int d = 0; d < 3; ++d)
          vorticity[d] = gradient[(d + 2) % 3][(d + 1) % 3] - gradient[(d + 1) % 3][(d + 2) % 3];
      return vorticity;
    }
  } // namespace

  template <int dim>
  Vector<float> compute_vorticity_indicator(const FluidSpace<dim> &space,
                                            const FieldVector     &velocity)
  {
    Vector<float>               indicator(space.get_triangulation().n_active_cells());
    FEValues<dim>               values(space.velocity_element, QGauss<dim>(2), update_gradients);
    std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        values.reinit(cell);
        values[FEValuesExtractors::Vector(0)].get_function_gradients(velocity, gradients);
        const double h = space.get_cell_size(cell->level()).norm() / std::sqrt(dim);
        for (const Tensor<2, dim> &gradient : gradients)
          indicator[cell->active_cell_index()] = std::max<float>(
              indicator[cell->active_cell_index()], h * compute_vorticity(gradient).norm());
      }
    return indicator;
  }

  template <int dim>
  void VorticityPostprocessor<dim>::evaluate_vector_field(
      const DataPostprocessorInputs::Vector<dim> &input,
      std::vector<Vector<double>>                &quantities) const
  {
    for (unsigned int q = 0; q < quantities.size(); ++q)
    {
      Tensor<2, dim> gradient;
      for (unsigned int d = 0; d < dim; ++d)
        gradient[d] = input.solution_gradients[q][d];
      const auto vorticity = compute_vorticity(gradient);
      for (unsigned int d = 0; d < quantities[q].size(); ++d)
        quantities[q][d] = vorticity[d];
    }
  }

  template <int dim>
  std::vector<std::string> VorticityPostprocessor<dim>::get_names() const
  {
    return std::vector<std::string>(dim == 2 ? 1 : 3, "vorticity");
  }

  template <int dim>
  std::vector<DataComponentInterpretation::DataComponentInterpretation>
  VorticityPostprocessor<dim>::get_data_component_interpretation() const
  {
    if (dim == 2)
      return {DataComponentInterpretation::component_is_scalar};
    return std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        3, DataComponentInterpretation::component_is_part_of_vector);
  }

  template <int dim>
  UpdateFlags VorticityPostprocessor<dim>::get_needed_update_flags() const
  {
    return update_gradients;
  }

#define INSTANTIATE(dim)                                                                           \
  template struct FluidState<dim>;                                                                 \
  template void             set_initial_velocity(const FluidSpace<dim> &, FluidState<dim> &);      \
  template FlowSummary<dim> summarise_flow(const FluidSpace<dim> &, const FieldVector &);          \
  template double compute_stabilisation_dissipation(const FluidSpace<dim> &, const FieldVector &,  \
                                                    double);                                       \
  template ProbeValues<dim> evaluate_at(const FluidSpace<dim> &, const FluidState<dim> &,          \
                                        const Point<dim> &);                                       \
  template Vector<float>    compute_vorticity_indicator(const FluidSpace<dim> &,                   \
                                                        const FieldVector &);                      \
  template class VorticityPostprocessor<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
