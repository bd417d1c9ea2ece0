#include <caudal/viscous/body_distance.h>
#include <caudal/viscous/time_scheme.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  TimeScheme<dim>::TimeScheme(const ImmersedSystem<dim> &system)
      : system(system)
  {}

  template <int dim>
  void TimeScheme<dim>::update_interaction(SwimmingBody<dim> &body, const Vector<double> &x)
  {
    TimerOutput::Scope timer_section(system.timer, "interaction operator");
    body.interaction.reinit(*system.finest_cells, system.space.velocity_dofs,
                            system.space.constraints, system.fluid.velocity,
                            body.solid.get_dof_handler(), x, body.get_name());
  }

  template <int dim>
  double TimeScheme<dim>::get_augmentation(const double inertia) const
  {
    const Tensor<1, dim> &coarse = system.space.get_domain_size();
    double                height = coarse[0];
    for (unsigned int d = 1; d < dim; ++d)
      height = std::min(height, coarse[d]);
    return system.solver.augmentation * inertia * height * height;
  }

  template <int dim>
  unsigned int TimeScheme<dim>::solve(FieldVector &residual,
                                      const std::vector<typename CoupledSystem<dim>::Body> &coupled,
                                      const MomentumWeights &weights, const bool matrix_changed)
  {
    // The forces that the residual is compared to: inertia and what bodies exert.
    FieldVector forces;
    forces.reinit(residual);
    double scale = weights.inertia * system.space.get_mean_nodal_volume() * new_velocity.l2_norm();
    for (const auto &body : system.bodies)
    {
      forces = 0;
      body->interaction.spread(body->new_force_density, forces);
      scale += forces.l2_norm();
    }

    FieldVector divergence = system.space.make_pressure_vector();
    system.momentum.compute_divergence(new_velocity, divergence);
    divergence *= -1;
    const unsigned int iterations =
        system.coupled_system.solve(residual, divergence, coupled, weights, scale, matrix_changed);
    system.space.homogeneous_constraints.distribute(residual);
    new_velocity += residual;
    new_pressure -= divergence;
    new_velocity.update_ghost_values();

    // The augmentation times what the tolerance leaves of the divergence acts as
    // a pressure, which the pressure has to contain.
    system.momentum.compute_divergence(new_velocity, divergence);
    system.momentum.apply_inverse_pressure_mass(divergence);
    new_pressure.add(-weights.augmentation, divergence);
    new_pressure.update_ghost_values();
    return iterations;
  }

  template <int dim>
  StepResult<dim> TimeScheme<dim>::check_trial_state(const unsigned int                 iterations,
                                                     const double                       step,
                                                     const std::vector<Vector<double>> &predicted)
  {
    AssertThrow(std::isfinite(new_velocity.l2_norm()) && std::isfinite(new_pressure.l2_norm()),
                ExcNotFinite("The velocity or the pressure is"));
    const unsigned int   finest = system.lattice.get_finest_level();
    const Tensor<1, dim> h      = 0.5 * system.lattice.get_cell_size(finest);
    StepResult<dim>      result;
    result.iterations = iterations;
    for (unsigned int b = 0; b < system.bodies.size(); ++b)
    {
      SwimmingBody<dim> &body = *system.bodies[b];
      AssertThrow(std::isfinite(body.new_positions.l2_norm()),
                  ExcNotFinite("The position of body " + body.get_name() + " is"));
      body.deformation = summarise_deformation(body.solid, body.new_positions);
      for (const auto &node : body.solid.get_nodes())
        for (unsigned int d = 0; d < dim; ++d)
        {
          const double x             = body.new_positions[node[d]];
          result.indicators.body_cfl = std::max(result.indicators.body_cfl,
                                                std::abs(x - body.solid.positions[node[d]]) / h[d]);
          result.indicators.error =
              std::max(result.indicators.error, std::abs(x - predicted[b][node[d]]) / h[d]);
        }
    }
    check_distances(system.bodies, system.lattice);
    result.flow                      = summarise_flow(system.space, new_velocity);
    result.indicators.convective_cfl = result.flow.largest_rate * step;
    return result;
  }

  template <int dim>
  void TimeScheme<dim>::accept(const double step)
  {
    system.fluid.old_velocity.swap(system.fluid.velocity);
    system.fluid.velocity.swap(new_velocity);
    system.fluid.pressure.swap(new_pressure);
    for (const auto &body : system.bodies)
      body->accept_step(step);
  }

  template class TimeScheme<2>;
  template class TimeScheme<3>;
} // namespace caudal
