#include <caudal/potential/profile.h>

#include <algorithm>

namespace caudal::potential
{
  namespace
  {
    std::vector<double> compute_slopes(const std::vector<double> &x, const std::vector<double> &y)
    {
      std::vector<double> slopes(x.size(), 0.);
      for (std::size_t i = 1; i + 1 < x.size(); ++i)
      {
        const double left  = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
        const double right = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
        if (left * right > 0.)
          slopes[i] = 2. * left * right / (left + right);
      }
      return slopes;
    }
  } // namespace

  MonotoneInterpolant::MonotoneInterpolant(std::vector<double> x, std::vector<double> y)
      : first(x.front())
      , last(x.back())
      , hermite(std::vector<double>(x), std::vector<double>(y), compute_slopes(x, y),
                std::vector<double>(x.size(), 0.))
  {}

  double MonotoneInterpolant::value(const double x) const
  {
    return hermite(std::clamp(x, first, last));
  }
} // namespace caudal::potential
