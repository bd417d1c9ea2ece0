// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_power_curve_h
#define caudal_passage_power_curve_h

#include <caudal/base/plugin.h>

#include <functional>
#include <vector>

namespace caudal::passage
{
  /** What a fish spends. */
  struct Power
  {
    std::function<double(double)> at_speed;         // [W] at a speed [m/s]; none: it is not known
    double                        moving_mass = 0.; // fish and added mass [kg], or 0
  };

  /** The power that swimming at a speed takes, for the energy that is spent on the way. */
  class PowerCurve : public Plugin
  {
  public:
    /** Power of a fish of this length [m]. */
    virtual Power make_power(double /*length*/) const
    {
      return {};
    }

    /** What this energy is and what it is not, for reports; empty: there is none. */
    virtual std::string describe() const
    {
      return "";
    }
  };

  /** A power at a speed. */
  struct PowerPoint
  {
    double speed; // [m/s]
    double power; // [W]
  };

  /**
   * The power law through neighbours of the points, which are sorted by speed; beyond them, and
   * of a single one, P ~ U^3, the power against a drag of constant coefficient.
   */
  std::function<double(double)> interpolate_power(std::vector<PowerPoint> points);
} // namespace caudal::passage

#endif
