// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_print_h
#define caudal_base_print_h

#include <deal.II/base/point.h>

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

  /** A place as sentences say it: "0.2, 0.5". */
  template <int dim>
  std::string print_place(const dealii::Point<dim> &place)
  {
    std::string text;
    for (unsigned int d = 0; d < dim; ++d)
      text += (d > 0 ? ", " : "") + print_rounded(place[d]);
    return text;
  }
} // namespace caudal

#endif
