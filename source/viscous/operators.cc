// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/domain.h>
#include <caudal/solid/interior.h>
#include <caudal/viscous/operators.h>
#include <caudal/viscous/size_check.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    Bodies<dim> make_bodies(const RunParameters<dim> &parameters, const MPI_Comm communicator)
    {
      check_sizes(parameters, communicator);
      Bodies<dim> bodies;
      for (const auto &body : parameters.bodies)
        bodies.push_back(std::make_unique<Body<dim>>(
            *body, Surroundings{parameters.fluid.density, parameters.domain.get_finest_cell()},
            parameters.fluid.gravity));
      check_fluid_size(parameters, bodies, communicator);
      return bodies;
    }

    /**
     * The coefficient of the grad-div term where the user gives none. In 3D it is limited to
     *   2 (3/2 / step) h^2,  h: spacing of the finest nodes,
     * about 3 U h where the flow passes a spacing in a step: beyond that it exceeds the inertia
     * more than ten times, and the iterative solver needs twice the iterations.
     */
    template <int dim>
    double get_automatic_grad_div(const RunParameters<dim> &parameters, const FlowScales &scales)
    {
      const double usual = scales.get_grad_div();
      if (dim == 2)
        return usual;
      const double spacing = 0.5 * parameters.domain.get_finest_cell();
      return std::min(usual, 3 / parameters.time.step * spacing * spacing);
    }

    template <int dim>
    std::vector<std::vector<bool>> find_interiors(const RunParameters<dim> &parameters,
                                                  const Bodies<dim>        &bodies)
    {
      std::vector<std::vector<bool>> interiors(bodies.size());
      if (parameters.refinement.interior_levels > 0)
        for (unsigned int b = 0; b < bodies.size(); ++b)
          interiors[b] =
              find_interior(bodies[b]->get_solid(), RefinementParameters::interior_depth *
                                                        parameters.domain.get_finest_cell());
      return interiors;
    }
  } // namespace

  template <int dim>
  Operators<dim>::Operators(const RunParameters<dim> &parameters, const MPI_Comm communicator)
      : parameters(parameters)
      , communicator(communicator)
      , lattice(parameters.domain)
      , coupling(parameters.coupling)
      , bodies(make_bodies(parameters, communicator))
      , interiors(find_interiors(parameters, bodies))
      , scales(estimate_scales(parameters, bodies))
      , triangulation(communicator)
      , space(triangulation, parameters.domain, parameters.fluid,
              parameters.fluid.get_grad_div().value_or(get_automatic_grad_div(parameters, scales)))
      , momentum(space)
      , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
      , solver(parameters.solver, space, momentum, timer)
  {
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
    cells = std::make_unique<ActiveCells<dim>>(
        lattice, triangulation,
        parameters.refinement.get_interior_level(lattice.get_finest_level()));
  }

  template <int dim>
  InteractionOperator<dim> Operators<dim>::compute_interaction(const unsigned int    b,
                                                               const Vector<double> &x,
                                                               const Instant        &instant) const
  {
    TimerOutput::Scope    timer_section(timer, "interaction operator");
    const SolidBody<dim> &solid = bodies[b]->get_solid();
    return InteractionOperator<dim>(
        coupling,
        {*cells, space.velocity_dofs, space.get_constraints(instant), space.get_velocity_layout()},
        {solid.get_dof_handler(), place_on_grid(solid, x, instant.origin),
         solid.get_parameters().get_surface_weight(), interiors[b], solid.get_name()});
  }

  template <int dim>
  double Operators<dim>::get_augmentation(const double inertia) const
  {
    if (solver.is_iterative())
      return 0;
    const double side = parameters.domain.get_shortest_side();
    return parameters.solver.augmentation * inertia * side * side;
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
