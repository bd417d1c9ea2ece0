// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_waterway_h
#define caudal_passage_waterway_h

#include <string>
#include <vector>

namespace caudal::passage
{
  /** The water at a place of the way. */
  struct WaterPoint
  {
    double distance; // from where the fish enters [m]
    double velocity; // against the fish, of the part of the section that it uses [m/s]
    double depth;    // [m]; 0 if it is not known
  };

  /** A step in the water's surface. */
  struct Drop
  {
    double distance; // [m]
    double height;   // [m]
    double length;   // of the jet in a slot that is swum through [m]; 0: it is leapt
  };

  /** A place where the fish rests. */
  struct Rest
  {
    double distance; // [m]
    double recovery; // share of the fatigue that it loses there [1]
  };

  /**
   * The way of the fish at one discharge: velocity and depth are linear between the points; two
   * points at one distance are a jump.
   */
  struct Waterway
  {
    double                  discharge = 0.; // [m^3/s]; 0 if it is not known
    std::vector<WaterPoint> points;
    std::vector<Drop>       drops; // in the order of their distances
    std::vector<Rest>       rests; // likewise
    bool                    has_depths = true;

    double get_length() const
    {
      return points.back().distance;
    }

    double compute_largest_velocity() const;

    /** This way with velocities times @p factor. */
    Waterway scale_velocities(double factor) const;

    /** This way with whole rests every @p spacing [m]. */
    Waterway add_rests(double spacing) const;
  };
} // namespace caudal::passage

#endif
