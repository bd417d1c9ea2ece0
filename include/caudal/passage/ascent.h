// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_ascent_h
#define caudal_passage_ascent_h

#include <caudal/passage/endurance_curve.h>
#include <caudal/passage/waterway.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace caudal::passage
{
  /** Why a fish does not get on. */
  enum class Cause
  {
    none,       ///< it passes
    velocity,   ///< the water is as fast as it or faster
    exhaustion, ///< it is tired (at its prolonged speed, if it has two)
    burst,      ///< it is tired of swimming at its burst speed
    depth,      ///< the water is too shallow
    leap,       ///< the drop is higher than it can leap
    drop        ///< the drop is higher than is allowed
  };

  /** The cause as a word or two. */
  std::string describe(Cause cause);

  /** What the fish can't do without, whatever its endurance. */
  struct Needs
  {
    double depth        = 0.; // [m]
    double largest_drop = 0.; // [m]; 0: any that it can leap
    double leap_speed   = 0.; // [m/s]; 0: the fastest of its endurance curve
  };

  /** What a fish does in water of some velocity: its effort, and which store of strength it uses.
   */
  struct Action
  {
    Effort       effort;
    unsigned int store = 0; // 0, or 1 for burst
  };

  /** What it does in water of this velocity [m/s]; nothing if it can't get on. */
  using Behaviour = std::function<std::optional<Action>(double velocity)>;

  /** The fish at a place of its way. */
  struct AscentPoint
  {
    WaterPoint water;
    double     time;    // since it entered [s]
    double     speed;   // through the water [m/s]
    double     fatigue; // [1]: 1 is exhausted
    double     energy;  // that it has spent [J]; 0 if no power is known
  };

  /** How a fish fares. */
  struct Ascent
  {
    Cause  cause = Cause::none;
    double place = 0.; // where it fails, or else the place that tires it most [m]

    /** The largest fatigue before any rest: of the whole way, or up to where it can't get on. */
    double fatigue = 0.;

    double time   = 0.; // [s] of the whole way, or up to where it can't get on
    double energy = 0.; // [J], likewise

    /** Up to where there is a way, be the fish tired or not [m]. */
    double reach = 0.;

    /** The water's velocity at that place [m/s]. */
    double velocity = 0.;

    /** The shortest and longest endurance [s] of the efforts on the way. */
    double shortest_endurance = std::numeric_limits<double>::infinity(), longest_endurance = 0.;

    /** The longest time that it swims without a rest [s]. */
    double longest_effort = 0.;

    std::vector<AscentPoint> points; // its way

    bool passes() const
    {
      return cause == Cause::none;
    }
  };

  /** What else to compute than whether it passes, and its fatigue. */
  struct AscentOptions
  {
    bool                          is_detailed = false; ///< places, times, energies and points
    std::function<double(double)> power;               ///< [W] at a speed [m/s]; none: not known
    double                        moving_mass = 0.;    ///< that is accelerated with the fish [kg]
  };

  /**
   * A fish of this endurance and behaviour swims up the waterway. Fatigue accumulates linearly,
   *   dD = ds/((U - V) T(U)),
   * rests reduce it, and it passes if D stays below 1 (as Miner's rule of fatigue; Castro-Santos
   * 2006, Trans. Am. Fish. Soc. 135, 1230-1237, for fish at several speeds). With best speeds
   * everywhere D = int ds/X(V(s)). In a slot the water has the velocity sqrt(2 g h) of the drop h;
   * a leap asks for that speed.
   */
  Ascent compute_ascent(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
                        const Behaviour &behaviour, const AscentOptions &options = {});
} // namespace caudal::passage

#endif
