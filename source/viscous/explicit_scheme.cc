#include <caudal/viscous/time_scheme.h>

namespace caudal
{
  namespace
  {
    /**
     * The scheme of the paper (doi:10.1155/2014/489683, section 3.4; Griffith &
     * Luo 2017, doi:10.1002/cnm.2888): body forces at the midpoint that the
     * velocity of t^n leads to, Crank-Nicolson viscosity, Adams-Bashforth
     * convection. The first step has two stages, the second of which takes the
     * midpoint of the first.
     */
    template <int dim>
    class ExplicitScheme : public TimeScheme<dim>
    {
    public:
      explicit ExplicitScheme(const ImmersedSystem<dim> &system)
          : TimeScheme<dim>(system)
      {}

      StepResult<dim> advance(const TimeStepper &stepper) override
      {
        const double step = stepper.get_step();
        for (const auto &body : system.bodies)
        {
          body->prepare_step(stepper.get_time(), step);
          body->new_positions = body->solid.positions;
          body->new_positions.add(step, body->solid.velocity);
          body->solid.restore_fixed_nodes(body->new_positions);
        }
        const std::vector<Vector<double>> predicted = get_positions();

        const bool   is_first   = stepper.get_previous_step() == 0;
        unsigned int iterations = 0;
        FieldVector  convecting = system.fluid.velocity;
        convecting.update_ghost_values(); // which a copy does not have
        for (unsigned int stage = 0; stage < (is_first ? 2 : 1); ++stage)
        {
          for (const auto &body : system.bodies)
            compute_body_force(*body, stepper.get_time() + 0.5 * step);
          iterations += advance_fluid(stepper, convecting);
          for (const auto &body : system.bodies)
            move_body(*body, step);
          convecting = new_velocity;
          convecting += system.fluid.velocity;
          convecting *= 0.5;
          convecting.update_ghost_values();
        }
        return this->check_trial_state(iterations, step, predicted);
      }

    private:
      using TimeScheme<dim>::system;
      using TimeScheme<dim>::new_velocity;
      using TimeScheme<dim>::new_pressure;

      std::vector<Vector<double>> get_positions() const
      {
        std::vector<Vector<double>> positions;
        for (const auto &body : system.bodies)
          positions.push_back(body->new_positions);
        return positions;
      }

      /** Phi = M_s^-1 b(X^{n+1/2}), X^{n+1/2} being the mean of old and new positions. */
      void compute_body_force(SwimmingBody<dim> &body, const double time)
      {
        Vector<double> middle(body.solid.positions);
        middle += body.new_positions;
        middle *= 0.5;
        this->update_interaction(body, middle);
        TimerOutput::Scope timer_section(system.timer, "assemble body");
        body.assemble_forces(middle, time, false);
        body.new_feedback_force = body.compute_feedback_force(middle, body.solid.velocity);
        body.new_force_density  = body.new_feedback_force;
        body.new_force_density += body.elastic_system.elastic_force;
        body.new_force_density += body.elastic_system.active_force;
        body.solid.apply_inverse_mass(body.new_force_density);
      }

      unsigned int advance_fluid(const TimeStepper &stepper, const FieldVector &convecting)
      {
        const auto  &parameters = system.space.get_parameters();
        const double step       = stepper.get_step();
        system.space.set_boundary_values(stepper.get_next_time());
        copy_with_layout(system.fluid.velocity, new_velocity);
        system.space.constraints.distribute(new_velocity);
        copy_with_layout(system.fluid.pressure, new_pressure);
        FieldVector history = system.fluid.velocity;
        history *= -parameters.density / step;
        for (const FieldVector *field : {&new_velocity, &new_pressure, &history})
          field->update_ghost_values();

        MomentumStep momentum_step;
        momentum_step.weights.inertia      = parameters.density / step;
        momentum_step.weights.viscosity    = 0.5 * parameters.get_viscosity();
        momentum_step.weights.grad_div     = 0.5 * parameters.density * parameters.grad_div;
        momentum_step.old_weights          = momentum_step.weights;
        momentum_step.old_weights.inertia  = 0;
        momentum_step.weights.augmentation = this->get_augmentation(momentum_step.weights.inertia);
        momentum_step.inertia_history      = &history;
        momentum_step.old_velocity         = &system.fluid.velocity;
        momentum_step.time                 = stepper.get_time() + 0.5 * step;
        if (stepper.get_previous_step() == 0)
          momentum_step.old_convection = {{&convecting, 1.}};
        else
        {
          const double ratio           = 0.5 * step / stepper.get_previous_step();
          momentum_step.old_convection = {{&system.fluid.velocity, 1 + ratio},
                                          {&system.fluid.old_velocity, -ratio}};
        }

        FieldVector residual = system.space.make_velocity_vector();
        bool        matrix_changed;
        {
          TimerOutput::Scope timer_section(system.timer, "assemble fluid");
          matrix_changed =
              system.momentum.assemble(momentum_step, new_velocity, new_pressure, residual);
        }
        for (const auto &body : system.bodies)
          body->interaction.spread(body->new_force_density, residual);
        return this->solve(residual, {}, momentum_step.weights, matrix_changed);
      }

      /** X^{n+1} = X^n + dt M_s^-1 G (u^n + u^{n+1})/2 */
      void move_body(SwimmingBody<dim> &body, const double step)
      {
        body.interaction.interpolate(new_velocity, body.new_velocity);
        body.solid.apply_inverse_mass(body.new_velocity);
        Vector<double> old_velocity(body.solid.n_dofs());
        body.interaction.interpolate(system.fluid.velocity, old_velocity);
        body.solid.apply_inverse_mass(old_velocity);
        body.new_positions = body.solid.positions;
        body.new_positions.add(0.5 * step, old_velocity, 0.5 * step, body.new_velocity);
        body.solid.restore_fixed_nodes(body.new_positions);
      }
    };
  } // namespace

  template <int dim>
  std::unique_ptr<TimeScheme<dim>> create_explicit_scheme(const ImmersedSystem<dim> &system)
  {
    return std::make_unique<ExplicitScheme<dim>>(system);
  }

  template std::unique_ptr<TimeScheme<2>> create_explicit_scheme(const ImmersedSystem<2> &);
  template std::unique_ptr<TimeScheme<3>> create_explicit_scheme(const ImmersedSystem<3> &);
} // namespace caudal
