// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_tests_round_off_h
#define caudal_tests_round_off_h

#include <cmath>
#include <sstream>
#include <string>

namespace caudal
{
  /** What is zero but for round-off, as a whole number of units: "0 x 1e-13". */
  inline std::string in_units(const double unit, const double value)
  {
    std::ostringstream text;
    text << std::lround(std::abs(value) / unit) << " x " << unit;
    return text.str();
  }
} // namespace caudal

#endif
