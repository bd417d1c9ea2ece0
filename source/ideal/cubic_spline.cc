#include <caudal/ideal/cubic_spline.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace caudal::ideal
{
  using namespace dealii;

  CubicSpline::CubicSpline(std::vector<double> x_in, std::vector<double> y_in, const bool periodic)
      : x(std::move(x_in))
      , y(std::move(y_in))
      , periodic(periodic)
  {
    // The first derivative is continuous at each point i between h_left and h_right:
    // h_left/6 y''_(i-1) + (h_left + h_right)/3 y''_i + h_right/6 y''_(i+1) = change of slope.
    const unsigned int n     = x.size();
    const auto         h     = [this](const unsigned int i) { return x[i + 1] - x[i]; };
    const auto         slope = [&](const unsigned int i) { return (y[i + 1] - y[i]) / h(i); };

    LAPACKFullMatrix<double> matrix(n, n);
    Vector<double>           solution(n);
    for (unsigned int i = 0; i < n; ++i)
    {
      const bool is_end = i == 0 || i == n - 1;
      if (is_end && (!periodic || i > 0))
      {
        matrix(i, i) = 1.;
        if (periodic)
          matrix(i, 0) = -1.;
        continue;
      }
      const unsigned int left = is_end ? n - 2 : i - 1;
      matrix(i, left) += h(left) / 6.;
      matrix(i, i) += (h(left) + h(i)) / 3.;
      matrix(i, i + 1) += h(i) / 6.;
      solution(i) = slope(i) - slope(left);
    }
    matrix.compute_lu_factorization();
    matrix.solve(solution);
    second.assign(solution.begin(), solution.end());
  }

  std::pair<double, double> CubicSpline::evaluate(double at) const
  {
    const double period = x.back() - x.front();
    if (periodic)
      at -= period * std::floor((at - x.front()) / period);
    at             = std::clamp(at, x.front(), x.back());
    const auto   j = std::upper_bound(x.begin() + 1, x.end() - 1, at) - x.begin();
    const auto   i = j - 1;
    const double h = x[j] - x[i], a = (x[j] - at) / h, b = 1. - a;
    return {a * y[i] + b * y[j] +
                h * h / 6. * ((a * a * a - a) * second[i] + (b * b * b - b) * second[j]),
            (y[j] - y[i]) / h +
                h / 6. * ((3. * b * b - 1.) * second[j] - (3. * a * a - 1.) * second[i])};
  }
} // namespace caudal::ideal
