// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_cubic_spline_h
#define caudal_fish_cubic_spline_h

#include <boost/math/interpolators/cubic_hermite.hpp>

#include <utility>
#include <vector>

namespace caudal
{
  /**
   * The derivatives in the points (x_i, y_i), x_i increasing, of the twice continuously
   * differentiable curve through them that is a cubic polynomial between two: periodic (then the
   * last point repeats the first one's y), or with second derivatives that vanish at both ends.
   */
  std::vector<double> compute_spline_slopes(const std::vector<double> &x,
                                            const std::vector<double> &y, bool periodic);

  /** The curve through the points with these slopes. */
  class CubicSpline
  {
  public:
    CubicSpline(const std::vector<double> &x, const std::vector<double> &y, bool periodic);

    /** Value and first derivative; x is continued periodically, or held within the ends. */
    std::pair<double, double> evaluate(double x) const;

  private:
    const double                                                         first, last;
    const bool                                                           periodic;
    const boost::math::interpolators::cubic_hermite<std::vector<double>> hermite;
  };
} // namespace caudal

#endif
