#include <caudal/base/compatibility.h>
#include <caudal/viscous/grid_adaptation.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  GridAdaptation<dim>::GridAdaptation(parallel::distributed::Triangulation<dim> &triangulation,
                                      FluidSpace<dim>                           &space,
                                      const RefinementParameters                &parameters,
                                      const ImmersedSystem<dim>                 &system)
      : triangulation(triangulation)
      , space(space)
      , parameters(parameters)
      , system(system)
  {}

  template <int dim>
  CellSet<dim> GridAdaptation<dim>::make_body_cells(const double margin) const
  {
    CellSet<dim> cells(system.lattice);
    for (const auto &body : system.bodies)
    {
      // Where the body is now and where it will be in a step or two.
      Vector<double> next(body->solid.positions);
      next *= 2;
      next -= body->solid.old_positions;
      cells.add(body->solid.compute_cell_boxes(body->solid.positions),
                body->interaction.get_support() + margin);
      cells.add(body->solid.compute_cell_boxes(next), body->interaction.get_support() + margin);
    }
    return cells;
  }

  template <int dim>
  bool GridAdaptation<dim>::is_needed() const
  {
    // Half a cell more than the kernel's support, for what the prediction misses.
    return !make_body_cells(0.5).is_covered_by(triangulation);
  }

  template <int dim>
  bool GridAdaptation<dim>::set_flags(const CellSet<dim> &body_cells, const double time) const
  {
    const Vector<float> indicator = parameters.vorticity_threshold > 0
                                        ? compute_vorticity_indicator(space, system.fluid.velocity)
                                        : Vector<float>();
    flag_cells(triangulation, system.lattice, body_cells, indicator, parameters, time);
    triangulation.prepare_coarsening_and_refinement();
    int changes = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && (cell->refine_flag_set() || cell->coarsen_flag_set()))
        changes = 1;
    return Utilities::MPI::max(changes, compatibility::get_communicator(triangulation)) > 0;
  }

  template <int dim>
  void GridAdaptation<dim>::make_initial_grid()
  {
    const CellSet<dim> body_cells = make_body_cells(parameters.body_margin);
    for (unsigned int pass = 0;; ++pass)
    {
      space.reinit();
      space.set_boundary_values(0);
      system.fluid.reinit(space);
      set_initial_velocity(space, system.fluid);
      if (pass > system.lattice.get_finest_level() || !set_flags(body_cells, 0))
        break;
      triangulation.execute_coarsening_and_refinement();
    }
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      cell->clear_refine_flag();
      cell->clear_coarsen_flag();
    }
    set_up_operators();
  }

  template <int dim>
  void GridAdaptation<dim>::set_up_operators()
  {
    system.momentum.reinit();
    system.coupled_system.reinit();
    system.finest_cells = std::make_unique<FinestCells<dim>>(system.lattice, triangulation);
  }

  template <int dim>
  void GridAdaptation<dim>::transfer(const double time, const double old_time)
  {
    using Transfer = compatibility::SolutionTransfer<dim, FieldVector>;
    Transfer        velocity_transfer(space.velocity_dofs), pressure_transfer(space.pressure_dofs);
    FluidState<dim> old_state;
    old_state.velocity     = system.fluid.velocity;
    old_state.old_velocity = system.fluid.old_velocity;
    old_state.pressure     = system.fluid.pressure;
    old_state.update_ghost_values();
    velocity_transfer.prepare_for_coarsening_and_refinement(
        std::vector<const FieldVector *>{&old_state.velocity, &old_state.old_velocity});
    pressure_transfer.prepare_for_coarsening_and_refinement(old_state.pressure);
    triangulation.execute_coarsening_and_refinement();

    space.reinit();
    system.fluid.reinit(space);
    std::vector<FieldVector *> velocities = {&system.fluid.velocity, &system.fluid.old_velocity};
    velocity_transfer.interpolate(velocities);
    pressure_transfer.interpolate(system.fluid.pressure);
    space.set_boundary_values(old_time);
    space.constraints.distribute(system.fluid.old_velocity);
    space.set_boundary_values(time);
    space.constraints.distribute(system.fluid.velocity);
    system.fluid.update_ghost_values();
  }

  template <int dim>
  void GridAdaptation<dim>::project(FieldVector &velocity, const double step)
  {
    // The closest velocity u + du with B (u + du) = 0: M du + B^T q = 0.
    const double density = space.get_parameters().density;
    MomentumStep momentum_step;
    momentum_step.weights.inertia = density / step;
    momentum_step.weights.augmentation =
        momentum_step.weights.inertia * space.get_domain_size().norm_square();
    FieldVector  correction = space.make_velocity_vector();
    FieldVector  divergence = space.make_pressure_vector();
    const double scale =
        momentum_step.weights.inertia * space.get_mean_nodal_volume() * velocity.l2_norm();
    const bool matrix_changed =
        system.momentum.assemble(momentum_step, velocity, divergence, correction);
    correction = 0;
    system.momentum.compute_divergence(velocity, divergence);
    divergence *= -1;
    if (divergence.linfty_norm() == 0)
      return;
    system.coupled_system.solve(correction, divergence, {}, momentum_step.weights, scale,
                                matrix_changed);
    space.homogeneous_constraints.distribute(correction);
    velocity += correction;
    velocity.update_ghost_values();
  }

  template <int dim>
  AdaptationReport GridAdaptation<dim>::adapt(const double time, const double old_time,
                                              const double step)
  {
    AdaptationReport report;
    const auto       before = summarise_flow(space, system.fluid.velocity);
    {
      TimerOutput::Scope timer_section(system.timer, "adapt grid");
      const CellSet<dim> body_cells = make_body_cells(parameters.body_margin);
      // A pass refines by one level; a body may have come to where two are missing.
      for (unsigned int pass = 0; pass <= system.lattice.get_finest_level(); ++pass)
      {
        if ((pass > 0 && body_cells.is_covered_by(triangulation)) || !set_flags(body_cells, time))
          break;
        transfer(time, old_time);
        report.changed = true;
      }
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
    }
    report.n_cells = triangulation.n_global_active_cells();
    if (!report.changed)
      return report;
    set_up_operators();
    project(system.fluid.velocity, step);
    project(system.fluid.old_velocity, step);
    system.coupled_system.forget_factorisation();

    const auto after             = summarise_flow(space, system.fluid.velocity);
    report.kinetic_energy_change = after.kinetic_energy - before.kinetic_energy;
    double mass                  = space.get_parameters().density;
    for (unsigned int d = 0; d < dim; ++d)
      mass *= space.get_domain_size()[d];
    report.momentum_change = (after.momentum - before.momentum).norm() /
                             std::max(mass * before.largest_velocity, 1e-300);
    return report;
  }

  template class GridAdaptation<2>;
  template class GridAdaptation<3>;
} // namespace caudal
