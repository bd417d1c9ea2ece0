#include <caudal/coupling/line_weights.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace caudal
{
  namespace
  {
    // The quadratic Lagrange polynomials of the nodes 0, 1/2, 1.
    std::array<double, 3> evaluate_quadratics(const double x)
    {
      return {{(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)}};
    }

    const QGauss<1> &get_quadrature(const unsigned int n_points)
    {
      static std::map<unsigned int, QGauss<1>> quadratures;
      return quadratures.try_emplace(n_points, n_points).first->second;
    }
  } // namespace

  LineWeights::LineWeights(const double x, const DeltaKernel *kernel)
  {
    if (kernel == nullptr)
    {
      first_cell = std::floor(x);
      cells.push_back(evaluate_quadratics(x - first_cell));
      totals.push_back(1);
      return;
    }
    const QGauss<1> &quadrature = get_quadrature(kernel->n_quadrature_points());
    const double     radius     = 0.5 * kernel->radius(); // in cells
    first_cell                  = std::floor(x - radius);
    const int last_cell         = std::floor(x + radius);
    cells.resize(last_cell - first_cell + 1);
    totals.resize(cells.size());

    // Knots of the kernel, half a cell apart, and sides of cells: between two of
    // them the integrand is smooth.
    const unsigned int  n_intervals = std::lround(2 * kernel->radius());
    std::vector<double> breaks;
    for (unsigned int k = 0; k <= n_intervals; ++k)
      breaks.push_back(x - radius + 0.5 * k);
    for (int side = first_cell + 1; side <= last_cell; ++side)
      breaks.push_back(side);
    std::sort(breaks.begin(), breaks.end());
    for (unsigned int b = 0; b + 1 < breaks.size(); ++b)
    {
      const double       length = breaks[b + 1] - breaks[b];
      const double       middle = 0.5 * (breaks[b] + breaks[b + 1]);
      const unsigned int cell =
          std::clamp<int>(std::floor(middle), first_cell, last_cell) - first_cell;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double xi = breaks[b] + length * quadrature.point(q)[0];
        // d(xi) over the lattice spacing of half a cell
        const double weight = 2 * length * quadrature.weight(q) * kernel->value(2 * (xi - x));
        const auto   shape  = evaluate_quadratics(xi - first_cell - static_cast<int>(cell));
        totals[cell] += weight;
        for (unsigned int i = 0; i < 3; ++i)
          cells[cell][i] += weight * shape[i];
      }
    }
  }
} // namespace caudal
