// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_body_function_h
#define caudal_fish_body_function_h

#include <caudal/base/expression.h>

namespace caudal
{
  /** A function of two variables along a body, such as a distribution g(s,y). */
  class BodyFunction : public Expression<2>
  {
  public:
    /** @p variables are two names separated by ','; @p path is the entry that errors name. */
    BodyFunction(const std::string &path, const std::string &variables, const std::string &text);

    using Expression<2>::value;
    double value(double first, double second) const;

    /** Throws unless it is finite at some places along the body. */
    void check_along() const;
  };
} // namespace caudal

#endif
