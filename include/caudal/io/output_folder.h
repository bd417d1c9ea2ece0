// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_output_folder_h
#define caudal_io_output_folder_h

#include <caudal/base/outcome.h>

#include <deal.II/base/mpi.h>

#include <functional>
#include <memory>
#include <set>
#include <string>

namespace caudal
{
  /** What becomes of the results of an earlier run in the folder of a new one. */
  enum class ExistingResults
  {
    refuse,  ///< they stay, and the new run is refused
    number,  ///< they stay as `<folder>.1`, `.2`, ..., unless the run can be resumed: it is refused
    replace, ///< they are removed, finished or not
  };

  /**
   * The folder that holds all results of one run. It is created and tested before anything is
   * computed, since a run that can't write is worth nothing.
   *
   * Two of its files are about the folder itself. `manifest.txt` says whether the run is finished
   * and lists what it has written; nothing else is ever removed. `lock` is locked by the process
   * that writes here, and names it: the folder is refused to any other. A process that has died
   * leaves the file, but not the lock. A folder without a manifest has to be empty.
   */
  class OutputFolder
  {
  public:
    enum class Start
    {
      fresh, ///< a new run
      resume ///< the run goes on in its own folder
    };

    /** How far the run in a folder has come. */
    enum class Progress
    {
      none,       ///< there is no run
      unfinished, ///< it is running, was stopped, or was killed
      failed,     ///< it ended with an error
      finished
    };

    /**
     * Creates, locks and tests the folder and, for a fresh start, makes room in it. Collective;
     * throws on every rank or on none.
     */
    OutputFolder(const std::string &path, MPI_Comm communicator, Start start = Start::fresh,
                 ExistingResults existing = ExistingResults::number);
    ~OutputFolder();

    /** The path of a file in this folder; without @p name that of the folder itself. */
    std::string path(const std::string &name = "") const;

    /** The path of a file that the run writes: the manifest lists it from here on. */
    std::string add(const std::string &name) const;

    /** add() for a file that only grows, so that checkpoints can say how long it was. */
    std::string add_table(const std::string &name) const;

    /** Where the results of an earlier run, which were here, are kept; empty if there were none. */
    const std::string &get_kept_results() const
    {
      return kept_results;
    }

    /** Writes the complete parameters of the run to parameters.prm. Collective. */
    void write_parameters(const std::string &text) const;

    /** What write_parameters() has written. */
    const std::string &get_parameters() const
    {
      return parameters;
    }

    /**
     * Runs @p run, and notes in the manifest how it ends; the tables are written as CSV then, too,
     * also if the run fails. Collective.
     */
    Outcome record(const std::function<Outcome()> &run) const;

    /** Waits until the disk has all that was written so far. On rank 0 alone. */
    void synchronise() const;

    /** The files of add_table(). On rank 0 alone. */
    const std::set<std::string> &get_tables() const
    {
      return tables;
    }

    /** How far the run in the folder @p path has come. */
    static Progress find_progress(const std::string &path);

  private:
    class Lock;
    class Manifest;

    const std::string             folder;
    const MPI_Comm                communicator;
    std::unique_ptr<Lock>         lock;     // on rank 0
    std::unique_ptr<Manifest>     manifest; // on rank 0
    mutable std::set<std::string> tables;
    mutable std::string           parameters;
    std::string                   kept_results; // on rank 0

    void prepare(Start start, ExistingResults existing);
    void make_room(Progress progress, ExistingResults existing);
    void write_csv_tables() const; // on rank 0
  };
} // namespace caudal

#endif
