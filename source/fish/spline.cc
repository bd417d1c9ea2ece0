// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/spline.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  using namespace dealii;

  namespace
  {
    /** The derivatives of the cubic spline in the points. */
    std::vector<double> compute_slopes(const std::vector<double> &x, const std::vector<double> &y,
                                       const bool periodic)
    {
      // The second derivative is continuous at each point i between h_left and h_right, or vanishes
      // at an end: with slopes p, and s of the secants,
      // p_(i-1)/h_left + 2 p_i (1/h_left + 1/h_right) + p_(i+1)/h_right
      //   = 3 (s_left/h_left + s_right/h_right).
      const unsigned int     n = x.size();
      DynamicSparsityPattern entries(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (const unsigned int j : {i > 0 ? i - 1 : n - 2, i, i + 1 < n ? i + 1 : 1})
          entries.add(i, j);
      SparsityPattern pattern;
      pattern.copy_from(entries);
      SparseMatrix<double> matrix(pattern);
      Vector<double>       slopes(n);
      const auto           add = [&](const unsigned int i, const unsigned int neighbour,
                           const unsigned int left) {
        const double h = x[left + 1] - x[left];
        matrix.add(i, i, 2. / h);
        matrix.add(i, neighbour, 1. / h);
        slopes[i] += 3. * (y[left + 1] - y[left]) / (h * h);
      };
      for (unsigned int i = 0; i < n; ++i)
      {
        if (i > 0)
          add(i, i - 1, i - 1);
        else if (periodic)
          add(i, n - 2, n - 2);
        if (i + 1 < n)
          add(i, i + 1, i);
        else if (periodic)
          add(i, 1, 0);
      }
      SparseDirectUMFPACK solver;
      solver.initialize(matrix);
      solver.solve(slopes);
      return {slopes.begin(), slopes.end()};
    }

    using Hermite = boost::math::interpolators::quintic_hermite<std::vector<double>>;

    /** Values and derivatives in the points. */
    struct Data
    {
      Data(const std::vector<double> &x, const std::vector<double> &y, const Spline::Kind kind)
          : x(x)
          , y(y)
          , slopes(compute_slopes(x, y, kind == Spline::Kind::periodic))
          , second(x.size(), 0.)
      {
        const bool periodic = kind == Spline::Kind::periodic;
        for (std::size_t i = periodic ? 0 : 1; i + 1 < x.size(); ++i)
        {
          // From the slopes at the ends of the cubic piece to the right.
          const double h = x[i + 1] - x[i];
          second[i]      = (6. * get_secant(i) - 4. * slopes[i] - 2. * slopes[i + 1]) / h;
        }
        if (periodic)
          second.back() = second.front();

        // Limiting a point may spoil the interval beside it, but each is limited only twice.
        std::vector<unsigned int> n_limits(x.size(), 0);
        for (bool changed = kind == Spline::Kind::limited; changed;)
        {
          changed = false;
          for (std::size_t i = 0; i + 1 < x.size(); ++i)
            if ((n_limits[i] < 2 || n_limits[i + 1] < 2) && !is_monotone(i))
            {
              const unsigned int step = std::min(n_limits[i], n_limits[i + 1]);
              for (const std::size_t end : {i, i + 1})
                if (n_limits[end] == step)
                  limit(end, n_limits[end]++);
              changed = true;
            }
        }
      }

      double get_secant(const std::size_t i) const
      {
        return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
      }

      Hermite make_hermite() const
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

      const std::vector<double> x, y;
      std::vector<double>       slopes, second;
    };
  } // namespace

  Spline::Spline(const std::vector<double> &x, const std::vector<double> &y, const Kind kind)
      : first(x.front())
      , last(x.back())
      , periodic(kind == Kind::periodic)
      , hermite(Data(x, y, kind).make_hermite())
  {}

  std::pair<double, double> Spline::evaluate(double x) const
  {
    if (periodic)
      x -= (last - first) * std::floor((x - first) / (last - first));
    const double inside = std::clamp(x, first, last), slope = hermite.prime(inside);
    return {hermite(inside) + slope * (x - inside), slope};
  }
} // namespace caudal
