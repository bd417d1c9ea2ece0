// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/io/checkpoint_writer.h>

#include <cmath>
#include <sstream>

using namespace dealii;

namespace caudal
{
  void CheckpointParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Checkpoint");
    prm.add_parameter("Interval of steps", step_interval,
                      "Steps between two checkpoints, from which a run can be resumed; 0: the "
                      "wall time alone decides [1].",
                      Patterns::Integer(0));
    prm.add_parameter("Interval of wall time", wall_time_interval,
                      "Wall time between two checkpoints [min]; 0: the steps alone decide.");
    prm.add_parameter("Slots", n_slots, "The number of checkpoints that are kept [1].",
                      Patterns::Integer(1, 1000));
    prm.add_parameter("Wall time limit", wall_time_limit,
                      "Wall time after which the run finishes its step, writes a checkpoint and "
                      "ends with exit code 2 [h]; 0: no limit.");
    prm.leave_subsection();
  }

  void CheckpointParameters::check() const
  {
    check_not_negative("Checkpoint/Interval of wall time", wall_time_interval,
                       "Give a positive time [min], or 0 to count steps only.");
    check_not_negative("Checkpoint/Wall time limit", wall_time_limit,
                       "Give a positive time [h], or 0 for no limit.");
  }

  CheckpointWriter::CheckpointWriter(const CheckpointParameters &parameters,
                                     const MPI_Comm              communicator)
      : parameters(parameters)
      , communicator(communicator)
  {}

  void CheckpointWriter::start(const std::string &results)
  {
    folder.emplace(results, parameters.n_slots, communicator);
    clock.restart();
  }

  bool CheckpointWriter::is_due(const unsigned int step) const
  {
    const unsigned int interval = parameters.step_interval;
    const double       minutes  = parameters.wall_time_interval;
    const bool         by_steps = interval > 0 && step % interval == 0;
    const bool         by_time  = minutes > 0 && clock.wall_time() > 60 * minutes;
    return Utilities::MPI::max(static_cast<int>(by_steps || by_time), communicator) > 0;
  }

  void CheckpointWriter::write(const std::string &data, const unsigned int step, const double time)
  {
    folder->write(data, step, time);
    last_step = step;
    clock.restart();
  }

  bool CheckpointWriter::is_out_of_time() const
  {
    const double limit = parameters.wall_time_limit;
    return limit > 0 && Utilities::MPI::max(run_clock.wall_time(), communicator) > 3600 * limit;
  }

  std::string describe_stop(const bool on_request, const double time, const unsigned int step,
                            const std::string &results)
  {
    std::ostringstream text;
    text << (on_request ? "Stopped on request" : "Stopped by Checkpoint/Wall time limit")
         << " at t = " << time << " s, step " << step << ". To go on: caudal --resume " << results;
    return text.str();
  }
} // namespace caudal
