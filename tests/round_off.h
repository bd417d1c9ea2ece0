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

  /** A figure that does not depend on the machine, with two decimals. */
  inline double with_two_decimals(const double value)
  {
    return std::lround(100 * value) / 100.;
  }

  /** The same of a small one, as a multiple of a unit: "3.14 x 1e-05". */
  inline std::string as_multiple(const double unit, const double value)
  {
    std::ostringstream text;
    text << with_two_decimals(value / unit) << " x " << unit;
    return text.str();
  }
} // namespace caudal

#endif
