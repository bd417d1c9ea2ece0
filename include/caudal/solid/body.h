// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_body_h
#define caudal_solid_body_h

#include <caudal/fish/controller.h>
#include <caudal/solid/body_state.h>
#include <caudal/solid/elasticity.h>
#include <caudal/solid/load.h>
#include <caudal/solid/rigid_motion.h>

namespace caudal
{
  /** A section `Body <name>`: the solid and what moves it. */
  template <int dim>
  struct BodyParameters
  {
    SolidParameters<dim>  solid;
    MuscleParameters<dim> muscle;
    GaitParameters        gait;
    ControllerParameters  controller;
    std::string           lateral_frame = "domain";
    double                gait_damping  = 1e8;

    BodyParameters(const std::string &name, const std::vector<std::string> &regions);
    void add_parameters(ParameterHandler &prm);
    void check(bool is_explicit) const;
  };

  /**
   * A body that is immersed in the fluid and may swim: the solid, its loads, and the muscle, gait
   * and controller that drive it. It does not change; what does is a BodyState. It is replicated
   * on all ranks.
   */
  template <int dim>
  class Body
  {
  public:
    /** @p gravity is the acceleration g [m/s^2]. */
    Body(const BodyParameters<dim> &parameters, const Surroundings &fluid,
         const Tensor<1, dim> &gravity);

    /** Grid, materials and matrices. */
    const SolidBody<dim> &get_solid() const
    {
      return solid;
    }
    const std::string &get_name() const
    {
      return solid.get_name();
    }
    const BodyParameters<dim> &get_parameters() const
    {
      return parameters;
    }
    /** Lengths of the body at rest, whose measurement takes a time as the square of its faces. */
    const BodyExtent<dim> &get_extent() const
    {
      return extent;
    }
    double get_length() const
    {
      return extent.length;
    }
    double get_gait_damping() const
    {
      return parameters.gait_damping;
    }
    const Gait &get_gait() const
    {
      return *gait;
    }
    /** The motion of the nodes that the gait prescribes, if there is one. */
    const PrescribedMotion<dim> &get_prescribed_motion() const
    {
      return *prescribed;
    }
    /** What it follows, to be told to the user; empty: nothing special. */
    std::string describe_gait() const
    {
      return gait->describe();
    }
    bool has_gait() const
    {
      return gait->is_prescribed();
    }
    bool has_muscle() const
    {
      return muscle->has_force() || muscle->has_active_stress();
    }
    /** Whether muscle or gait count the arc length from x = 0 of the body's frame. */
    bool counts_from_nose() const
    {
      return has_gait() || muscle->counts_from_nose();
    }
    /** Frequency of the beat [Hz] if parameters alone decide on it; otherwise 0. */
    double get_beat_frequency() const
    {
      return has_gait() ? gait->get_beat_frequency() : muscle->get_beat_frequency();
    }
    /** Whether a muscle or a gait moves it. */
    bool swims() const;

    /** Whether it moves along its axis, from the nose on: as fish do, unlike a ring of fibres. */
    bool undulates() const
    {
      return swims() && counts_from_nose();
    }

    /** Throws a sentence if the tables of muscle or gait end before @p end_time [s]. */
    void check_until(double end_time) const;

    /** At rest in the reference configuration, where the parameters have placed it. */
    BodyState make_initial_state() const;

    /** The motion of @p state at @p time, the end of the step of length @p step. */
    BodyMotion get_motion(const BodyState &state, const double time, const double step) const
    {
      return {state.positions, state.velocity, time, step, state.contraction};
    }

    /**
     * Throws a sentence unless @p state, read from a checkpoint with the @p initial_positions of
     * the body that it was of, is one of this body.
     */
    void check_state(const BodyState &state, const Vector<double> &initial_positions) const;

    /** Controller and muscle decide on the step of length @p step from @p state at @p time. */
    Contraction command_muscle(const BodyState &state, double time, double step) const;

    /** The forces b of the loads of the @p account [N, in 2D N/m]. */
    Vector<double> compute_force(LoadAccount account, const BodyMotion &motion) const;

    /**
     * The forces b of each account [N, in 2D N/m]; adds their derivatives to @p response unless
     * that is null.
     */
    ForcesByAccount compute_forces(const BodyMotion &motion,
                                   BodyResponse     *response = nullptr) const;

    /**
     * What is left of the forces C Phi for the constraint of the gait, without elastic and feedback
     * forces and gravity, of which @p forces has those at the same time, and without the inertia of
     * the excess mass, which Phi has with the opposite sign.
     */
    Vector<double> compute_gait_force(const Vector<double>  &force_density,
                                      const ForcesByAccount &forces,
                                      const Vector<double>  &acceleration) const;

    /** Lateral position of the muscle's monitored point, as the muscle is told [m]. */
    double get_lateral_position(const BodyState &state) const;
    /**
     * Position of the muscle's monitored point, in the laboratory's frame [m]; the mean of a body
     * that does not undulate.
     */
    Tensor<1, dim> get_monitored_position(const BodyState &state) const
    {
      return evaluate_monitored(state.positions);
    }
    /** Potential energy of its excess weight against where it began [J, in 2D J/m]. */
    double get_potential_energy(const BodyState &state) const;
    /** Velocity of the centre of mass [m/s]. */
    Tensor<1, dim> get_mean_velocity(const BodyState &state) const
    {
      return solid.compute_mean(state.velocity);
    }
    /** C Phi: its forces on the fluid, by node [N, in 2D N/m]. */
    Vector<double> compute_forces_on_fluid(const BodyState &state) const;
    /** The resultant of these forces [N, in 2D N/m]. */
    Tensor<1, dim> get_resultant(const BodyState &state) const;
    /** The direction in which the fish looks, from tail to nose. */
    Tensor<1, dim> get_forward_direction(const BodyState &state) const;
    /** Activation of the muscle in the middle of the last step, 1 at full strength [1]. */
    double get_activation(const BodyState &state) const
    {
      return muscle->activation(state.contraction);
    }

  private:
    const BodyParameters<dim>              &parameters;
    SolidBody<dim>                          solid;
    const BodyExtent<dim>                   extent;
    std::unique_ptr<Muscle<dim>>            muscle;
    std::unique_ptr<Gait>                   gait;
    std::unique_ptr<PrescribedMotion<dim>>  prescribed; // of the nodes; null without a gait
    std::unique_ptr<Controller>             controller;
    std::vector<std::unique_ptr<Load<dim>>> loads;
    unsigned int                            lateral_point = 0; // if it undulates
    Vector<double>                          excess_weight;     // empty if there is none

    void             check_nose() const;
    Tensor<1, dim>   evaluate_monitored(const Vector<double> &field) const;
    RigidMotion<dim> fit_head(const BodyState &state) const;
    SwimmerState     get_swimmer_state(const BodyState &state, double time, double step) const;
  };
} // namespace caudal

#endif
