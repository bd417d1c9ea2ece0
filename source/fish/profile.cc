// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/cubic_spline.h>
#include <caudal/fish/profile.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** Values and derivatives in the points. */
    struct Data
    {
      std::vector<double> x, y, slopes, second;

      double get_secant(const std::size_t i) const
      {
        return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
      }

      boost::math::interpolators::quintic_hermite<std::vector<double>> make_hermite() const
      {
        return {std::vector<double>(x), std::vector<double>(y), std::vector<double>(slopes),
                std::vector<double>(second)};
      }

      /** First the slope, then the second derivative. */
      void limit(const std::size_t i, const unsigned int step)
      {
        if (step > 0)
        {
          second[i] = 0.;
          return;
        }
        const double left  = get_secant(i > 0 ? i - 1 : 0);
        const double right = get_secant(i + 1 < x.size() ? i : i - 1);
        const bool   turns = left * right <= 0. || left * slopes[i] <= 0.;
        const double most  = turns ? 0. : 2. * std::min(std::abs(left), std::abs(right));
        slopes[i]          = std::copysign(std::min(std::abs(slopes[i]), most), left);
      }

      bool is_monotone(const std::size_t i) const
      {
        const auto         hermite = make_hermite();
        const double       secant = get_secant(i), tolerance = 1e-12 * std::abs(secant);
        const unsigned int n_samples = 64;
        for (unsigned int k = 0; k <= n_samples; ++k)
        {
          const double t     = static_cast<double>(k) / n_samples;
          const double slope = hermite.prime((1. - t) * x[i] + t * x[i + 1]);
          if (secant == 0. ? slope != 0. : slope * secant < -tolerance * std::abs(secant))
            return false;
        }
        return true;
      }
    };

    Data make_data(const std::vector<double> &x, const std::vector<double> &y, const bool limited)
    {
      Data data{x, y, compute_spline_slopes(x, y, false), std::vector<double>(x.size(), 0.)};
      for (std::size_t i = 1; i + 1 < x.size(); ++i)
      {
        // From the slopes at the ends of the cubic piece to the right.
        const double h = x[i + 1] - x[i];
        data.second[i] =
            (6. * data.get_secant(i) - 4. * data.slopes[i] - 2. * data.slopes[i + 1]) / h;
      }

      // Limiting a point may spoil the interval beside it, but each is limited only twice.
      std::vector<unsigned int> n_limits(x.size(), 0);
      for (bool changed = limited; changed;)
      {
        changed = false;
        for (std::size_t i = 0; i + 1 < x.size(); ++i)
          if ((n_limits[i] < 2 || n_limits[i + 1] < 2) && !data.is_monotone(i))
          {
            const unsigned int step = std::min(n_limits[i], n_limits[i + 1]);
            for (const std::size_t end : {i, i + 1})
              if (n_limits[end] == step)
                data.limit(end, n_limits[end]++);
            changed = true;
          }
      }
      return data;
    }
  } // namespace

  Profile::Profile(const std::vector<double> &x, const std::vector<double> &y, const bool limited)
      : first(x.front())
      , last(x.back())
      , hermite(make_data(x, y, limited).make_hermite())
  {}

  double Profile::value(const double x) const
  {
    const double inside = std::clamp(x, first, last);
    return hermite(inside) + hermite.prime(inside) * (x - inside);
  }
} // namespace caudal
