// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_checkpoint_writer_h
#define caudal_io_checkpoint_writer_h

#include <caudal/io/checkpoint_folder.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <optional>

namespace caudal
{
  /** Section `Checkpoint`. */
  struct CheckpointParameters
  {
    unsigned int step_interval      = 0;
    double       wall_time_interval = 15; // [min]
    unsigned int n_slots            = 2;
    double       wall_time_limit    = 0; // [h]

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };

  /** Writes a run's checkpoints when they are due; knows when its wall time is over. */
  class CheckpointWriter
  {
  public:
    /** The wall time of the run counts from here on. */
    CheckpointWriter(const CheckpointParameters &parameters, MPI_Comm communicator);

    /** @p results is the folder of the run's results; it exists. */
    void start(const std::string &results);

    /** Whether the number of steps or the wall time ask for a checkpoint. Collective. */
    bool is_due(unsigned int step) const;

    /** Whether the last one is that of this step. */
    bool has_written(unsigned int step) const
    {
      return last_step == step;
    }

    /** See CheckpointFolder::write(). Collective. */
    void write(const std::string &data, unsigned int step, double time);

    /** Whether the run has used up its wall time. Collective. */
    bool is_out_of_time() const;

  private:
    const CheckpointParameters     &parameters;
    const MPI_Comm                  communicator;
    const dealii::Timer             run_clock;
    dealii::Timer                   clock; // since the last one
    std::optional<CheckpointFolder> folder;
    std::optional<unsigned int>     last_step;
  };

  /** A sentence on a run that stopped after a step, on request or as its wall time was over. */
  std::string describe_stop(bool on_request, double time, unsigned int step,
                            const std::string &results);
} // namespace caudal

#endif
