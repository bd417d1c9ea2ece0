// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_fish_passage_h
#define caudal_passage_fish_passage_h

#include <caudal/base/outcome.h>
#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>
#include <caudal/passage/answers.h>

#include <deal.II/base/timer.h>

#include <functional>

namespace caudal
{
  /** A run of the model `passage`: can these fish pass this way? */
  class FishPassage
  {
  public:
    using Parameters = PassageParameters;

    /** Refers to the parameters. */
    FishPassage(const PassageParameters &parameters, const MPI_Comm communicator)
        : parameters(parameters)
        , communicator(communicator)
    {}

    /** Answers everything that is asked, so that nothing is written if something can't be. */
    void start();

    /** Says the answers, which takes no time. */
    void check(std::ostream &out, bool fast) const;

    /** Parameter values are not kept: there are no checkpoints. */
    void set_parameter_values(const ParameterValues &) {}

    /** Writes the answers. */
    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    const PassageParameters &parameters;
    const MPI_Comm           communicator;
    const Timer              timer;
    passage::Answers         answers; // on rank 0
  };
} // namespace caudal

#endif
