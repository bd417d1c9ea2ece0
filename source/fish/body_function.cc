// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/body_function.h>

namespace caudal
{
  BodyFunction::BodyFunction(const std::string &path, const std::string &variables,
                             const std::string &text)
      : Expression<2>(path, variables, text)
  {}

  double BodyFunction::value(const double first, const double second) const
  {
    return Expression<2>::value({first, second});
  }

  void BodyFunction::check_along() const
  {
    for (const double s : {0., 0.25, 0.5, 0.75, 1.})
      value(s, 0.);
  }
} // namespace caudal
