// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_checkpoint_folder_h
#define caudal_io_checkpoint_folder_h

#include <deal.II/base/mpi.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace caudal
{
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

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &data &path &skipped;
      }
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
} // namespace caudal

#endif
