#ifndef caudal_ideal_potential_swim_h
#define caudal_ideal_potential_swim_h

#include <caudal/ideal/potential_state.h>

namespace caudal
{
  /** The times of output and the ends of the strokes. */
  struct Instants
  {
    std::vector<double> times; // [s]
    std::vector<bool>   is_output, ends_stroke;

    /** Strokes of no @p period have no ends. */
    Instants(const std::vector<double> &output_times, double period);
  };

  /** A swim at one frequency, which goes from instant to instant and keeps account of it. */
  class PotentialSwim
  {
  public:
    /** Goes on from the @p state. */
    PotentialSwim(const ideal::MotionProblem &problem, const Instants &instants, bool has_torques,
                  PotentialOutput &output, SwimState &state);

    /** Takes the first instant. Collective. */
    void start(const ideal::Screw &impulse);

    /** The motion at the next instant; changes nothing. Collective. */
    ideal::BodyState integrate() const;

    /** Swims there: @p body becomes the state, which is accounted for and output. Collective. */
    void take(const ideal::BodyState &body);

    bool is_at_end() const
    {
      return next == instants.times.size();
    }

  private:
    const ideal::MotionProblem &problem;
    const Instants             &instants;
    const bool                  has_torques;
    PotentialOutput            &output;
    SwimState                  &state;
    std::size_t                 next; // instant
  };
} // namespace caudal

#endif
