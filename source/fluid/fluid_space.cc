// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/compatibility.h>
#include <caudal/fluid/boundary_flux.h>
#include <caudal/fluid/fluid_space.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace caudal
{
  namespace
  {
    // What is left of sums that cancel, beside the flux either way; beside the outflow, what can be
    // a mistake of a profile's digits but not of the case.
    constexpr double round_off = 1e-13, largest_imbalance = 1e-2;
  } // namespace

  template <int dim>
  FluidSpace<dim>::FluidSpace(parallel::distributed::Triangulation<dim> &triangulation,
                              const DomainParameters<dim>               &domain,
                              const FluidParameters<dim> &parameters, const double grad_div)
      : velocity_element(FE_Q<dim>(2), dim)
      , pressure_element(1)
      , velocity_dofs(triangulation)
      , pressure_dofs(triangulation)
      , triangulation(triangulation)
      , parameters(parameters)
      , grad_div(grad_div)
      , domain(domain)
      , boundary_conditions(parameters.create_boundary_conditions())
      , body_force_loads(parameters)
      , side_loads(boundary_conditions)
  {
    for (unsigned int level = 0; level < domain.levels; ++level)
      cell_matrices.emplace_back(velocity_element, pressure_element, domain.get_cell_size(level));
  }

  template <int dim>
  void FluidSpace<dim>::reinit()
  {
    body_force_loads.clear();
    side_loads.clear();
    velocity_dofs.distribute_dofs(velocity_element);
    pressure_dofs.distribute_dofs(pressure_element);
    homogeneous_constraints.copy_from(make_constraints(
        [](const unsigned int) { return std::make_unique<Functions::ZeroFunction<dim>>(dim); }));
    constraints_instant.reset();
    for (auto [dofs, layout] : {std::make_pair(&velocity_dofs, &velocity_layout),
                                std::make_pair(&pressure_dofs, &pressure_layout)})
      *layout = std::make_shared<Utilities::MPI::Partitioner>(
          dofs->locally_owned_dofs(), DoFTools::extract_locally_relevant_dofs(*dofs),
          get_communicator());
  }

  template <int dim>
  const AffineConstraints<double> &FluidSpace<dim>::get_constraints(const Instant &instant) const
  {
    if (!has_velocity())
      return homogeneous_constraints;
    if (!constraints_instant || *constraints_instant != instant)
    {
      constraints_instant.reset(); // until they are whole
      constraints.copy_from(make_constraints(instant, 1));
      outflow_factor = balances_fluxes() ? compute_outflow_factor(instant) : 1;
      if (outflow_factor != 1)
        constraints.copy_from(make_constraints(instant, outflow_factor));
      constraints_instant = instant;
    }
    return constraints;
  }

  template <int dim>
  bool FluidSpace<dim>::has_velocity() const
  {
    return std::any_of(boundary_conditions.begin(), boundary_conditions.end(),
                       [](const auto &condition) { return condition->has_velocity(); });
  }

  template <int dim>
  bool FluidSpace<dim>::balances_fluxes() const
  {
    return has_velocity() &&
           std::none_of(boundary_conditions.begin(), boundary_conditions.end(),
                        [](const auto &condition) { return condition->is_open(); });
  }

  template <int dim>
  double FluidSpace<dim>::get_outflow_factor(const Instant &instant) const
  {
    get_constraints(instant);
    return outflow_factor;
  }

  template <int dim>
  double FluidSpace<dim>::compute_outflow_factor(const Instant &instant) const
  {
    const BoundaryFlux flux = compute_boundary_flux(*this, constraints); // with a factor of one
    if (std::abs(flux.net) <= round_off * flux.total)
      return 1;
    // The flux is linear in the factor.
    const double       inflow  = -compute_boundary_flux(*this, make_constraints(instant, 0)).net;
    const double       outflow = flux.net + inflow;
    std::ostringstream text;
    text << "Fluid/Boundary conditions: at t = " << instant.time
         << " s the prescribed velocities let " << std::abs(flux.net)
         << (dim == 2 ? " m^2/s" : " m^3/s") << " more "
         << (flux.net < 0 ? "in than out" : "out than in")
         << ", and no side is open: there is no incompressible flow. Set a side to outflow, or "
            "give velocities whose fluxes cancel.";
    AssertThrow(!(std::abs(flux.net) > largest_imbalance * outflow), ExcMessage(text.str()));
    return inflow / outflow;
  }

  template <int dim>
  AffineConstraints<double> FluidSpace<dim>::make_constraints(const Instant &instant,
                                                              const double   factor) const
  {
    return make_constraints([&](const unsigned int side) {
      return std::make_unique<ScaledOutflow<dim>>(
          std::make_unique<FunctionOnGrid<dim>>(
              boundary_conditions[side]->make_velocity(instant.time), instant.origin),
          side, factor);
    });
  }

  template <int dim>
  void FluidSpace<dim>::add_uniform(const Tensor<1, dim> &velocity, FieldVector &field) const
  {
    const unsigned int                   n = velocity_element.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n);
    FieldVector                          uniform = make_velocity_vector();
    for (const auto &cell : velocity_dofs.active_cell_iterators())
    {
      if (cell->is_artificial())
        continue;
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < n; ++i)
        if (uniform.in_local_range(dofs[i]))
          uniform[dofs[i]] = velocity[velocity_element.system_to_component_index(i).first];
    }
    field += uniform;
    field.update_ghost_values();
  }

  template <int dim>
  AffineConstraints<double> FluidSpace<dim>::make_constraints(const Velocities &velocities) const
  {
    AffineConstraints<double> result = compatibility::make_constraints(
        velocity_dofs.locally_owned_dofs(), DoFTools::extract_locally_relevant_dofs(velocity_dofs));
    DoFTools::make_hanging_node_constraints(velocity_dofs, result);
    for (unsigned int d = 0; d < dim; ++d)
      if (domain.is_periodic(d))
        DoFTools::make_periodicity_constraints(velocity_dofs, 2 * d, 2 * d + 1, d, result);

    std::vector<unsigned int> sides(boundary_conditions.size());
    std::iota(sides.begin(), sides.end(), 0);
    std::stable_sort(sides.begin(), sides.end(), [&](const unsigned int a, const unsigned int b) {
      return boundary_conditions[a]->get_rank() < boundary_conditions[b]->get_rank();
    });
    run_on_all(get_communicator(), [&]() {
      for (const unsigned int side : sides)
      {
        if (domain.is_periodic(side / 2))
          continue;
        const ComponentMask components =
            boundary_conditions[side]->get_prescribed_components(/*normal=*/side / 2);
        if (components.n_selected_components(dim) == 0)
          continue;
        VectorTools::interpolate_boundary_values(velocity_dofs, side, *velocities(side), result,
                                                 components);
      }
    });
    result.close();
    return result;
  }

  template <int dim>
  double FluidSpace<dim>::get_mean_nodal_volume() const
  {
    double volume = 1;
    for (unsigned int d = 0; d < dim; ++d)
      volume *= domain.size[d];
    return volume * dim / velocity_dofs.n_dofs();
  }

  template class FluidSpace<2>;
  template class FluidSpace<3>;
} // namespace caudal
