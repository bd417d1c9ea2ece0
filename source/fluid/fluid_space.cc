// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/fluid/fluid_space.h>

#include <caudal/base/collective.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <numeric>

namespace caudal
{
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
      , domain_size(domain.size)
      , boundary_conditions(parameters.create_boundary_conditions())
      , body_force_loads(parameters)
  {
    for (unsigned int level = 0; level < domain.levels; ++level)
      cell_matrices.emplace_back(velocity_element, pressure_element, domain.get_cell_size(level));
  }

  template <int dim>
  void FluidSpace<dim>::reinit()
  {
    body_force_loads.clear();
    velocity_dofs.distribute_dofs(velocity_element);
    pressure_dofs.distribute_dofs(pressure_element);
    homogeneous_constraints.copy_from(make_constraints(0, true));
    constraints_time.reset();
    for (auto [dofs, layout] : {std::make_pair(&velocity_dofs, &velocity_layout),
                                std::make_pair(&pressure_dofs, &pressure_layout)})
      *layout = std::make_shared<Utilities::MPI::Partitioner>(
          dofs->locally_owned_dofs(), DoFTools::extract_locally_relevant_dofs(*dofs),
          get_communicator());
  }

  template <int dim>
  const AffineConstraints<double> &FluidSpace<dim>::get_constraints(const double time) const
  {
    if (std::none_of(boundary_conditions.begin(), boundary_conditions.end(),
                     [](const auto &condition) { return condition->has_velocity(); }))
      return homogeneous_constraints;
    if (constraints_time != time)
    {
      constraints.copy_from(make_constraints(time, false));
      constraints_time = time;
    }
    return constraints;
  }

  template <int dim>
  AffineConstraints<double> FluidSpace<dim>::make_constraints(const double time,
                                                              const bool   homogeneous) const
  {
    AffineConstraints<double> result = compatibility::make_constraints(
        velocity_dofs.locally_owned_dofs(), DoFTools::extract_locally_relevant_dofs(velocity_dofs));
    DoFTools::make_hanging_node_constraints(velocity_dofs, result);

    std::vector<unsigned int> sides(boundary_conditions.size());
    std::iota(sides.begin(), sides.end(), 0);
    std::stable_sort(sides.begin(), sides.end(), [&](const unsigned int a, const unsigned int b) {
      return boundary_conditions[a]->get_rank() < boundary_conditions[b]->get_rank();
    });
    run_on_all(get_communicator(), [&]() {
      for (const unsigned int side : sides)
      {
        const ComponentMask components =
            boundary_conditions[side]->get_prescribed_components(/*normal=*/side / 2);
        if (components.n_selected_components(dim) == 0)
          continue;
        const std::unique_ptr<Function<dim>> velocity =
            homogeneous ? std::make_unique<Functions::ZeroFunction<dim>>(dim)
                        : boundary_conditions[side]->make_velocity(time);
        VectorTools::interpolate_boundary_values(velocity_dofs, side, *velocity, result,
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
      volume *= domain_size[d];
    return volume * dim / velocity_dofs.n_dofs();
  }

  template class FluidSpace<2>;
  template class FluidSpace<3>;
} // namespace caudal
