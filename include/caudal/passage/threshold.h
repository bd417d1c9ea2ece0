// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_threshold_h
#define caudal_passage_threshold_h

#include <optional>

namespace caudal::passage
{
  /**
   * The smallest x of [@p low, @p high] from which on @p holds, by bisection to 2^-n_bits of the
   * range; nothing if it does not hold at the end.
   */
  template <class Condition>
  std::optional<double> find_threshold(const Condition &holds, double low, double high,
                                       const int n_bits = 40)
  {
    if (!holds(high))
      return std::nullopt;
    if (holds(low))
      return low;
    for (int k = 0; k < n_bits; ++k)
    {
      const double middle          = 0.5 * (low + high);
      (holds(middle) ? high : low) = middle;
    }
    return high;
  }
} // namespace caudal::passage

#endif
