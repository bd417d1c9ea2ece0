// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/step_parts.h>

namespace caudal
{
  namespace
  {
    /**
     * The explicit scheme of doi:10.1155/2014/489683, section 3.4 (see also Griffith & Luo 2017,
     * doi:10.1002/cnm.2888): body forces at the midpoint that the velocity of t^n leads to,
     * Crank-Nicolson viscosity, Adams-Bashforth convection. The first step has two stages, the
     * second of which takes the midpoint of the first.
     */
    template <int dim>
    class ExplicitScheme : public TimeScheme<dim>
    {
    public:
      void advance(const Operators<dim> &operators, const State<dim> &state, const double dt,
                   Step<dim> &step) const override
      {
        recall_factorisation(operators, state.solver);
        const bool is_first = state.time.get_previous_step() == 0;
        const auto point    = std::make_shared<const Linearisation>(linearise(operators, dt));

        std::vector<Vector<double>>           predicted;
        std::vector<InteractionOperator<dim>> interactions;
        std::vector<ForcesByAccount>          forces;
        const std::vector<Contraction>        contractions = command_muscles(operators, state, dt);
        for (unsigned int b = 0; b < operators.bodies.size(); ++b)
        {
          step.state.bodies.push_back(predict_body(*operators.bodies[b], state.bodies[b],
                                                   contractions[b], state.time.get_time(), dt));
          predicted.push_back(step.state.bodies[b].positions);
        }
        FieldVector convecting = state.fluid.velocity;
        convecting.update_ghost_values(); // which a copy may not have
        for (unsigned int stage = 0; stage < (is_first ? 2 : 1); ++stage)
        {
          interactions.clear();
          forces.clear();
          for (unsigned int b = 0; b < operators.bodies.size(); ++b)
          {
            Vector<double> middle = state.bodies[b].positions;
            middle.sadd(0.5, 0.5, step.state.bodies[b].positions);
            const double time = state.time.get_time() + 0.5 * dt;
            interactions.push_back(operators.compute_interaction(b, middle, {time + 0.5 * dt, {}}));
            TimerOutput::Scope timer_section(operators.timer, "assemble body");
            forces.push_back(operators.bodies[b]->compute_forces(
                {middle, state.bodies[b].velocity, time, dt, step.state.bodies[b].contraction}));
            step.state.bodies[b].force_density =
                compute_force_density(*operators.bodies[b], forces[b]);
          }
          advance_fluid(operators, state, dt, convecting, interactions, point, step);
          for (unsigned int b = 0; b < operators.bodies.size(); ++b)
            move_body(*operators.bodies[b], state, b, interactions[b], dt, step.state);
          convecting = step.state.fluid.velocity;
          convecting.sadd(0.5, 0.5, state.fluid.velocity);
          convecting.update_ghost_values();
        }

        for (unsigned int b = 0; b < operators.bodies.size(); ++b)
        {
          step.report.bodies.emplace_back();
          step.report.bodies[b].muscle_power = account_work(*operators.bodies[b], state.bodies[b],
                                                            forces[b], dt, step.state.bodies[b]);
        }
        check_step(operators, state, step.state, predicted, interactions, dt, step.report);
        step.report.rate = 1 / dt;
        step.state.time.accept(dt, step.report.indicators);
      }

    private:
      static Linearisation linearise(const Operators<dim> &operators, const double dt)
      {
        const auto   &parameters = operators.parameters.fluid;
        Linearisation point;
        point.weights.inertia      = parameters.density / dt;
        point.weights.viscosity    = 0.5 * parameters.get_viscosity();
        point.weights.grad_div     = 0.5 * parameters.density * operators.space.get_grad_div();
        point.weights.augmentation = operators.get_augmentation(point.weights.inertia);
        return point;
      }

      /** X^n + dt U^n, and what its muscle has decided. */
      static BodyState predict_body(const Body<dim> &body, const BodyState &before,
                                    const Contraction &contraction, const double time,
                                    const double dt)
      {
        BodyState next     = before;
        next.contraction   = contraction;
        next.old_positions = before.positions;
        next.old_velocity  = before.velocity;
        next.positions.add(dt, before.velocity);
        body.get_solid().restore_fixed_nodes(next.positions, time + dt);
        return next;
      }

      /** Phi = C^-1 b */
      static Vector<double> compute_force_density(const Body<dim>       &body,
                                                  const ForcesByAccount &forces)
      {
        Vector<double> density(body.get_solid().n_dofs());
        for (const auto &account : forces)
          density += account.second;
        body.get_solid().apply_inverse_coupling_mass(density);
        return density;
      }

      /** Brings the fluid to the end of the @p step, under the forces of the bodies there. */
      static void advance_fluid(const Operators<dim> &operators, const State<dim> &state,
                                const double dt, const FieldVector &convecting,
                                const std::vector<InteractionOperator<dim>> &interactions,
                                const std::shared_ptr<const Linearisation> &point, Step<dim> &step)
      {
        const FluidState<dim> &fluid = state.fluid;
        CoupledUnknowns        guess{fluid.velocity, fluid.pressure, {}};
        operators.space.get_constraints({state.time.get_time() + dt, {}})
            .distribute(guess.velocity);
        FieldVector history = fluid.velocity;
        history *= -operators.parameters.fluid.density / dt;
        for (const FieldVector *field : {&guess.velocity, &guess.pressure, &history})
          field->update_ghost_values();

        MomentumStep momentum;
        momentum.weights             = point->weights;
        momentum.old_weights         = point->weights;
        momentum.old_weights.inertia = momentum.old_weights.augmentation = 0;
        momentum.inertia_history                                         = &history;
        momentum.old_velocity                                            = &fluid.velocity;
        momentum.instant.time = state.time.get_time() + 0.5 * dt;
        if (state.time.get_previous_step() == 0)
          momentum.old_convection = {{&convecting, 1.}};
        else
        {
          const double ratio      = 0.5 * dt / state.time.get_previous_step();
          momentum.old_convection = {{&fluid.velocity, 1 + ratio}, {&fluid.old_velocity, -ratio}};
        }

        CoupledUnknowns residual;
        {
          TimerOutput::Scope timer_section(operators.timer, "assemble fluid");
          residual.velocity = operators.momentum.assemble(momentum, guess.velocity, guess.pressure);
        }
        const double force_scale =
            apply_bodies_to_fluid(interactions, step.state.bodies, residual.velocity);
        solve_and_correct(operators, state, guess, std::move(residual), {}, point, force_scale,
                          step);
      }

      /** X^{n+1} = X^n + dt M_s^-1 G (u^n + u^{n+1})/2 */
      static void move_body(const Body<dim> &body, const State<dim> &state, const unsigned int b,
                            const InteractionOperator<dim> &interaction, const double dt,
                            State<dim> &next)
      {
        next.bodies[b].velocity  = follow_fluid(body, interaction, next.fluid.velocity);
        next.bodies[b].positions = state.bodies[b].positions;
        next.bodies[b].positions.add(0.5 * dt,
                                     follow_fluid(body, interaction, state.fluid.velocity),
                                     0.5 * dt, next.bodies[b].velocity);
        body.get_solid().restore_fixed_nodes(next.bodies[b].positions, state.time.get_time() + dt);
      }
    };

    const DimensionalRegistration<TimeScheme, ExplicitScheme>
        registration("explicit",
                     "midpoint body forces, Crank-Nicolson viscosity, Adams-Bashforth convection");
  } // namespace
} // namespace caudal
