// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_checkpoints_h
#define caudal_io_checkpoints_h

#include <caudal/io/output_folder.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <optional>
#include <string>
#include <vector>

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

  /** A checkpoint that was read. */
  struct CheckpointSlot
  {
    std::string              data;       ///< on all ranks
    std::vector<std::string> parts;      ///< this rank's share of them
    std::string              path;       ///< of its slot
    std::vector<std::string> skipped;    ///< newer slots that are not whole, and why
    std::string              parameters; ///< of the run, as a parameter file
    std::vector<std::string> damages;    ///< to the tables that it knows, a sentence each

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &data &path &skipped &parameters &damages;
    }
  };

  /** The newest whole checkpoint of the run in the folder; throws if there is none. Collective. */
  CheckpointSlot read_newest_checkpoint(const std::string &results, MPI_Comm communicator);

  /** The parameters in the newest whole checkpoint of the run in the folder; throws likewise. */
  std::string find_newest_parameters(const std::string &results);

  /** Whether there are checkpoints of the run in the folder, whole or not. */
  bool has_checkpoints(const std::string &results);

  /** Removes all checkpoints of the run in the folder, and nothing else. */
  void remove_checkpoints(const std::string &results);

  /** Removes the slots after that of the step with the number @p step. Collective. */
  void remove_checkpoints_after(const std::string &results, unsigned int step,
                                MPI_Comm communicator);

  /**
   * Writes a run's checkpoints when they are due; knows when its wall time is over.
   *
   * They are in the folder `restart` of its results: one slot for each, `step-00000120`, with the
   * state, a part of it that each rank writes, `part-00000`, the run's parameters.prm, and a
   * manifest that holds sizes and CRC-32 sums of all and of the tables as they were then. A slot is
   * written under another name, synchronised with the disk, as is all that the run had written
   * before, and then renamed, so that it is whole or not there; older ones are removed only after
   * that.
   */
  class CheckpointWriter
  {
  public:
    /** The wall time of the run counts from here on. */
    CheckpointWriter(const CheckpointParameters &parameters, MPI_Comm communicator);

    /** @p output_folder is that of the run's results; it outlives the object. */
    void start(const OutputFolder &output_folder);

    /** Whether the number of steps or the wall time ask for a checkpoint. Collective. */
    bool is_due(unsigned int step) const;

    /** Whether the last one is that of this step. */
    bool has_written(unsigned int step) const
    {
      return last_step == step;
    }

    /**
     * Writes the state after the step with the number @p step at @p time [s]: the @p data of rank
     * 0, and what each rank has of the rest, its @p part, which may be nothing. Throws on all ranks
     * if the disk refuses; what was there before stays. Collective.
     */
    void write(const std::string &data, const std::string &part, unsigned int step, double time);

    /** Whether the run has used up its wall time. Collective. */
    bool is_out_of_time() const;

  private:
    const CheckpointParameters &parameters;
    const MPI_Comm              communicator;
    const dealii::Timer         run_clock;
    dealii::Timer               clock; // since the last one
    const OutputFolder         *output = nullptr;
    std::optional<unsigned int> last_step;

    /** What the disk says if it refuses; "" if it does not. */
    std::string try_to_write(const std::string &data, const std::string &part, unsigned int step,
                             double time) const;
  };

  /** A sentence on a run that stopped after a step, on request or as its wall time was over. */
  std::string describe_stop(bool on_request, double time, unsigned int step,
                            const std::string &results);
} // namespace caudal

#endif
