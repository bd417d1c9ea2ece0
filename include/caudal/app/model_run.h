// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_app_model_run_h
#define caudal_app_model_run_h

#include <caudal/base/declared_parameters.h>
#include <caudal/base/outcome.h>
#include <caudal/base/parameter_file.h>
#include <caudal/io/figures.h>
#include <caudal/io/output_folder.h>

#include <functional>

namespace caudal
{
  /**
   * A case of the model @p Swimmer as its parameter file describes it, which starts, or goes on
   * from a checkpoint. The swimmer names its Parameters and, if it writes checkpoints, its
   * Checkpoint, and is constructed for each run.
   */
  template <class Swimmer>
  class ModelRun
  {
  public:
    using Parameters = typename Swimmer::Parameters;

    /** Reads and checks all parameters. */
    ModelRun(const ParameterFile &file, MPI_Comm communicator);

    /** Says what the case is like; a fast check makes no trial steps. Writes nothing. */
    void check(std::ostream &out, bool fast) const;

    /** Runs the case in its folder, from the start. */
    Outcome start(const std::function<bool()> &stop_requested) const;

    /** Whether its folder holds a run with a checkpoint. */
    bool can_be_resumed() const;

    /** Goes on in its folder from the newest whole checkpoint. */
    Outcome resume(const std::function<bool()> &stop_requested) const;

    Parameters parameters;

  private:
    const ParameterFile &file;
    const MPI_Comm       communicator;
    FigureParameters     figures;
    ParameterValues      values;
    std::string          text; // of all parameters

    /** What the user should know of the parameters that were given. */
    std::vector<std::string> remarks;

    Outcome run(Swimmer &swimmer, const OutputFolder &folder, bool is_resumed,
                const std::vector<std::string> &messages,
                const std::function<bool()>    &stop_requested) const;
  };
} // namespace caudal

#endif
