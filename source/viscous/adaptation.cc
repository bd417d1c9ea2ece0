// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/base/expression.h>
#include <caudal/fluid/fluid_snapshot.h>
#include <caudal/viscous/adaptation.h>
#include <caudal/viscous/size_check.h>
#include <caudal/viscous/step_parts.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    template <int dim>
    CellSet<dim> make_body_cells(const Operators<dim>         &operators,
                                 const std::vector<BodyState> &states, const Frame &frame,
                                 const double margin)
    {
      CellSet<dim>       cells(operators.lattice);
      const double       reach  = operators.coupling.get_support() + margin;
      const unsigned int finest = operators.lattice.get_finest_level();
      const auto         add    = [&](const std::vector<BoundingBox<dim>> &boxes,
                           const std::vector<bool>             &interior) {
        std::vector<BoundingBox<dim>> at_surface, deep;
        for (unsigned int c = 0; c < boxes.size(); ++c)
          (!interior.empty() && interior[c] ? deep : at_surface).push_back(boxes[c]);
        cells.add(at_surface, reach, finest);
        cells.add(deep, 0, operators.parameters.refinement.get_interior_level(finest));
      };
      for (unsigned int b = 0; b < states.size(); ++b)
      {
        // Where the body is now and where it will be in a step or two.
        const SolidBody<dim> &solid = operators.bodies[b]->get_solid();
        const Vector<double>  now   = place_on_grid(solid, states[b].positions, frame.origin);
        Vector<double>        next(now);
        next.sadd(2, -1, place_on_grid(solid, states[b].old_positions, frame.old_origin));
        add(solid.compute_cell_boxes(now), operators.interiors[b]);
        add(solid.compute_cell_boxes(next), operators.interiors[b]);
      }
      return cells;
    }

    /** In two dimensions the vorticity is a number from deal.II 9.7 on. */
    [[maybe_unused]] double get_norm(const double vorticity)
    {
      return std::abs(vorticity);
    }

    template <int n>
    double get_norm(const Tensor<1, n> &vorticity)
    {
      return vorticity.norm();
    }

    /** Largest h |vorticity| of each active cell of this rank, h the cell's edge [m/s]. */
    template <int dim>
    Vector<float> compute_vorticity_indicator(const FluidSpace<dim> &space,
                                              const FieldVector     &velocity)
    {
      Vector<float> indicator(space.get_triangulation().n_active_cells());
      FEValues<dim> values(space.velocity_element, QGauss<dim>(2), update_gradients);
      std::vector<typename FEValuesViews::Vector<dim>::template solution_curl_type<double>>
          vorticities(values.n_quadrature_points);
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          values.reinit(cell);
          values[FEValuesExtractors::Vector(0)].get_function_curls(velocity, vorticities);
          const double h = space.get_cell_size(cell->level()).norm() / std::sqrt(dim);
          for (const auto &vorticity : vorticities)
            indicator[cell->active_cell_index()] =
                std::max<float>(indicator[cell->active_cell_index()], h * get_norm(vorticity));
        }
      return indicator;
    }

    /** Flags cells for the fields of @p velocity; returns whether the grid is to be changed. */
    template <int dim>
    bool set_flags(Operators<dim> &operators, const FieldVector &velocity,
                   const CellSet<dim> &body_cells, const double time)
    {
      const auto         &parameters    = operators.parameters.refinement;
      const Vector<float> indicator     = parameters.vorticity_threshold > 0
                                              ? compute_vorticity_indicator(operators.space, velocity)
                                              : Vector<float>();
      auto               &triangulation = operators.triangulation;
      flag_cells(triangulation, operators.lattice, body_cells, indicator, parameters, time);
      triangulation.prepare_coarsening_and_refinement();
      check_growth(triangulation);
      bool changes = false;
      for (const auto &cell : triangulation.active_cell_iterators())
        changes = changes || (cell->is_locally_owned() &&
                              (cell->refine_flag_set() || cell->coarsen_flag_set()));
      return Utilities::MPI::max<int>(changes, operators.communicator) > 0;
    }

    template <int dim>
    void clear_flags(Triangulation<dim> &triangulation)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
    }

    /** The nodal interpolant of the initial velocity of the .prm. */
    template <int dim>
    void set_initial_velocity(const FluidSpace<dim> &space, FluidState<dim> &state)
    {
      VectorTools::interpolate(
          space.velocity_dofs,
          Expression<dim>("Fluid/Initial velocity", space.get_parameters().initial_velocity, dim),
          state.velocity);
      space.get_constraints(Instant()).distribute(state.velocity);
      state.update_ghost_values();
    }

    /** Changes the grid by its flags, and interpolates the state's fields. */
    template <int dim>
    void transfer(Operators<dim> &operators, State<dim> &state)
    {
      using Transfer              = compatibility::SolutionTransfer<dim, FieldVector>;
      FluidSpace<dim>      &space = operators.space;
      Transfer              velocity_transfer(space.velocity_dofs);
      Transfer              pressure_transfer(space.pressure_dofs);
      const FluidState<dim> old = state.fluid;
      old.update_ghost_values();
      velocity_transfer.prepare_for_coarsening_and_refinement(old.get_velocities());
      pressure_transfer.prepare_for_coarsening_and_refinement(old.pressure);
      operators.triangulation.execute_coarsening_and_refinement();

      space.reinit();
      state.fluid.reinit(space);
      std::vector<FieldVector *> velocities = state.fluid.get_velocities();
      velocity_transfer.interpolate(velocities);
      pressure_transfer.interpolate(state.fluid.pressure);
      const double old_time = state.time.get_time() - state.time.get_previous_step();
      space.get_constraints({old_time - state.time.get_older_step(), state.frame.older_origin})
          .distribute(state.fluid.older_velocity);
      space.get_constraints({old_time, state.frame.old_origin})
          .distribute(state.fluid.old_velocity);
      space.get_constraints(state.get_instant()).distribute(state.fluid.velocity);
      state.fluid.update_ghost_values();
    }

    /** Brings the grid into its canonical order, and everything else to the grid. */
    template <int dim>
    void renumber(Operators<dim> &operators, FluidState<dim> &fluid)
    {
      const FluidSnapshot snapshot =
          take_snapshot(operators.space, std::as_const(fluid).get_velocities(), fluid.pressure);
      operators.reinit();
      restore_fields(snapshot, operators.space, fluid.get_velocities(), fluid.pressure);
    }

    /** The closest velocity u + du with B (u + du) = 0: M du + B^T q = 0. */
    template <int dim>
    void project(const Operators<dim> &operators, const double step, SolverMemory &memory,
                 FieldVector &velocity)
    {
      const FluidSpace<dim> &space = operators.space;
      const auto             point = std::make_shared<Linearisation>();
      point->weights.inertia       = operators.parameters.fluid.density / step;
      if (!operators.solver.is_iterative())
        point->weights.augmentation =
            point->weights.inertia * operators.parameters.domain.size.norm_square();
      CoupledUnknowns residual{
          space.make_velocity_vector(), operators.momentum.compute_divergence(velocity), {}};
      residual.pressure *= -1;
      if (residual.pressure.linfty_norm() == 0)
        return;
      MomentumStep momentum;
      momentum.weights = point->weights;
      operators.momentum.assemble(momentum, velocity, space.make_pressure_vector());
      const double scale =
          point->weights.inertia * space.get_mean_nodal_volume() * velocity.l2_norm();
      FieldVector correction =
          operators.solver.solve(residual, {}, point, scale, memory).correction.velocity;
      space.get_homogeneous_constraints().distribute(correction);
      velocity += correction;
      velocity.update_ghost_values();
    }
  } // namespace

  template <int dim>
  State<dim> make_initial_state(Operators<dim> &operators)
  {
    State<dim> state{TimeStepper(operators.parameters.time), {}, {}, {}};
    for (const auto &body : operators.bodies)
      state.bodies.push_back(body->make_initial_state());
    const CellSet<dim> body_cells = make_body_cells(operators, state.bodies, state.frame,
                                                    operators.parameters.refinement.body_margin);
    for (unsigned int pass = 0;; ++pass)
    {
      operators.space.reinit();
      state.fluid.reinit(operators.space);
      set_initial_velocity(operators.space, state.fluid);
      if (pass > operators.lattice.get_finest_level() ||
          !set_flags(operators, state.fluid.velocity, body_cells, 0))
        break;
      operators.triangulation.execute_coarsening_and_refinement();
    }
    clear_flags(operators.triangulation);
    renumber(operators, state.fluid);

    for (unsigned int b = 0; b < state.bodies.size(); ++b)
    {
      const auto interaction =
          operators.compute_interaction(b, state.bodies[b].positions, state.get_instant());
      state.bodies[b].velocity = state.bodies[b].old_velocity =
          follow_fluid(*operators.bodies[b], interaction, state.fluid.velocity);
    }
    return state;
  }

  template <int dim>
  bool adaptation_is_needed(const Operators<dim> &operators, const State<dim> &state)
  {
    // Half a cell more than the kernel's support, for what the prediction misses; but no more than
    // adapt() provides, or it would be called in each step.
    const double margin = std::min(0.5, operators.parameters.refinement.body_margin);
    return !make_body_cells(operators, state.bodies, state.frame, margin)
                .is_covered_by(operators.triangulation);
  }

  template <int dim>
  AdaptationReport adapt(Operators<dim> &operators, State<dim> &state)
  {
    AdaptationReport report;
    const auto       before = summarise_flow(operators.space, state.fluid.velocity);
    {
      TimerOutput::Scope timer_section(operators.timer, "adapt grid");
      const CellSet<dim> body_cells = make_body_cells(operators, state.bodies, state.frame,
                                                      operators.parameters.refinement.body_margin);
      // A pass refines by one level; a body may have come to where two are missing.
      for (unsigned int pass = 0; pass <= operators.lattice.get_finest_level(); ++pass)
      {
        if ((pass > 0 && body_cells.is_covered_by(operators.triangulation)) ||
            !set_flags(operators, state.fluid.velocity, body_cells, state.time.get_time()))
          break;
        transfer(operators, state);
        report.changed = true;
      }
      clear_flags(operators.triangulation);
      report.n_cells = operators.triangulation.n_global_active_cells();
      if (!report.changed)
        return report;
      renumber(operators, state.fluid);
    }
    state.solver.linearisation.reset();
    // The older one only transports, for which its small divergence does not matter.
    for (FieldVector *velocity : {&state.fluid.velocity, &state.fluid.old_velocity})
      project(operators, state.time.get_step(), state.solver, *velocity);
    state.solver.linearisation.reset();

    const auto after             = summarise_flow(operators.space, state.fluid.velocity);
    report.kinetic_energy_change = after.kinetic_energy - before.kinetic_energy;
    const double mass      = operators.parameters.fluid.density * operators.get_domain().volume();
    report.momentum_change = (after.momentum - before.momentum).norm() /
                             std::max(mass * before.largest_velocity, 1e-300);
    return report;
  }

#define INSTANTIATE(dim)                                                                           \
  template State<dim>       make_initial_state(Operators<dim> &);                                  \
  template bool             adaptation_is_needed(const Operators<dim> &, const State<dim> &);      \
  template AdaptationReport adapt(Operators<dim> &, State<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
