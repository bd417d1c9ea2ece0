// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_ramp_h
#define caudal_fish_ramp_h

#include <deal.II/base/numbers.h>

#include <cmath>

namespace caudal
{
  /** The smooth start (1 - cos(pi t/T))/2 of a motion from rest at t = 0, and its rate. */
  struct StartUpRamp
  {
    /** T [s]; 0 starts at once. */
    double duration = 0.;

    double value(const double time) const
    {
      if (time >= duration)
        return 1.;
      return time > 0. ? 0.5 * (1. - std::cos(dealii::numbers::PI * time / duration)) : 0.;
    }

    /** [1/s] */
    double rate(const double time) const
    {
      if (time >= duration || time <= 0.)
        return 0.;
      const double omega = dealii::numbers::PI / duration;
      return 0.5 * omega * std::sin(omega * time);
    }
  };
} // namespace caudal

#endif
