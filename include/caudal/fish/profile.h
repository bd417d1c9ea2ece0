// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_profile_h
#define caudal_fish_profile_h

#include <boost/math/interpolators/quintic_hermite.hpp>

#include <vector>

namespace caudal
{
  /**
   * A smooth curve through the points (x_i, y_i), x_i increasing: twice continuously
   * differentiable and, if it is limited, monotone between two points, so that it never
   * overshoots.
   *
   * Quintic Hermite interpolation with the first and second derivatives of the natural cubic
   * spline, which is that spline itself. Limited, where it is not monotone, the derivatives at
   * the points beside are limited, as in R. L. Dougherty, A. Edelman and J. M. Hyman, Math.
   * Comput. 52, 1989: the second one to zero, the first one to twice the smaller slope of the
   * secants, and to zero at an extremum. With both ends limited an interval is monotone: in
   * units of the secant's slope, p' = 2 - 30 t^2 (1 - t)^2 > 0 for two end slopes of 2, and
   * p' >= 0 for (2, 0), (0, 2) and (0, 0), of which all others are mixtures. Linear beyond
   * the ends, where the second derivative is zero.
   */
  class Profile
  {
  public:
    Profile(const std::vector<double> &x, const std::vector<double> &y, bool limited);

    double value(double x) const;

  private:
    using Hermite = boost::math::interpolators::quintic_hermite<std::vector<double>>;

    const double  first, last;
    const Hermite hermite;
  };
} // namespace caudal

#endif
