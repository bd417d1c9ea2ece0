// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_print_h
#define caudal_base_print_h

#include <iomanip>
#include <sstream>
#include <string>

namespace caudal
{
  /** A number as sentences say it, with three digits. */
  inline std::string print_rounded(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
  }
} // namespace caudal

#endif
