#ifndef caudal_viscous_time_scheme_h
#define caudal_viscous_time_scheme_h

#include <caudal/base/time_stepping.h>
#include <caudal/fluid/fluid_state.h>
#include <caudal/viscous/coupled_system.h>
#include <caudal/viscous/swimming_body.h>

namespace caudal
{
  /** Everything that a step works on. */
  template <int dim>
  struct ImmersedSystem
  {
    FluidSpace<dim>                                 &space;
    MomentumOperator<dim>                           &momentum;
    CoupledSystem<dim>                              &coupled_system;
    FluidState<dim>                                 &fluid;
    std::vector<std::unique_ptr<SwimmingBody<dim>>> &bodies;
    const CellLattice<dim>                          &lattice;
    std::unique_ptr<FinestCells<dim>>               &finest_cells;
    const SolverParameters                          &solver;
    TimerOutput                                     &timer;
  };

  /** What a step tells. */
  template <int dim>
  struct StepResult
  {
    unsigned int            iterations = 0;
    TimeStepper::Indicators indicators;
    /** Of the velocity at t^{n+1}. */
    FlowSummary<dim> flow;
    /**
     * What the scheme's own damping has taken from the fluid in the step [J/m in 2D]: with BDF2
     * rho/4 |u^{n+1} - 2 u^n + u^{n-1}|^2, for equal steps (Hairer & Wanner 1996,
     * doi:10.1007/978-3-642-05221-7, V.6: the G-norm of the method).
     */
    double damping = 0;
  };

  /**
   * A time scheme: from the state at t^n to the trial state at t^{n+1}, which
   * accept() makes the present one. advance() throws if the step fails.
   */
  template <int dim>
  class TimeScheme
  {
  public:
    virtual ~TimeScheme() = default;

    virtual StepResult<dim> advance(const TimeStepper &stepper) = 0;

    /** The trial state becomes the present one. */
    void accept(const double step);

  protected:
    explicit TimeScheme(const ImmersedSystem<dim> &system);

    /** Computes the interaction operator of a body for the nodal positions @p x. */
    void update_interaction(SwimmingBody<dim> &body, const Vector<double> &x);

    /**
     * Solves the system that MomentumOperator has assembled for the
     * corrections to new_velocity and new_pressure (and to the bodies'
     * equations in @p coupled); updates both. Returns the iterations.
     */
    unsigned int solve(FieldVector                                          &residual,
                       const std::vector<typename CoupledSystem<dim>::Body> &coupled,
                       const MomentumWeights &weights, bool matrix_changed);

    /** Augmentation gamma of the present step [Pa s]. */
    double get_augmentation(double inertia) const;

    /** Throws unless velocities are finite and no body cell is inverted; fills the indicators. */
    StepResult<dim> check_trial_state(unsigned int iterations, double step,
                                      const std::vector<Vector<double>> &predicted);

    ImmersedSystem<dim> system;
    FieldVector         new_velocity, new_pressure;
  };

  template <int dim>
  std::unique_ptr<TimeScheme<dim>> create_explicit_scheme(const ImmersedSystem<dim> &system);

  template <int dim>
  std::unique_ptr<TimeScheme<dim>> create_semi_implicit_scheme(const ImmersedSystem<dim> &system);
} // namespace caudal

#endif
