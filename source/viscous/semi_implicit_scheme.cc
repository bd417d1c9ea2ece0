// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/step_parts.h>

namespace caudal
{
  namespace
  {
    /**
     * BDF2 with variable step. Convection is linearised about the extrapolated
     * velocity (Oseen), the elastic, active and feedback forces about the
     * extrapolated positions X*,
     *   b(X^{n+1}) ~ b(X*) - K(X*) (X^{n+1} - X*),
     * and velocities, pressure, body velocities and body forces are solved for
     * together.
     */
    template <int dim>
    class SemiImplicitScheme : public TimeScheme<dim>
    {
    public:
      void advance(const Operators<dim> &operators, const State<dim> &state, const double dt,
                   Step<dim> &step) const override
      {
        recall_factorisation(operators, state.solver);
        const TimeWeights weights = state.time.get_weights(dt);

        step.state.frame                   = move_frame(operators, state, dt);
        const Tensor<1, dim> grid_velocity = compute_grid_velocity(state, step.state.frame, dt);

        const auto point = std::make_shared<const Linearisation>(
            predict(operators, state, weights, dt, step.state.frame.origin, grid_velocity,
                    command_muscles(operators, state, dt)));
        const CoupledUnknowns       guess  = make_guess(operators, state, *point, grid_velocity);
        const LinearisedBodies<dim> bodies = linearise_bodies(operators, *point);

        CoupledUnknowns residual;
        residual.velocity = compute_momentum_residual(operators, state, weights, *point, guess);
        const double force_scale = // the old force densities are the first guess
            apply_bodies_to_fluid(bodies.interactions, state.bodies, residual.velocity);
        for (unsigned int b = 0; b < operators.bodies.size(); ++b)
          residual.bodies.push_back(compute_body_residual(
              *operators.bodies[b], state.bodies[b], weights, point->bodies[b], bodies, b, guess));

        const auto corrections = solve_and_correct(operators, state, guess, std::move(residual),
                                                   bodies.equations, point, force_scale, step);
        for (unsigned int b = 0; b < operators.bodies.size(); ++b)
        {
          const Body<dim> &body = *operators.bodies[b];
          step.state.bodies.push_back(move_body(body, state.bodies[b], weights,
                                                bodies.interactions[b], corrections[b], *point, b,
                                                step.state.fluid.velocity));
          step.report.bodies.emplace_back();
          step.report.bodies[b].muscle_power =
              account_work(body, state.bodies[b],
                           compute_middle_forces(operators, body, state.time, dt, state.bodies[b],
                                                 step.state.bodies[b]),
                           dt, step.state.bodies[b]);
        }

        std::vector<Vector<double>> predicted;
        for (const auto &body : point->bodies)
          predicted.push_back(body.positions);
        step.report.grid_velocity = grid_velocity;
        check_step(operators, state, step.state, predicted, bodies.interactions, dt, step.report);
        step.report.rate    = point->rate;
        step.report.damping = compute_damping(operators, state, weights, step.state.fluid);
        step.state.time.accept(dt, step.report.indicators);
      }

    private:
      /** Extrapolates velocities to the end of the step, and body positions by BDF2. */
      static Linearisation predict(const Operators<dim> &operators, const State<dim> &state,
                                   const TimeWeights &weights, const double dt,
                                   const DomainVector &origin, const Tensor<1, dim> &grid_velocity,
                                   const std::vector<Contraction> &contractions)
      {
        const auto   &parameters = operators.parameters.fluid;
        Linearisation point;
        point.end                  = {state.time.get_time() + dt, origin};
        point.step                 = dt;
        point.rate                 = weights.derivative[0];
        point.weights.inertia      = parameters.density * point.rate;
        point.weights.viscosity    = parameters.get_viscosity();
        point.weights.grad_div     = parameters.density * operators.space.get_grad_div();
        point.weights.augmentation = operators.get_augmentation(point.weights.inertia);
        point.transport            = state.fluid.velocity;
        point.transport.sadd(weights.transport[0], weights.transport[1], state.fluid.old_velocity);
        point.transport.add(weights.transport[2], state.fluid.older_velocity);
        point.transport.update_ghost_values();
        if (operators.parameters.domain.has_moving_frame())
          operators.space.add_uniform(-grid_velocity, point.transport);
        for (unsigned int b = 0; b < state.bodies.size(); ++b)
        {
          const Body<dim> &body     = *operators.bodies[b];
          const BodyState &before   = state.bodies[b];
          Vector<double>   velocity = before.velocity;
          velocity.sadd(weights.extrapolation[0], weights.extrapolation[1], before.old_velocity);
          point.bodies.push_back(
              {integrate_position(body, before, velocity, weights, point.end.time), velocity,
               contractions[b]});
        }
        return point;
      }

      /** X^{n+1} from U^{n+1} and the old positions, by BDF2; @p time is t^{n+1}. */
      static Vector<double> integrate_position(const Body<dim> &body, const BodyState &state,
                                               const Vector<double> &velocity,
                                               const TimeWeights &weights, const double time)
      {
        Vector<double> positions(velocity);
        positions.add(-weights.derivative[1], state.positions, -weights.derivative[2],
                      state.old_positions);
        positions /= weights.derivative[0];
        body.get_solid().restore_fixed_nodes(positions, time);
        return positions;
      }

      /** The extrapolated velocity with the boundary values, the old pressure. */
      static CoupledUnknowns make_guess(const Operators<dim> &operators, const State<dim> &state,
                                        const Linearisation  &point,
                                        const Tensor<1, dim> &grid_velocity)
      {
        CoupledUnknowns guess{point.transport, state.fluid.pressure, {}};
        if (operators.parameters.domain.has_moving_frame())
          operators.space.add_uniform(grid_velocity, guess.velocity);
        operators.space.get_constraints(point.end).distribute(guess.velocity);
        guess.velocity.update_ghost_values();
        guess.pressure.update_ghost_values();
        return guess;
      }

      /** Assembles the momentum equation about @p point; bodies are not in the residual yet. */
      static FieldVector compute_momentum_residual(const Operators<dim>  &operators,
                                                   const State<dim>      &state,
                                                   const TimeWeights     &weights,
                                                   const Linearisation   &point,
                                                   const CoupledUnknowns &guess)
      {
        TimerOutput::Scope timer_section(operators.timer, "assemble fluid");
        FieldVector        history = state.fluid.velocity;
        history.sadd(weights.derivative[1], weights.derivative[2], state.fluid.old_velocity);
        history *= operators.parameters.fluid.density;
        history.update_ghost_values();
        MomentumStep momentum;
        momentum.weights         = point.weights;
        momentum.transport       = &point.transport;
        momentum.inertia_history = &history;
        momentum.instant         = point.end;
        momentum.grid_moves      = operators.parameters.domain.has_moving_frame();
        return operators.momentum.assemble(momentum, guess.velocity, guess.pressure);
      }

      /** r_U = G u - C U*, r_Phi = b(X*, U*) - C Phi, and that of the frame. */
      static BodyUnknowns compute_body_residual(const Body<dim> &body, const BodyState &state,
                                                const TimeWeights           &weights,
                                                const Linearisation::Body   &point,
                                                const LinearisedBodies<dim> &bodies,
                                                const unsigned int b, const CoupledUnknowns &guess)
      {
        const SolidBody<dim>       &solid         = body.get_solid();
        const SparseMatrix<double> &coupling_mass = solid.get_coupling_mass();
        BodyUnknowns                residual;
        residual.force_density.reinit(solid.n_dofs());
        for (const auto &account : bodies.forces[b])
          residual.force_density += account.second;
        if (solid.get_excess_density() != 0)
        {
          Vector<double> acceleration(point.velocity);
          acceleration *= weights.derivative[0];
          acceleration.add(weights.derivative[1], state.velocity, weights.derivative[2],
                           state.old_velocity);
          acceleration *= -solid.get_excess_density();
          solid.get_mass_matrix().vmult_add(residual.force_density, acceleration);
        }
        Vector<double> product(solid.n_dofs());
        coupling_mass.vmult(product, state.force_density);
        residual.force_density -= product;
        residual.velocity = bodies.interactions[b].interpolate(guess.velocity);
        coupling_mass.vmult(product, point.velocity);
        residual.velocity -= product;
        residual.frame_velocity = bodies.frame_residuals[b];
        return residual;
      }

      /** Applies the corrections; the velocity is interpolated anew, free of the solver's error. */
      static BodyState move_body(const Body<dim> &body, const BodyState &state,
                                 const TimeWeights              &weights,
                                 const InteractionOperator<dim> &interaction,
                                 const BodyUnknowns &correction, const Linearisation &point,
                                 const unsigned int b, const FieldVector &velocity)
      {
        BodyState next;
        next.force_density = state.force_density;
        next.force_density += correction.force_density;
        next.velocity     = follow_fluid(body, interaction, velocity);
        next.old_velocity = state.velocity;
        next.positions    = integrate_position(body, state, next.velocity, weights, point.end.time);
        next.old_positions = state.positions;
        next.contraction   = point.bodies[b].contraction;
        return next;
      }

      /** Forces in the middle of the step: their work is of second order, as the scheme is. */
      static ForcesByAccount compute_middle_forces(const Operators<dim> &operators,
                                                   const Body<dim>      &body,
                                                   const TimeStepper &stepper, const double dt,
                                                   const BodyState &before, const BodyState &after)
      {
        const double       time     = stepper.get_time();
        const bool         is_first = stepper.get_previous_step() == 0;
        TimerOutput::Scope timer_section(operators.timer, "assemble body");
        Vector<double>     positions(before.positions), velocity(before.velocity);
        positions.sadd(0.5, 0.5, after.positions);
        velocity.sadd(0.5, 0.5, after.velocity);
        const BodyMotion motion{positions, velocity, time + 0.5 * dt, dt, after.contraction};
        std::vector<LoadAccount> accounts{LoadAccount::muscle};
        if (body.has_gait())
          accounts = {LoadAccount::elastic, LoadAccount::gravity};
        ForcesByAccount forces;
        for (const LoadAccount account : accounts)
          forces[account] = body.compute_force(account, motion);
        // What is held stiffly is so at the ends of the step only, and not yet at the start.
        Vector<double> &feedback = forces[LoadAccount::feedback];
        feedback = body.compute_force(LoadAccount::feedback, body.get_motion(after, time + dt, dt));
        if (!is_first)
          feedback.sadd(
              0.5, 0.5,
              body.compute_force(LoadAccount::feedback, body.get_motion(before, time, dt)));
        return forces;
      }

      /** See StepReport::damping. */
      static double compute_damping(const Operators<dim> &operators, const State<dim> &state,
                                    const TimeWeights &weights, const FluidState<dim> &fluid)
      {
        FieldVector difference(fluid.velocity);
        difference.add(-weights.extrapolation[0], state.fluid.velocity, -weights.extrapolation[1],
                       state.fluid.old_velocity);
        difference.update_ghost_values();
        const bool is_first = state.time.get_previous_step() == 0;
        return (is_first ? 1 : 0.5) * compute_kinetic_energy(operators.space, difference);
      }
    };

    const DimensionalRegistration<TimeScheme, SemiImplicitScheme>
        registration("semi-implicit",
                     "BDF2, convection and body forces linearised about the extrapolated state");
  } // namespace
} // namespace caudal
