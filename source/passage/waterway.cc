// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/waterway.h>

#include <algorithm>

namespace caudal::passage
{
  double Waterway::compute_largest_velocity() const
  {
    return std::max_element(
               points.begin(), points.end(),
               [](const WaterPoint &a, const WaterPoint &b) { return a.velocity < b.velocity; })
        ->velocity;
  }

  Waterway Waterway::scale_velocities(const double factor) const
  {
    Waterway scaled = *this;
    for (WaterPoint &point : scaled.points)
      point.velocity *= factor;
    return scaled;
  }

  Waterway Waterway::add_rests(const double spacing) const
  {
    Waterway  result = *this;
    const int n      = static_cast<int>(get_length() / spacing * (1. - 1e-12));
    for (int k = 1; k <= n; ++k)
      result.rests.push_back({k * spacing, 1.});
    std::stable_sort(result.rests.begin(), result.rests.end(),
                     [](const Rest &a, const Rest &b) { return a.distance < b.distance; });
    return result;
  }
} // namespace caudal::passage
