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
    using Expression<2>::Expression;
    using Expression<2>::value;

    double value(const double first, const double second) const
    {
      return value(Point<2>(first, second));
    }

    /** Derivative by the second variable, the time, by a central difference. */
    double rate(const double first, const double time) const
    {
      const double increment = 1e-6;
      return (value(first, time + increment) - value(first, time - increment)) / (2. * increment);
    }

    /** Throws unless it is finite at some places along the body. */
    void check_along() const
    {
      for (const double s : {0., 0.25, 0.5, 0.75, 1.})
        value(s, 0.);
    }
  };
} // namespace caudal

#endif
