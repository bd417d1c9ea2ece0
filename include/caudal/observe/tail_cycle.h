// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_tail_cycle_h
#define caudal_observe_tail_cycle_h

#include <boost/serialization/vector.hpp>

#include <optional>
#include <vector>

namespace caudal
{
  /** One full cycle of the tail, from an up-crossing to the next. */
  struct TailCycle
  {
    double start     = 0; // [s]
    double end       = 0; // [s]
    double amplitude = 0; // half the distance from peak to trough [m]
  };

  /**
   * Finds the cycles of a lateral position y(t) while it is fed sample by sample.
   *
   * Peaks and troughs are accepted once the signal has come back from them by
   * a fifth of the last swing, so that ripples do not count. A cycle starts
   * where the signal rises through the mean of the trough before and the peak
   * after: a mean that follows the fish when it drifts sideways. The time of the
   * crossing is interpolated between the samples.
   */
  class TailCycleDetector
  {
  public:
    /** Swings below twice @p smallest_amplitude [m] are no swings. */
    explicit TailCycleDetector(double smallest_amplitude);

    /** Takes the next sample, in s and m; the cycle that became complete with it, if any. */
    std::optional<TailCycle> add(double time, double position);

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &times &positions &direction &extreme &opposite &swing &start &amplitude;
    }

  private:
    std::optional<TailCycle> accept_peak();
    void                     accept_trough();
    double                   get_up_crossing() const;

    double              smallest_swing; // [m]
    std::vector<double> times;          // since the last trough
    std::vector<double> positions;
    int                 direction = 0;  // +1 rising, -1 falling, 0 not known yet
    std::size_t         extreme   = 0;  // sample of the running peak or trough
    std::size_t         opposite  = 0;  // the same in the other direction, at the beginning
    double              swing     = 0;  // last distance from peak to trough [m]
    double              start     = -1; // of the running cycle [s], negative for none
    double              amplitude = 0;  // of the running cycle [m]
  };
} // namespace caudal

#endif
