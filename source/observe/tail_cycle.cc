// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/tail_cycle.h>

#include <algorithm>

namespace caudal
{
  TailCycleDetector::TailCycleDetector(const double smallest_amplitude)
      : smallest_swing(2 * smallest_amplitude)
  {}

  std::optional<TailCycle> TailCycleDetector::add(const double time, const double position)
  {
    times.push_back(time);
    positions.push_back(position);
    const std::size_t i         = positions.size() - 1;
    const double      threshold = std::max(smallest_swing, 0.2 * swing);

    if (direction == 0)
    {
      if (position > positions[extreme])
        extreme = i;
      if (position < positions[opposite])
        opposite = i;
      if (positions[extreme] - positions[opposite] > threshold)
      {
        direction = extreme > opposite ? 1 : -1;
        if (direction < 0)
          std::swap(extreme, opposite);
      }
    }
    else if (direction * (position - positions[extreme]) > 0)
      extreme = i;
    else if (direction * (positions[extreme] - position) > threshold)
    {
      if (direction > 0)
        return accept_peak();
      accept_trough();
    }
    return {};
  }

  std::optional<TailCycle> TailCycleDetector::accept_peak()
  {
    // Only a rise that starts from an accepted trough gives a crossing: the
    // position at rest is none.
    std::optional<TailCycle> cycle;
    if (swing > 0)
    {
      const double crossing = get_up_crossing();
      if (start >= 0)
        cycle = TailCycle{start, crossing, amplitude};
      start = crossing;
    }
    swing     = positions[extreme] - *std::min_element(positions.begin(), positions.end());
    opposite  = extreme;
    extreme   = positions.size() - 1;
    direction = -1;
    return cycle;
  }

  void TailCycleDetector::accept_trough()
  {
    swing     = positions[opposite] - positions[extreme];
    amplitude = swing / 2;
    times.erase(times.begin(), times.begin() + extreme);
    positions.erase(positions.begin(), positions.begin() + extreme);
    extreme   = positions.size() - 1;
    opposite  = 0;
    direction = 1;
  }

  double TailCycleDetector::get_up_crossing() const
  {
    const double mean = (positions.front() + positions[extreme]) / 2;
    std::size_t  i    = extreme;
    while (positions[i - 1] >= mean)
      --i;
    const double weight = (mean - positions[i - 1]) / (positions[i] - positions[i - 1]);
    return times[i - 1] + weight * (times[i] - times[i - 1]);
  }
} // namespace caudal
