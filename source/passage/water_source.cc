// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/water_source.h>

namespace caudal::passage
{
  void check_water(const std::string &place, const WaterPoint &point)
  {
    // No culvert or fishway has faster or deeper water: such numbers are in other units.
    const double largest_velocity = 15., largest_depth = 50.;
    check_not_negative(place + "velocity [m/s]", point.velocity,
                       "Give it positive against the fish, and 0 for water that rests.");
    check_value(point.velocity <= largest_velocity, place + "velocity [m/s]", point.velocity,
                "No water is that fast: is it in cm/s, or in another unit? Give `Unit of "
                "velocity`.");
    check_not_negative(place + "depth [m]", point.depth, "Give a depth of 0 or more.");
    check_value(point.depth <= largest_depth, place + "depth [m]", point.depth,
                "No fishway is that deep: is it in cm or mm? Give `Unit of depth`.");
  }
} // namespace caudal::passage
