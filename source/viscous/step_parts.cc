// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/body_distance.h>
#include <caudal/viscous/step_parts.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  void recall_factorisation(const Operators<dim> &operators, const SolverMemory &memory)
  {
    if (!operators.solver.has_forgotten(memory))
      return;
    const Linearisation &point = *memory.linearisation;
    MomentumStep         momentum;
    momentum.weights    = point.weights;
    momentum.transport  = point.has_transport() ? &point.transport : nullptr;
    momentum.instant    = point.end;
    momentum.grid_moves = operators.parameters.domain.has_moving_frame();
    operators.momentum.assemble(momentum, operators.space.make_velocity_vector(),
                                operators.space.make_pressure_vector());
    operators.solver.recall(linearise_bodies(operators, point).equations, memory.linearisation);
  }

  namespace
  {
    /** R = -db/dU, since X^{n+1} = ... + U^{n+1} / rate where X is free; with the excess inertia.
     */
    template <int dim>
    SparseMatrix<double> combine_response(const SolidBody<dim> &solid, BodyResponse &&response,
                                          const double rate)
    {
      SparseMatrix<double> result(std::move(response.stiffness));
      result /= rate;
      for (auto entry : result)
        if (solid.is_fixed(entry.column()))
          entry.value() = 0;
      result.add(1, response.damping);
      result.add(solid.get_excess_density() * rate, solid.get_mass_matrix());
      return result;
    }

    /** Adds the balance of forces and the kinematics of a body without frame. */
    template <int dim>
    void add_body(const SparseMatrix<double> &coupling_mass, const SparseMatrix<double> &response,
                  const double scale, BodyEquations<dim> &equations)
    {
      const Places &velocity = equations.velocity, &force_density = equations.force_density;
      const Places &balance = velocity, &kinematic = force_density; // rows

      auto &[rows, columns, values] = equations.matrix;
      const std::size_t n_entries =
          2 * coupling_mass.n_nonzero_elements() + response.n_nonzero_elements();
      rows.reserve(n_entries);
      columns.reserve(n_entries);
      values.reserve(n_entries);
      for (const auto &entry : coupling_mass)
      {
        equations.matrix.add(kinematic[entry.row()], velocity[entry.column()],
                             scale * entry.value());
        equations.matrix.add(balance[entry.row()], force_density[entry.column()], entry.value());
      }
      for (const auto &entry : response)
        equations.matrix.add(balance[entry.row()], velocity[entry.column()], entry.value());
    }

    /**
     * Adds the frame of a body with the rigid-body velocities @p modes, whose gait has the damping
     * @p eta.
     */
    template <int dim>
    void add_frame(const SparseMatrix<double> &mass, const std::vector<Vector<double>> &modes,
                   const double eta, const double scale, BodyEquations<dim> &equations)
    {
      const Places  &velocity = equations.velocity, &frame = equations.frame;
      Vector<double> moments(mass.m()); // M_s Z
      for (unsigned int k = 0; k < modes.size(); ++k)
      {
        mass.vmult(moments, modes[k]);
        for (unsigned int i = 0; i < moments.size(); ++i)
        {
          equations.matrix.add(velocity[i], frame[k], -eta * moments[i]);
          equations.matrix.add(frame[k], velocity[i], scale * moments[i]);
        }
        for (unsigned int l = 0; l < modes.size(); ++l)
          equations.matrix.add(frame[k], frame[l], -scale * (moments * modes[l]));
      }
    }
  } // namespace

  template <int dim>
  std::vector<Contraction> command_muscles(const Operators<dim> &operators, const State<dim> &state,
                                           const double dt)
  {
    std::vector<Contraction> contractions;
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
      contractions.push_back(
          operators.bodies[b]->command_muscle(state.bodies[b], state.time.get_time(), dt));
    return contractions;
  }

  template <int dim>
  LinearisedBodies<dim> linearise_bodies(const Operators<dim> &operators,
                                         const Linearisation  &point)
  {
    LinearisedBodies<dim> result;
    for (unsigned int b = 0; b < point.bodies.size(); ++b)
      result.interactions.push_back(
          operators.compute_interaction(b, point.bodies[b].positions, point.end));

    TimerOutput::Scope timer_section(operators.timer, "assemble body");
    result.equations.reserve(point.bodies.size());
    for (unsigned int b = 0; b < point.bodies.size(); ++b)
    {
      const Body<dim>      &body                     = *operators.bodies[b];
      const SolidBody<dim> &solid                    = body.get_solid();
      const auto &[positions, velocity, contraction] = point.bodies[b];
      BodyResponse response(solid.get_sparsity_pattern());
      result.forces.push_back(body.compute_forces(
          {positions, velocity, point.end.time, point.step, contraction}, &response));

      const double                      scale = point.weights.inertia;
      const std::vector<Vector<double>> modes =
          body.has_gait() ? make_rigid_velocities(solid, positions) : std::vector<Vector<double>>();
      result.equations.emplace_back(result.interactions[b], positions, modes.size());
      add_body(solid.get_coupling_mass(), combine_response(solid, std::move(response), point.rate),
               scale, result.equations[b]);
      add_frame(solid.get_mass_matrix(), modes, body.get_gait_damping(), scale,
                result.equations[b]);
      result.frame_residuals.emplace_back(modes.size());
      for (unsigned int k = 0; k < modes.size(); ++k)
        result.frame_residuals[b][k] =
            (modes[k] * result.forces[b].at(LoadAccount::gait)) / body.get_gait_damping();
    }
    return result;
  }

  template <int dim>
  double apply_bodies_to_fluid(const std::vector<InteractionOperator<dim>> &interactions,
                               const std::vector<BodyState> &bodies, FieldVector &forces)
  {
    double      sum_of_norms = 0;
    FieldVector of_body;
    of_body.reinit(forces);
    for (unsigned int b = 0; b < interactions.size(); ++b)
    {
      of_body = 0;
      interactions[b].spread(bodies[b].force_density, of_body);
      forces += of_body;
      sum_of_norms += of_body.l2_norm();
    }
    return sum_of_norms;
  }

  template <int dim>
  std::vector<BodyUnknowns> solve_and_correct(const Operators<dim> &operators,
                                              const State<dim> &state, const CoupledUnknowns &guess,
                                              CoupledUnknowns                             residual,
                                              const std::vector<BodyEquations<dim>>      &equations,
                                              const std::shared_ptr<const Linearisation> &point,
                                              const double force_scale, Step<dim> &step)
  {
    const MomentumOperator<dim> &momentum = operators.momentum;
    const MomentumWeights       &weights  = point->weights;
    residual.pressure                     = momentum.compute_divergence(guess.velocity);
    residual.pressure *= -1;
    // The forces that the residual is compared to: inertia and what bodies exert.
    const double scale =
        weights.inertia * operators.space.get_mean_nodal_volume() * guess.velocity.l2_norm() +
        force_scale;
    auto [correction, n_iterations] =
        operators.solver.solve(residual, equations, point, scale, step.state.solver);
    operators.space.get_homogeneous_constraints().distribute(correction.velocity);
    step.report.iterations += n_iterations;

    FluidState<dim> &fluid = step.state.fluid;
    fluid = {guess.velocity, state.fluid.velocity, state.fluid.old_velocity, guess.pressure};
    fluid.velocity += correction.velocity;
    fluid.velocity.update_ghost_values();
    fluid.pressure += correction.pressure;
    // The augmentation times what the tolerance leaves of the divergence acts as
    // a pressure, which the pressure has to contain.
    FieldVector divergence = momentum.compute_divergence(fluid.velocity);
    momentum.apply_inverse_pressure_mass(divergence);
    fluid.pressure.add(-weights.augmentation, divergence);
    fluid.update_ghost_values();
    return std::move(correction.bodies);
  }

  template <int dim>
  Vector<double> follow_fluid(const Body<dim> &body, const InteractionOperator<dim> &interaction,
                              const FieldVector &velocity)
  {
    Vector<double> result = interaction.interpolate(velocity);
    body.get_solid().apply_inverse_coupling_mass(result);
    return result;
  }

  template <int dim>
  double account_work(const Body<dim> &body, const BodyState &before, const ForcesByAccount &forces,
                      const double dt, BodyState &after)
  {
    const SolidBody<dim> &solid = body.get_solid();
    Vector<double>        displacement(after.positions);
    displacement -= before.positions;

    // What drives the body: the muscle, and with a gait the rest of its forces.
    const auto     muscle = forces.find(LoadAccount::muscle);
    Vector<double> driving_force =
        muscle != forces.end() ? muscle->second : Vector<double>(solid.n_dofs());
    const Vector<double> &feedback_force = forces.at(LoadAccount::feedback);
    if (body.has_gait())
    {
      Vector<double> mean_density(before.force_density), acceleration(after.velocity);
      mean_density.sadd(0.5, 0.5, after.force_density);
      acceleration -= before.velocity;
      acceleration /= dt;
      driving_force = body.compute_gait_force(mean_density, forces, acceleration);
    }
    const double work = driving_force * displacement;
    after.muscle_work = before.muscle_work + work;

    // Fluid moves through fixed nodes rather than with them.
    for (unsigned int i = 0; i < solid.n_dofs(); ++i)
      if (solid.is_fixed(i))
        displacement[i] = 0.5 * dt * (before.velocity[i] + after.velocity[i]);
    after.feedback_work = before.feedback_work + feedback_force * displacement;
    return work / dt;
  }

  namespace
  {
    /** See BodyReport::power_identity; @p on_sides is BodyReport::power_on_sides. */
    template <int dim>
    double compute_power_identity(const Operators<dim> &operators, const SolidBody<dim> &solid,
                                  const InteractionOperator<dim> &interaction,
                                  const BodyState &body, const FieldVector &velocity,
                                  const double on_sides)
    {
      Vector<double> weighted(solid.n_dofs());
      solid.get_coupling_mass().vmult(weighted, body.velocity);
      FieldVector force = operators.space.make_velocity_vector();
      interaction.spread(body.force_density, force);
      double size = 0;
      for (unsigned int i = 0; i < weighted.size(); ++i)
        size += std::abs(weighted[i] * body.force_density[i]);
      return std::abs(weighted * body.force_density - force * velocity - on_sides) /
             std::max(size, 1e-300);
    }
  } // namespace

  template <int dim>
  void check_step(const Operators<dim> &operators, const State<dim> &before,
                  const State<dim> &after, const std::vector<Vector<double>> &predicted,
                  const std::vector<InteractionOperator<dim>> &interactions, const double dt,
                  StepReport<dim> &report)
  {
    AssertThrow(std::isfinite(after.fluid.velocity.l2_norm()) &&
                    std::isfinite(after.fluid.pressure.l2_norm()),
                ExcNotFinite("The velocity or the pressure is"));
    const Tensor<1, dim> h          = operators.parameters.domain.get_finest_spacing();
    auto                &indicators = report.indicators;
    report.bodies.resize(operators.bodies.size());
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
    {
      const Body<dim>      &body = *operators.bodies[b];
      const Vector<double> &x = after.bodies[b].positions, &old_x = before.bodies[b].positions;
      AssertThrow(std::isfinite(x.l2_norm()),
                  ExcNotFinite("The position of body " + body.get_name() + " is"));
      report.bodies[b].deformation = summarise_deformation(body.get_solid(), x);
      for (const auto &node : body.get_solid().get_nodes())
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i = node[d];
          indicators.body_cfl  = std::max(
               indicators.body_cfl, std::abs(x[i] - old_x[i] - dt * after.frame.velocity[d]) / h[d]);
          indicators.error = std::max(indicators.error, std::abs(x[i] - predicted[b][i]) / h[d]);
        }
      report.bodies[b].power_on_sides =
          interactions[b].compute_power_on_sides(after.bodies[b].force_density);
      report.bodies[b].power_identity =
          compute_power_identity(operators, body.get_solid(), interactions[b], after.bodies[b],
                                 after.fluid.velocity, report.bodies[b].power_on_sides);
    }
    check_distances(operators, after.bodies);
    report.flow = summarise_flow(operators.space, after.fluid.velocity, report.grid_velocity);
    indicators.convective_cfl = report.flow.largest_rate * dt;
  }

#define INSTANTIATE(dim)                                                                             \
  template void recall_factorisation(const Operators<dim> &, const SolverMemory &);                  \
  template std::vector<Contraction> command_muscles(const Operators<dim> &, const State<dim> &,      \
                                                    double);                                         \
  template LinearisedBodies<dim>    linearise_bodies(const Operators<dim> &, const Linearisation &); \
  template double apply_bodies_to_fluid(const std::vector<InteractionOperator<dim>> &,               \
                                        const std::vector<BodyState> &, FieldVector &);              \
  template std::vector<BodyUnknowns> solve_and_correct(                                              \
      const Operators<dim> &, const State<dim> &, const CoupledUnknowns &, CoupledUnknowns,          \
      const std::vector<BodyEquations<dim>> &, const std::shared_ptr<const Linearisation> &,         \
      double, Step<dim> &);                                                                          \
  template Vector<double> follow_fluid(const Body<dim> &, const InteractionOperator<dim> &,          \
                                       const FieldVector &);                                         \
  template double account_work(const Body<dim> &, const BodyState &, const ForcesByAccount &,        \
                               double, BodyState &);                                                 \
  template void   check_step(const Operators<dim> &, const State<dim> &, const State<dim> &,         \
                             const std::vector<Vector<double>> &,                                    \
                             const std::vector<InteractionOperator<dim>> &, double,                  \
                             StepReport<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
