#ifndef caudal_app_potential_swimmer_h
#define caudal_app_potential_swimmer_h

#include <caudal/app/outcome.h>
#include <caudal/app/potential_parameters.h>
#include <caudal/app/swim_summary.h>
#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>
#include <caudal/potential/stroke_model.h>

#include <functional>

namespace caudal
{
  /** A body of prescribed deformation that swims in an ideal fluid: boundary elements. */
  class PotentialSwimmer
  {
  public:
    /** Sets up surface, body and gait; refuses what can't work. */
    PotentialSwimmer(const PotentialParameters &parameters, MPI_Comm communicator);

    /** Sizes, and what is likely to surprise. */
    void print_summary(std::ostream &out) const;

    /** Swims at all frequencies, or until @p stop_requested says so. */
    Outcome run(const OutputFolder &folder, Log &log, const std::function<bool()> &stop_requested);

  private:
    void                                    check_shape() const;
    bool                                    uses_table() const;
    bool                                    is_from_rest() const; // and without external forces
    bool                                    has_torques() const;
    potential::Torques                      get_torques() const;
    std::unique_ptr<potential::StrokeModel> create_model(double increment, Log &log);
    potential::MotionProblem make_problem(potential::StrokeModel &model, double rate) const;
    SwimSummary              make_summary(double frequency) const;
    SwimSummary swim(potential::StrokeModel &model, double frequency, const std::string &suffix,
                     const OutputFolder &folder, FieldOutput &fields, Log &log,
                     const std::function<bool()> &stop_requested);

    const PotentialParameters                    &parameters;
    const MPI_Comm                                communicator;
    const potential::Surface                      surface;
    const std::unique_ptr<potential::Gait>        gait;
    const std::unique_ptr<potential::Shape>       shape;
    const std::unique_ptr<potential::Deformation> deformation;
    std::unique_ptr<potential::SwimmingShape>     swimming_shape;
  };
} // namespace caudal

#endif
