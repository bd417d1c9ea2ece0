#include <caudal/viscous/time_scheme.h>

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
      explicit SemiImplicitScheme(const ImmersedSystem<dim> &system)
          : TimeScheme<dim>(system)
      {}

      StepResult<dim> advance(const TimeStepper &stepper) override
      {
        const TimeWeights weights = stepper.get_weights();
        predict_fluid(weights, stepper.get_next_time());

        std::vector<Vector<double>>                    predicted;
        std::vector<typename CoupledSystem<dim>::Body> coupled;
        for (const auto &body : system.bodies)
        {
          predicted.push_back(predict_body(*body, weights));
          body->prepare_step(stepper.get_time(), stepper.get_step());
          this->update_interaction(*body, predicted.back());
          set_up_body_equations(*body, predicted.back(), weights, stepper);
          coupled.push_back({&body->interaction, &body->equations});
        }

        FieldVector           residual = system.space.make_velocity_vector();
        const MomentumWeights implicit =
            assemble_momentum(weights, stepper.get_next_time(), residual);
        for (const auto &body : system.bodies)
          body->interaction.spread(body->new_force_density, residual);
        const unsigned int iterations = this->solve(residual, coupled, implicit, true);

        for (const auto &body : system.bodies)
        {
          move_body(*body, weights);
          compute_middle_forces(*body, stepper);
        }
        StepResult<dim> result = this->check_trial_state(iterations, stepper.get_step(), predicted);
        result.damping         = compute_damping(stepper);
        return result;
      }

    private:
      using TimeScheme<dim>::system;
      using TimeScheme<dim>::new_velocity;
      using TimeScheme<dim>::new_pressure;

      FieldVector transport, history;

      /** First guess: the extrapolated velocity, the old pressure. */
      void predict_fluid(const TimeWeights &weights, const double time)
      {
        system.space.set_boundary_values(time);
        copy_with_layout(system.fluid.velocity, transport);
        transport *= weights.extrapolation[0];
        transport.add(weights.extrapolation[1], system.fluid.old_velocity);
        copy_with_layout(transport, new_velocity);
        system.space.constraints.distribute(new_velocity);
        copy_with_layout(system.fluid.pressure, new_pressure);
        copy_with_layout(system.fluid.velocity, history);
        history *= weights.derivative[1];
        history.add(weights.derivative[2], system.fluid.old_velocity);
        history *= system.space.get_parameters().density;
        for (const FieldVector *field : {&transport, &new_velocity, &new_pressure, &history})
          field->update_ghost_values();
      }

      /** The transport velocity is the extrapolated one. Called when it is no more needed. */
      double compute_damping(const TimeStepper &stepper)
      {
        const bool is_first = stepper.get_previous_step() == 0;
        transport.sadd(-1, 1, new_velocity);
        transport.update_ghost_values();
        return (is_first ? 1 : 0.5) * compute_kinetic_energy(system.space, transport);
      }

      MomentumWeights assemble_momentum(const TimeWeights &weights, const double time,
                                        FieldVector &residual)
      {
        TimerOutput::Scope timer_section(system.timer, "assemble fluid");
        const auto        &parameters = system.space.get_parameters();
        MomentumStep       step;
        step.weights.inertia      = parameters.density * weights.derivative[0];
        step.weights.viscosity    = parameters.get_viscosity();
        step.weights.grad_div     = parameters.density * parameters.grad_div;
        step.weights.augmentation = this->get_augmentation(step.weights.inertia);
        step.transport            = &transport;
        step.inertia_history      = &history;
        step.time                 = time;
        system.momentum.assemble(step, new_velocity, new_pressure, residual);
        return step.weights;
      }

      /** Extrapolates the body's velocity and returns the positions X* to which it leads. */
      Vector<double> predict_body(SwimmingBody<dim> &body, const TimeWeights &weights) const
      {
        const SolidBody<dim> &solid = body.solid;
        body.new_velocity           = solid.velocity;
        body.new_velocity *= weights.extrapolation[0];
        body.new_velocity.add(weights.extrapolation[1], solid.old_velocity);
        body.new_force_density = solid.force_density;
        return integrate_position(body, weights);
      }

      /** X^{n+1} from U^{n+1} and the old positions, by BDF2. */
      Vector<double> integrate_position(const SwimmingBody<dim> &body,
                                        const TimeWeights       &weights) const
      {
        const SolidBody<dim> &solid = body.solid;
        Vector<double>        positions(body.new_velocity);
        positions.add(-weights.derivative[1], solid.positions, -weights.derivative[2],
                      solid.old_positions);
        positions /= weights.derivative[0];
        solid.restore_fixed_nodes(positions);
        return positions;
      }

      /** Response matrix and right hand sides of the body for the first guess and X*. */
      void set_up_body_equations(SwimmingBody<dim> &body, const Vector<double> &predicted,
                                 const TimeWeights &weights, const TimeStepper &stepper) const
      {
        TimerOutput::Scope          timer_section(system.timer, "assemble body");
        const SolidBody<dim>       &solid     = body.solid;
        const SparseMatrix<double> &mass      = solid.get_mass_matrix();
        BodyEquations              &equations = body.equations;
        body.assemble_forces(predicted, stepper.get_next_time(), true);

        // b linearised in U, since X^{n+1} = ... + U^{n+1} / derivative[0] where X is free.
        body.response.copy_from(body.elastic_system.stiffness);
        body.response.add(1, solid.get_feedback_stiffness());
        body.response /= weights.derivative[0];
        for (auto entry : body.response)
          if (solid.is_fixed(entry.column()))
            entry.value() = 0;
        body.response.add(1, solid.get_feedback_damping());
        body.response.add(solid.get_excess_density() * weights.derivative[0], mass);

        Vector<double> force = body.compute_feedback_force(predicted, body.new_velocity);
        force += body.elastic_system.elastic_force;
        force += body.elastic_system.active_force;
        if (solid.get_excess_density() != 0)
        {
          Vector<double> acceleration(body.new_velocity);
          acceleration *= weights.derivative[0];
          acceleration.add(weights.derivative[1], solid.velocity, weights.derivative[2],
                           solid.old_velocity);
          acceleration *= -solid.get_excess_density();
          mass.vmult_add(force, acceleration);
        }
        equations.frame_velocity.reinit(0);
        if (body.has_gait())
          add_gait(body, predicted, stepper, force);

        Vector<double> old_force(body.new_force_density);
        old_force *= -1;
        equations.force_density = force;
        mass.vmult_add(equations.force_density, old_force);
        equations.velocity.reinit(solid.n_dofs());
        body.interaction.interpolate(new_velocity, equations.velocity);
        Vector<double> opposite_velocity(body.new_velocity);
        opposite_velocity *= -1;
        mass.vmult_add(equations.velocity, opposite_velocity);
      }

      void add_gait(SwimmingBody<dim> &body, const Vector<double> &predicted,
                    const TimeStepper &stepper, Vector<double> &force) const
      {
        BodyEquations &equations = body.equations;
        body.set_up_rigid_motions(predicted);
        // Errors of the shape are worked off within ten steps.
        Vector<double> slip =
            body.compute_gait_velocity(predicted, stepper.get_next_time(), 10 * stepper.get_step());
        slip -= body.new_velocity;
        equations.frame_velocity.reinit(equations.rigid_moments.size());
        for (unsigned int k = 0; k < equations.rigid_moments.size(); ++k)
          equations.frame_velocity[k] = equations.rigid_moments[k] * slip;
        slip *= equations.gait_damping;
        body.solid.get_mass_matrix().vmult_add(force, slip);
        body.response.add(equations.gait_damping, body.solid.get_mass_matrix());
      }

      /** Applies the corrections; the velocity is interpolated anew, free of the solver's error. */
      void move_body(SwimmingBody<dim> &body, const TimeWeights &weights) const
      {
        body.new_force_density += body.equations.force_density;
        body.interaction.interpolate(new_velocity, body.new_velocity);
        body.solid.apply_inverse_mass(body.new_velocity);
        body.new_positions = integrate_position(body, weights);
      }

      /** Forces in the middle of the step: their work is of second order, as the scheme is. */
      void compute_middle_forces(SwimmingBody<dim> &body, const TimeStepper &stepper) const
      {
        TimerOutput::Scope    timer_section(system.timer, "assemble body");
        const SolidBody<dim> &solid = body.solid;
        Vector<double>        positions(solid.positions), velocity(solid.velocity);
        positions.sadd(0.5, 0.5, body.new_positions);
        velocity.sadd(0.5, 0.5, body.new_velocity);
        body.assemble_forces(positions, stepper.get_time() + 0.5 * stepper.get_step(), false);
        body.new_feedback_force = body.compute_feedback_force(positions, velocity);
      }
    };
  } // namespace

  template <int dim>
  std::unique_ptr<TimeScheme<dim>> create_semi_implicit_scheme(const ImmersedSystem<dim> &system)
  {
    return std::make_unique<SemiImplicitScheme<dim>>(system);
  }

  template std::unique_ptr<TimeScheme<2>> create_semi_implicit_scheme(const ImmersedSystem<2> &);
  template std::unique_ptr<TimeScheme<3>> create_semi_implicit_scheme(const ImmersedSystem<3> &);
} // namespace caudal
