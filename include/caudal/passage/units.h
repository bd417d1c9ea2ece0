// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_units_h
#define caudal_passage_units_h

#include <deal.II/base/patterns.h>

#include <map>
#include <string>

namespace caudal::passage
{
  /** The units in which a quantity may be given, with their factors to SI. */
  using Units = std::map<std::string, double>;

  extern const Units length_units, speed_units, discharge_units, time_units, power_units;

  /** A pattern that allows the names of these units. */
  dealii::Patterns::Selection get_unit_pattern(const Units &units);
} // namespace caudal::passage

#endif
