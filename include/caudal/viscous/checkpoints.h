#ifndef caudal_viscous_checkpoints_h
#define caudal_viscous_checkpoints_h

#include <caudal/io/checkpoint_writer.h>
#include <caudal/viscous/grid_adaptation.h>
#include <caudal/viscous/run_output.h>
#include <caudal/viscous/run_state.h>

namespace caudal
{
  /**
   * Writes the checkpoints of a run and brings it back to one.
   *
   * A run that goes on after a checkpoint goes on from what it has written, as
   * a resumed one does: the grid is built anew, with its own order of cells,
   * unknowns and ranks, and factorisations are forgotten. So both give the same
   * bits, and a checkpoint changes the results no more than the solver's
   * tolerance does.
   */
  template <int dim>
  class Checkpoints
  {
  public:
    Checkpoints(const RunParameters<dim>                  &parameters,
                parallel::distributed::Triangulation<dim> &triangulation, FluidSpace<dim> &space,
                GridAdaptation<dim> &adaptation, const ImmersedSystem<dim> &system);

    /** @p values of the run's parameters, which each checkpoint holds. */
    void start(const OutputFolder &folder, const ParameterValues &values, TimeStepper &stepper,
               RunOutput<dim> &output);

    /** Whether the steps or the wall time ask for a checkpoint. Collective. */
    bool is_due() const;

    /** Writes one, unless there is one of this step; @p goes_on: whether the run does. */
    void write(bool goes_on);

    /** Brings fluid, bodies, stepper and output to the @p state. */
    void restore(const RunState &state);

    /** Whether the run has used up its wall time. Collective. */
    bool is_out_of_time() const
    {
      return writer.is_out_of_time();
    }

  private:
    const RunParameters<dim>                  &parameters;
    parallel::distributed::Triangulation<dim> &triangulation;
    FluidSpace<dim>                           &space;
    GridAdaptation<dim>                       &adaptation;
    ImmersedSystem<dim>                        system;
    MPI_Comm                                   communicator;
    CheckpointWriter                           writer;
    ParameterValues                            values;
    TimeStepper                               *stepper = nullptr;
    RunOutput<dim>                            *output  = nullptr;

    RunState take_state() const;
  };
} // namespace caudal

#endif
