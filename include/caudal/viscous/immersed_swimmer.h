// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_immersed_swimmer_h
#define caudal_viscous_immersed_swimmer_h

#include <caudal/base/outcome.h>
#include <caudal/io/checkpoints.h>
#include <caudal/viscous/advance.h>
#include <caudal/viscous/case_check.h>
#include <caudal/viscous/checkpoint.h>

#include <functional>

namespace caudal
{
  /** Elastic bodies that swim in a viscous fluid, by the immersed boundary method: a run. */
  template <int dim>
  class ImmersedSwimmer
  {
  public:
    using Parameters = RunParameters<dim>;
    using Checkpoint = caudal::Checkpoint;

    /** On the coarse grid; @p parameters have to outlive the object. */
    ImmersedSwimmer(const RunParameters<dim> &parameters, MPI_Comm communicator);

    /** Sets up the state at t = 0; refuses what can't work. */
    void start();

    /** Sets up the state of the checkpoint instead. */
    void resume_from(Checkpoint checkpoint);

    /** Resolution, costs and warnings of the case. A fast check makes no trial steps. */
    void check(std::ostream &out, bool fast);

    /** The values of all parameters, which checkpoints keep to be compared. */
    void set_parameter_values(const ParameterValues &values);

    /** Runs to the end time, or until @p stop_requested or the wall time says so. */
    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    const RunParameters<dim> &parameters;
    const MPI_Comm            communicator;
    Timer                     clock;
    Operators<dim>            operators;
    State<dim>                state;
    StepReport<dim>           report; // of the step that led to the state
    Observers<dim>            observers;
    CheckpointWriter          writer;
    ParameterValues           parameter_values;
    std::optional<Checkpoint> resumed; // the fluid's fields have been taken from it

    void             check_places() const; // of the bodies
    void             print_summary(const CaseCheck<dim> &check, std::ostream &out) const;
    StepCost         try_steps(unsigned int n_steps);
    Observation<dim> observe() const;
    void             adapt_grid(Log &log);
    Step<dim>        advance_with_retries(Log &log) const;
    void             run_to_end(Log &log, const std::function<bool()> &stop_requested);
    void             write_checkpoint();
    void             write_last_state(Log &log);
    unsigned int     get_memory() const; // the most so far [MiB], on all ranks
    /** Prints what @p n_steps over @p duration [s] cost; @p period of the tail beats [s] or 0. */
    void print_costs(unsigned int n_steps, double duration, double period, std::ostream &out) const;
  };
} // namespace caudal

#endif
