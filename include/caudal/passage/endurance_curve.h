// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_endurance_curve_h
#define caudal_passage_endurance_curve_h

#include <limits>
#include <optional>
#include <vector>

namespace caudal::passage
{
  /** Acceleration of gravity [m/s^2] of all formulas here. */
  constexpr double gravity = 9.81;

  /**
   * One mode of swimming of one fish: for how long it holds the speed U [m/s],
   *   ln T = intercept + slope f(U),   f(U) = ln U, or U itself if it is exponential,
   * between the speeds lowest and highest. A power law U ~ t^b has the slope 1/b.
   */
  struct EnduranceBranch
  {
    double intercept, slope;
    bool   is_exponential = false;
    double lowest         = 0.;
    double highest        = std::numeric_limits<double>::infinity();

    /** T(U) [s] */
    double compute_endurance(double speed) const;

    /** The speed [m/s] that it can hold for @p duration [s]. */
    double compute_speed(double duration) const;

    /**
     * The speed between @p slowest and `highest` that maximises the distance (U - V) T(U) over
     * ground in water of velocity V: V/(1 + b) of a power law, V - 1/slope of an exponential one
     * (Castro-Santos 2005, doi:10.1242/jeb.01380). Nothing if it can't get on against V.
     */
    std::optional<double> compute_best_speed(double velocity, double slowest) const;
  };

  /** A speed and for how long it can be held. */
  struct Effort
  {
    double speed;     // through the water [m/s]
    double endurance; // [s]
  };

  /**
   * The endurance T(U) of one fish: that of the mode that holds out the longest. The data of a law
   * reach from the shortest to the longest duration. In faster water than that of the shortest one
   * there is no way; no fish chooses to be slower than the speed of the longest one.
   */
  class EnduranceCurve
  {
  public:
    /** Durations in s. */
    EnduranceCurve(std::vector<EnduranceBranch> branches, double shortest_duration,
                   double longest_duration);

    /** T(U) [s], extrapolated beyond the durations; 0 at speeds that no mode reaches. */
    double compute_endurance(double speed) const;

    /** The largest speed [m/s] that it can hold for @p duration [s]. */
    double compute_speed(double duration) const;

    /** The effort that takes it furthest over ground in water of @p velocity [m/s]. */
    std::optional<Effort> compute_best_effort(double velocity) const;

    /** X(V) = max (U - V) T(U) [m], how far it gets in water of @p velocity [m/s]; 0: nowhere. */
    double compute_distance(double velocity) const;

    /** The speed that it can hold for the shortest duration [m/s]. */
    double get_fastest() const
    {
      return fastest;
    }

    double get_shortest_duration() const
    {
      return shortest_duration;
    }

    double get_longest_duration() const
    {
      return longest_duration;
    }

  private:
    std::vector<EnduranceBranch> branches;
    double                       shortest_duration, longest_duration;
    double                       fastest, slowest;
  };
} // namespace caudal::passage

#endif
