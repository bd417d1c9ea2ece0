#ifndef caudal_io_checkpoint_folder_h
#define caudal_io_checkpoint_folder_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

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

  /**
   * The checkpoints of a run, in the folder `restart` of its results: one slot
   * for each, `step-00000120`, with the state and a manifest that holds sizes
   * and CRC-32 sums of both. A slot is written under another name, synchronised
   * with the disk and then renamed, so that it is whole or not there; older ones
   * are removed only after that.
   */
  class CheckpointFolder
  {
  public:
    /** A checkpoint that was read. */
    struct Checkpoint
    {
      std::string              data;    // on all ranks
      std::string              path;    // of its slot
      std::vector<std::string> skipped; // newer slots that are not whole, and why
    };

    /** @p results exists; @p n_slots is the number of checkpoints to keep. */
    CheckpointFolder(const std::string &results, unsigned int n_slots, MPI_Comm communicator);

    /**
     * Writes the @p data of rank 0, the state after the step with the number
     * @p step at @p time [s]. Throws on all ranks if the disk refuses; what
     * was there before stays. Collective.
     */
    void write(const std::string &data, unsigned int step, double time) const;

    /** The newest whole checkpoint; throws if there is none. Collective. */
    Checkpoint read_newest() const;

    /** Removes the slots after that of the step with the number @p step. Collective. */
    void remove_after(unsigned int step) const;

  private:
    const std::string  results, folder;
    const unsigned int n_slots;
    const MPI_Comm     communicator;

    void write_slot(const std::string &data, unsigned int step, double time) const;
  };

  /** Sends rank 0's text, of any length, to all ranks. Collective. */
  void broadcast_text(std::string &text, MPI_Comm communicator);
} // namespace caudal

#endif
