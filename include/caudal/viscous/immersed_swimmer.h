#ifndef caudal_viscous_immersed_swimmer_h
#define caudal_viscous_immersed_swimmer_h

#include <caudal/base/outcome.h>
#include <caudal/viscous/case_check.h>
#include <caudal/viscous/checkpoints.h>
#include <caudal/viscous/failure_report.h>
#include <caudal/viscous/guards.h>
#include <caudal/viscous/parameters.h>
#include <caudal/viscous/run_output.h>

#include <functional>

namespace caudal
{
  /** Elastic bodies that swim in a viscous fluid: the immersed boundary method. */
  template <int dim>
  class ImmersedSwimmer
  {
  public:
    using Parameters = RunParameters<dim>;
    using State      = RunState;

    /** Sets up grids, fields and bodies at t = 0. */
    ImmersedSwimmer(const RunParameters<dim> &parameters, MPI_Comm communicator);

    /** Resolution, costs, doubts: what the case is like. A fast check makes no trial steps. */
    void check(std::ostream &out, bool fast);

    /** The values of all parameters, which checkpoints keep to be compared. */
    void set_parameter_values(const ParameterValues &values);

    /** run() is to go on from this state. */
    void resume_from(RunState state);

    /** Runs to the end time, or until @p stop_requested or the wall time says so. */
    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    const RunParameters<dim>                       &parameters;
    MPI_Comm                                        communicator;
    Timer                                           clock;
    mutable TimerOutput                             timer;
    parallel::distributed::Triangulation<dim>       triangulation;
    const CellLattice<dim>                          lattice;
    FluidSpace<dim>                                 space;
    MomentumOperator<dim>                           momentum;
    CoupledSystem<dim>                              coupled_system;
    FluidState<dim>                                 fluid;
    std::vector<std::unique_ptr<SwimmingBody<dim>>> bodies;
    std::unique_ptr<FinestCells<dim>>               finest_cells;
    const ImmersedSystem<dim>                       system;
    GridAdaptation<dim>                             adaptation;
    std::unique_ptr<TimeScheme<dim>>                scheme;
    Checkpoints<dim>                                checkpoints;
    Guards<dim>                                     guards;
    ParameterValues                                 parameter_values;
    std::optional<RunState>                         resumed;

    /** Cells, unknowns and sizes, with warnings about what is likely to go wrong. */
    void print_summary(const CaseCheck<dim> &check, std::ostream &out) const;
    /** Of @p n_steps over @p duration [s], with tail beats of @p period [s], 0 for none. */
    void print_costs(unsigned int n_steps, double duration, double period, std::ostream &out) const;
    unsigned int     get_memory() const; // the most so far [MiB], on all ranks
    BoundingBox<dim> get_domain() const;
    void             check_probes() const;
    void             check_bodies() const;
    void             check_control_volume() const;
    void             start_bodies();
    void             adapt_grid(const TimeStepper &stepper, RunOutput<dim> &output, Log &log);
    TrialCost        try_steps(unsigned int n_steps);
    StepResult<dim>  advance(TimeStepper &stepper, Log &log);
    void reject(TimeStepper &stepper, FailureKind kind, const std::string &reason, Log &log);
    void write_last_state(const TimeStepper &stepper, RunOutput<dim> &output, Log &log);
    void run_to_end(TimeStepper &stepper, RunOutput<dim> &output, Log &log,
                    const std::function<bool()> &stop_requested);
  };
} // namespace caudal

#endif
