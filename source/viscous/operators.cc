// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/domain.h>
#include <caudal/viscous/operators.h>

namespace caudal
{
  template <int dim>
  Operators<dim>::Operators(const RunParameters<dim> &parameters, const MPI_Comm communicator)
      : parameters(parameters)
      , communicator(communicator)
      , lattice(parameters.domain)
      , coupling(parameters.coupling)
      , triangulation(communicator)
      , space(triangulation, parameters.domain, parameters.fluid)
      , momentum(space)
      , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
      , solver(parameters.solver, space, momentum, timer)
  {
    for (const auto &body : parameters.bodies)
      bodies.push_back(std::make_unique<Body<dim>>(*body, parameters.fluid.density));
    make_domain(triangulation, parameters.domain);
    AssertThrow(
        triangulation.n_global_active_cells() >= Utilities::MPI::n_mpi_processes(communicator),
        ExcMessage("Domain/Cells: there are " +
                   std::to_string(Utilities::MPI::n_mpi_processes(communicator)) +
                   " ranks, but only " + std::to_string(triangulation.n_global_active_cells()) +
                   " coarse cells. Run on fewer ranks or give more cells."));
  }

  template <int dim>
  void Operators<dim>::reinit()
  {
    make_canonical(triangulation, parameters.domain);
    space.reinit();
    momentum.reinit();
    solver.reinit();
    finest_cells = std::make_unique<FinestCells<dim>>(lattice, triangulation);
  }

  template <int dim>
  InteractionOperator<dim> Operators<dim>::compute_interaction(const unsigned int    b,
                                                               const Vector<double> &x,
                                                               const double          time) const
  {
    TimerOutput::Scope timer_section(timer, "interaction operator");
    return InteractionOperator<dim>(coupling,
                                    {*finest_cells, space.velocity_dofs,
                                     space.get_constraints(time), space.get_velocity_layout()},
                                    bodies[b]->get_solid().get_dof_handler(), x,
                                    bodies[b]->get_name());
  }

  template <int dim>
  double Operators<dim>::get_augmentation(const double inertia) const
  {
    const Tensor<1, dim> &size     = parameters.domain.size;
    double                smallest = size[0];
    for (unsigned int d = 1; d < dim; ++d)
      smallest = std::min(smallest, size[d]);
    return parameters.solver.augmentation * inertia * smallest * smallest;
  }

  template <int dim>
  BoundingBox<dim> Operators<dim>::get_domain() const
  {
    const Point<dim> &lower = parameters.domain.lower_corner;
    const Point<dim>  upper = lower + parameters.domain.size;
    return BoundingBox<dim>({lower, upper});
  }

  template class Operators<2>;
  template class Operators<3>;
} // namespace caudal
