#ifndef caudal_ideal_cubic_spline_h
#define caudal_ideal_cubic_spline_h

#include <utility>
#include <vector>

namespace caudal::ideal
{
  /**
   * The twice continuously differentiable curve through the points (x_i, y_i), x_i increasing,
   * that is a cubic polynomial between them: periodic (then the last point repeats the first
   * one's y), or with second derivatives that vanish at both ends.
   */
  class CubicSpline
  {
  public:
    CubicSpline(std::vector<double> x, std::vector<double> y, bool periodic);

    /** Value and first derivative; x is continued periodically, or held within the ends. */
    std::pair<double, double> evaluate(double x) const;

  private:
    const std::vector<double> x, y;
    const bool                periodic;
    std::vector<double>       second; // derivatives in the points
  };
} // namespace caudal::ideal

#endif
