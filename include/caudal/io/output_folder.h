// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_output_folder_h
#define caudal_io_output_folder_h

#include <deal.II/base/mpi.h>

#include <string>

namespace caudal
{
  /**
   * The folder that holds all results of one run. It is created and tested
   * before anything is computed, since a run that can't write is worth nothing.
   *
   * A folder belongs to Caudal if it holds a parameters.prm that starts with
   * Caudal's signature; only from such a folder are the results of an earlier
   * run removed. Any other folder has to be empty.
   */
  class OutputFolder
  {
  public:
    enum class Start
    {
      fresh, ///< removes the results of an earlier run
      resume ///< keeps them: the run goes on in its own folder
    };

    /** Creates and tests the folder. Collective; throws on every rank or on none. */
    OutputFolder(const std::string &path, MPI_Comm communicator, Start start = Start::fresh);

    /** The path of a file in this folder; without @p name that of the folder itself. */
    std::string path(const std::string &name = "") const;

    /** Writes the complete parameters of the run to parameters.prm. Collective. */
    void write_parameters(const std::string &parameters) const;

  private:
    const std::string folder;
    const MPI_Comm    communicator;
  };
} // namespace caudal

#endif
