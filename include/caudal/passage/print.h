// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_print_h
#define caudal_passage_print_h

#include <caudal/base/print.h>

#include <cmath>

namespace caudal::passage
{
  /** A number as sentences for engineers say it: three digits, and no powers of ten below 1e7. */
  inline std::string print_number(const double value)
  {
    return std::abs(value) >= 1000. && std::abs(value) < 1e7 ? std::to_string(std::lround(value))
                                                             : print_rounded(value);
  }
} // namespace caudal::passage

#endif
