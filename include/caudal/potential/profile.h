#ifndef caudal_potential_profile_h
#define caudal_potential_profile_h

#include <boost/math/interpolators/quintic_hermite.hpp>

#include <vector>

namespace caudal::potential
{
  /**
   * A smooth curve through the points (x_i, y_i), x_i increasing: twice continuously
   * differentiable, and monotone between two points, so that it never overshoots.
   *
   * Quintic Hermite interpolation. The slope in a point is the harmonic mean of those of
   * the secants beside it, zero at extrema and at both ends (F. N. Fritsch and J. Butland,
   * SIAM J. Sci. Stat. Comput. 5, 1984, doi:10.1137/0905021); the second derivative is
   * zero. With slopes up to twice that of the secant, p' >= 0: in units of the secant's
   * slope p' = 2 - 30 t^2 (1 - t)^2 > 0 for two slopes of 2, and p' is linear in them.
   * Constant beyond the ends, which keeps the second derivative continuous.
   */
  class MonotoneInterpolant
  {
  public:
    MonotoneInterpolant(std::vector<double> x, std::vector<double> y);

    double value(double x) const;

  private:
    const double first, last;

    const boost::math::interpolators::quintic_hermite<std::vector<double>> hermite;
  };
} // namespace caudal::potential

#endif
