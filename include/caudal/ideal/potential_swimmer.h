#ifndef caudal_ideal_potential_swimmer_h
#define caudal_ideal_potential_swimmer_h

#include <caudal/base/outcome.h>
#include <caudal/ideal/potential_state.h>
#include <caudal/ideal/stroke_model.h>
#include <caudal/io/checkpoint_writer.h>
#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>

#include <functional>

namespace caudal
{
  /** A body of prescribed deformation that swims in an ideal fluid: boundary elements. */
  class PotentialSwimmer
  {
  public:
    using Parameters = PotentialParameters;
    using Checkpoint = PotentialState;

    /** Sets up surface, body and gait; refuses what can't work. */
    PotentialSwimmer(const PotentialParameters &parameters, MPI_Comm communicator);

    /** There is nothing to set up for a run that is not resumed. */
    void start() {}

    /** Says what the case is like, which is always fast. */
    void check(std::ostream &out, bool fast) const;

    /** The values of all parameters, which checkpoints keep to be compared. */
    void set_parameter_values(const ParameterValues &values);

    /** run() is to go on from this state. */
    void resume_from(PotentialState resumed);

    /** Swims at all frequencies, or until @p stop_requested or the wall time says so. */
    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    void                                check_shape() const;
    bool                                uses_table() const;
    bool                                is_periodic() const;  // and not rigid
    bool                                is_from_rest() const; // and without external forces
    bool                                has_torques() const;
    ideal::Torques                      get_torques() const;
    std::unique_ptr<ideal::StrokeModel> create_model(double increment, Log &log);
    ideal::MotionProblem                make_problem(ideal::StrokeModel &model, double rate) const;
    void        print_summary(std::ostream &out) const; // sizes, and what is likely to surprise
    std::string get_suffix(double frequency) const;     // of the files of its swim
    void        remove_later_results(const OutputFolder &folder, FieldOutput &fields) const;
    SwimSummary make_summary(double frequency, const SwimState &swim) const;
    void        write_summaries(ideal::StrokeModel &model, const OutputFolder &folder, Log &log);
    void        write_checkpoint();

    /** Returns whether the swim has come to its end. */
    bool swim(ideal::StrokeModel &model, double frequency, SwimState &swim_state,
              const OutputFolder &folder, FieldOutput &fields, Log &log,
              const std::function<bool()> &stop_requested);

    const PotentialParameters                &parameters;
    const MPI_Comm                            communicator;
    const ideal::Surface                      surface;
    const std::unique_ptr<ideal::Gait>        gait;
    const std::unique_ptr<ideal::Shape>       shape;
    const std::unique_ptr<ideal::Deformation> deformation;
    std::unique_ptr<ideal::SwimmingShape>     swimming_shape;
    CheckpointWriter                          checkpoints;
    PotentialState                            state;
  };
} // namespace caudal

#endif
