// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/units.h>

namespace caudal::passage
{
  namespace
  {
    constexpr double foot = 0.3048; // [m]
  }

  const Units length_units{{"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"km", 1e3}, {"ft", foot}};
  const Units speed_units{
      {"m/s", 1.}, {"cm/s", 1e-2}, {"ft/s", foot}, {"fps", foot}, {"km/h", 1. / 3.6}};
  const Units discharge_units{{"m^3/s", 1.},
                              {"m3/s", 1.},
                              {"l/s", 1e-3},
                              {"ft^3/s", foot *foot *foot},
                              {"ft3/s", foot *foot *foot},
                              {"cfs", foot *foot *foot}};
  const Units time_units{{"s", 1.}, {"min", 60.}, {"h", 3600.}};
  const Units power_units{{"W", 1.}, {"mW", 1e-3}};

  dealii::Patterns::Selection get_unit_pattern(const Units &units)
  {
    std::string names;
    for (const auto &[name, factor] : units)
      names += (names.empty() ? "" : "|") + name;
    return dealii::Patterns::Selection(names);
  }
} // namespace caudal::passage
