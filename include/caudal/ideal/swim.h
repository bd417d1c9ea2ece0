// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_swim_h
#define caudal_ideal_swim_h

#include <caudal/ideal/ideal_state.h>
#include <caudal/ideal/surface_output.h>
#include <caudal/io/statistics.h>

namespace caudal
{
  /** The times of output and the ends of the strokes. */
  struct Instants
  {
    std::vector<double> times; // [s]
    std::vector<bool>   is_output, ends_stroke;

    /** Strokes without a @p period (0) have no ends. */
    Instants(const std::vector<double> &output_times, double period);
  };

  /** A swim at one frequency, which goes from instant to instant, is accounted for and output. */
  class Swim
  {
  public:
    /** Goes on from the @p state, with a row of @p table for each time. Refers to all arguments. */
    Swim(const ideal::MotionProblem &problem, const Instants &instants, const Gait &gait,
         bool has_torques, const OutputParameters &output, Statistics &table,
         ideal::SurfaceOutput &surface, SwimState &state);

    /** Takes the first instant. Collective. */
    void start(const ideal::Screw &impulse);

    /** The motion at the next instant; changes nothing. Collective. */
    ideal::BodyState integrate() const;

    /** Makes @p body the state at the next instant. Collective. */
    void take(const ideal::BodyState &body);

    bool is_at_end() const
    {
      return next == instants.times.size();
    }

  private:
    void write();

    const ideal::MotionProblem &problem;
    const Instants             &instants;
    const Gait                 &gait;
    const bool                  has_torques;
    const OutputParameters     &output;
    Statistics                 &table;
    ideal::SurfaceOutput       &surface;
    SwimState                  &state;
    std::size_t                 next = 0; // instant
  };
} // namespace caudal

#endif
