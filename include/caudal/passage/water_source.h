// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_water_source_h
#define caudal_passage_water_source_h

#include <caudal/base/plugin.h>
#include <caudal/passage/waterway.h>

#include <optional>

namespace caudal::passage
{
  /** Where velocities and depths along the way are from. */
  class WaterSource : public Plugin
  {
  public:
    /** The way at each discharge, without drops and rests; @p path is its section. */
    virtual std::vector<Waterway> make_waterways(const std::string &path) const = 0;

    /** Whether compute_at_slope() has an answer. */
    virtual bool has_slope() const
    {
      return false;
    }

    /** The way with another slope of the bed; nothing if it can't carry the discharge [m^3/s]. */
    virtual std::optional<Waterway> compute_at_slope(double /*slope*/, double /*discharge*/) const
    {
      return std::nullopt;
    }

    /** Data and method in words, for reports. */
    virtual std::string describe() const = 0;
  };

  /** Throws a sentence, which begins with @p place, if @p point can't be. */
  void check_water(const std::string &place, const WaterPoint &point);
} // namespace caudal::passage

#endif
