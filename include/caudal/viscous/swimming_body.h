#ifndef caudal_viscous_swimming_body_h
#define caudal_viscous_swimming_body_h

#include <caudal/fish/controller.h>
#include <caudal/fish/gait.h>
#include <caudal/fish/muscle.h>
#include <caudal/fish/spine.h>
#include <caudal/solid/elasticity.h>
#include <caudal/solid/surface_load.h>
#include <caudal/viscous/coupled_system.h>

#include <boost/serialization/vector.hpp>

namespace caudal
{
  /** A section `Body <name>`: the solid and what moves it. */
  template <int dim>
  struct SwimmingBodyParameters
  {
    SolidParameters<dim>  solid;
    MuscleParameters<dim> muscle;
    GaitParameters        gait;
    ControllerParameters  controller;
    std::string           lateral_frame = "domain";
    double                gait_damping  = 1e8;

    SwimmingBodyParameters(const std::string &name, const std::vector<std::string> &regions);
    void add_parameters(ParameterHandler &prm);
    void check(bool is_explicit) const;
  };

  /**
   * A body that swims: the solid, its muscle, gait and controller, its
   * interaction with the fluid, and the state at the end of the step that is
   * being computed ("new"), which accept_step() makes the present one.
   */
  template <int dim>
  class SwimmingBody
  {
  public:
    SwimmingBody(const SwimmingBodyParameters<dim> &parameters, const CouplingParameters &coupling,
                 double fluid_density, MPI_Comm communicator);

    const std::string &get_name() const
    {
      return solid.get_name();
    }
    const SwimmingBodyParameters<dim> &get_parameters() const
    {
      return parameters;
    }

    /** Controller and muscle decide on the step from @p time of length @p step. */
    void prepare_step(double time, double step);

    /** The muscle's fields at @p time, in the prepared step. */
    ActiveLoad<dim> get_active_load(double time) const;

    /** elastic_system at the nodal positions @p x, for muscle and surface load at @p time. */
    void assemble_forces(const Vector<double> &x, double time, bool with_stiffness);

    /** What the feedback force does at positions @p x and velocities @p v, tested with N_a. */
    Vector<double> compute_feedback_force(const Vector<double> &x, const Vector<double> &v) const;

    /**
     * Velocity that the gait asks for, up to a rigid motion, at the nodal
     * positions @p x: the deformation velocity of the prescribed shape, laid
     * over the body by a rotation and a translation, plus its distance from x
     * over @p relaxation_time [s].
     */
    Vector<double> compute_gait_velocity(const Vector<double> &x, double time,
                                         double relaxation_time) const;

    /** Sets rigid_moments and rigid_inertia of the equations for rigid motions of @p x. */
    void set_up_rigid_motions(const Vector<double> &x);

    bool has_gait() const
    {
      return gait->is_prescribed();
    }
    /** Whether a muscle or a gait moves it. */
    bool swims() const
    {
      return has_gait() || muscle->has_force() || muscle->has_active_stress();
    }

    /**
     * Work of the step, by the midpoint rule from the forces of elastic_system and
     * new_feedback_force: the new state becomes the present one.
     */
    void accept_step(double step);

    /** Lateral position [m] of the muscle's monitored point, as the muscle is told. */
    double get_lateral_position() const;
    /** Velocity of the centre of mass. */
    Tensor<1, dim> get_mean_velocity() const
    {
      return solid.compute_mean(solid.velocity);
    }
    /** The direction in which the fish looks, from tail to nose. */
    Tensor<1, dim> get_forward_direction() const;
    double         get_activation() const
    {
      return muscle->activation(contraction);
    }
    double get_length() const
    {
      return length;
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

    /** What the next step and the reports depend on; reading back another body's state throws. */
    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      Vector<double>              initial_positions = solid.initial_positions;
      std::vector<double>         muscle_state      = muscle_memory;
      archive &initial_positions &solid.positions &solid.old_positions &solid.velocity;
      archive &solid.old_velocity &solid.force_density  &elastic_system.active_force;
      archive &muscle_work &feedback_work &muscle_power &muscle_state;
      if (Archive::is_loading::value)
        restore(initial_positions, muscle_state);
    }

    SolidBody<dim>           solid;
    InteractionOperator<dim> interaction;
    ElasticSystem            elastic_system;
    BodyEquations            equations;
    SparseMatrix<double>     response;

    Vector<double>     new_positions, new_velocity, new_force_density;
    Vector<double>     new_feedback_force; // in the middle of the step, for its work
    DeformationSummary deformation;

    // Since the start [J/m in 2D]
    double muscle_work = 0, feedback_work = 0;
    double muscle_power = 0; // of the last step [W/m in 2D]
    /** |Phi.(M_s U) - f.u| relative to the larger of the sums of their moduli, in the last step. */
    double power_identity = 0;

  private:
    const SwimmingBodyParameters<dim>     &parameters;
    double                                 length;
    std::unique_ptr<Muscle<dim>>           muscle;
    std::unique_ptr<Gait>                  gait;
    std::unique_ptr<PrescribedMotion<dim>> gait_motion; // of the nodes
    std::unique_ptr<Controller>            controller;
    MuscleMemory                           muscle_memory;
    Contraction                            contraction;
    SurfaceLoad<dim>                       surface_load;
    unsigned int                           lateral_point = 0;

    /** Throws if muscle or gait count s from another place than the body's nose. */
    void         check_nose() const;
    SwimmerState get_swimmer_state(double time, double step) const;
    void restore(const Vector<double> &initial_positions, const std::vector<double> &muscle_state);
  };
} // namespace caudal

#endif
