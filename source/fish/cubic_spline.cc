// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/cubic_spline.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  using namespace dealii;

  std::vector<double> compute_spline_slopes(const std::vector<double> &x,
                                            const std::vector<double> &y, const bool periodic)
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

  CubicSpline::CubicSpline(const std::vector<double> &x, const std::vector<double> &y,
                           const bool periodic)
      : first(x.front())
      , last(x.back())
      , periodic(periodic)
      , hermite(std::vector<double>(x), std::vector<double>(y),
                compute_spline_slopes(x, y, periodic))
  {}

  std::pair<double, double> CubicSpline::evaluate(double x) const
  {
    if (periodic)
      x -= (last - first) * std::floor((x - first) / (last - first));
    x = std::clamp(x, first, last);
    return {hermite(x), hermite.prime(x)};
  }
} // namespace caudal
