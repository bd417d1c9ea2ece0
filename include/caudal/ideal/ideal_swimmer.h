// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_ideal_swimmer_h
#define caudal_ideal_ideal_swimmer_h

#include <caudal/base/outcome.h>
#include <caudal/ideal/ideal_case.h>
#include <caudal/ideal/ideal_state.h>
#include <caudal/ideal/stroke_model.h>
#include <caudal/io/checkpoints.h>
#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>

#include <functional>

namespace caudal
{
  /** A run in an ideal fluid: a body of prescribed deformation swims at each frequency. */
  class IdealSwimmer
  {
  public:
    using Parameters = IdealParameters;
    using Checkpoint = IdealState;

    /** Sets up surface, body and gait; refuses what can't work. Refers to the parameters. */
    IdealSwimmer(const IdealParameters &parameters, MPI_Comm communicator);

    /** There is nothing to set up for a run that is not resumed. */
    void start() {}

    /** Says what the case is like, which is always fast. */
    void check(std::ostream &out, bool /*fast*/) const
    {
      the_case.print_summary(out);
      out << "No problems found.\n";
    }

    /** The values of all parameters, which checkpoints keep to be compared. */
    void set_parameter_values(const ParameterValues &values)
    {
      state.parameters = values;
    }

    /** run() is to go on from this state. */
    void resume_from(IdealState resumed)
    {
      state = std::move(resumed);
    }

    /** Swims at all frequencies, or until @p stop_requested or the wall time says so. */
    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    /** What all swims of a run write to. */
    struct Output
    {
      const OutputFolder &folder;
      Log                &log;
      FieldOutput         fields;
    };

    std::unique_ptr<ideal::StrokeModel> create_model(Log &log);

    /** Returns whether the swim has come to its end. */
    bool swim(ideal::StrokeModel &model, double frequency, SwimState &swim_state, Output &output,
              const std::function<bool()> &stop_requested);

    /** "_0.64Hz" in the names of files, if there are several frequencies. */
    std::string get_suffix(double frequency) const;

    void write_checkpoint(const Output &output);
    void remove_later_results(const Output &output) const;
    void write_summaries(ideal::StrokeModel &model, const OutputFolder &folder, Log &log) const;

    const IdealParameters &parameters;
    const MPI_Comm         communicator;
    const IdealCase        the_case;
    ideal::SwimmingShape   swimming_shape;
    CheckpointWriter       checkpoints;
    IdealState             state;
  };
} // namespace caudal

#endif
