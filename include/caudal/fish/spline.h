// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_spline_h
#define caudal_fish_spline_h

#include <boost/math/interpolators/quintic_hermite.hpp>

#include <utility>
#include <vector>

namespace caudal
{
  /**
   * The twice continuously differentiable curve through the points (x_i, y_i), x_i increasing, that
   * is a cubic polynomial between two, as the quintic Hermite interpolation with its first and
   * second derivatives.
   *
   * If it is limited, it is monotone between two points, so that it never overshoots: where it is
   * not, the derivatives at the points beside are limited, as in R. L. Dougherty, A. Edelman and
   * J. M. Hyman, Math. Comput. 52, 1989: the second one to zero, the first one to twice the smaller
   * slope of the secants, and to zero at an extremum. With both ends limited an interval is
   * monotone: in units of the secant's slope, p' = 2 - 30 t^2 (1 - t)^2 > 0 for two end slopes of
   * 2, and p' >= 0 for (2, 0), (0, 2) and (0, 0), of which all others are mixtures.
   */
  class Spline
  {
  public:
    enum class Kind
    {
      natural, ///< second derivatives vanish at both ends, beyond which it is linear
      limited, ///< likewise, without overshoots
      periodic ///< the last point repeats the first one's y
    };

    Spline(const std::vector<double> &x, const std::vector<double> &y, Kind kind);

    /** Value and first derivative. */
    std::pair<double, double> evaluate(double x) const;

  private:
    const double first, last;
    const bool   periodic;

    const boost::math::interpolators::quintic_hermite<std::vector<double>> hermite;
  };
} // namespace caudal

#endif
