// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/line_weights.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    // The quadratic Lagrange polynomials of the nodes 0, 1/2, 1.
    std::array<double, 3> evaluate_quadratics(const double x)
    {
      return {{(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)}};
    }
  } // namespace

  LineWeights integrate_line_weights(const double x, const DeltaKernel &kernel)
  {
    const QGauss<1> quadrature(kernel.n_quadrature_points);
    const double    radius    = 0.5 * kernel.radius; // in cells
    const int       last_cell = std::floor(x + radius);
    LineWeights     weights;
    weights.first_cell = std::floor(x - radius);
    weights.cells.resize(last_cell - weights.first_cell + 1);

    // Between the knots, half a cell apart, and sides of cells the integrand is smooth.
    std::vector<double> breaks;
    for (unsigned int k = 0; k <= std::lround(2 * kernel.radius); ++k)
      breaks.push_back(x - radius + 0.5 * k);
    for (int side = weights.first_cell + 1; side <= last_cell; ++side)
      breaks.push_back(side);
    std::sort(breaks.begin(), breaks.end());
    for (unsigned int b = 0; b + 1 < breaks.size(); ++b)
    {
      const double length = breaks[b + 1] - breaks[b];
      const int    cell   = std::clamp<int>(std::floor(0.5 * (breaks[b] + breaks[b + 1])),
                                       weights.first_cell, last_cell);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double xi = breaks[b] + length * quadrature.point(q)[0];
        // d(xi) over the lattice spacing of half a cell
        const double weight = 2 * length * quadrature.weight(q) * kernel.value(2 * (xi - x));
        const auto   shape  = evaluate_quadratics(xi - cell);
        for (unsigned int i = 0; i < 3; ++i)
          weights.cells[cell - weights.first_cell][i] += weight * shape[i];
      }
    }
    return weights;
  }

  LineTable::LineTable(const DeltaKernel &kernel)
  {
    for (unsigned int j = 0; j < n_nodes; ++j)
    {
      const double angle = (2 * j + 1) * numbers::PI / (2 * n_nodes);
      nodes[j]           = 0.5 * (1 + std::cos(angle));
      node_weights[j]    = (j % 2 == 0 ? 1 : -1) * std::sin(angle);
    }
    if (kernel.radius > 0)
      for (unsigned int quarter = 0; quarter < n_quarters; ++quarter)
        for (const double node : nodes)
          values[quarter].push_back(integrate_line_weights((quarter + node) / n_quarters, kernel));
  }

  LineWeights LineTable::evaluate(const double x) const
  {
    const double cell = std::floor(x);
    LineWeights  weights;
    if (values[0].empty())
    {
      weights.first_cell = cell;
      weights.cells.push_back(evaluate_quadratics(x - cell));
      return weights;
    }
    const double       place   = n_quarters * (x - cell);
    const unsigned int quarter = std::min<unsigned int>(place, n_quarters - 1);
    const auto        &table   = values[quarter];
    weights.first_cell         = cell + table[0].first_cell;
    weights.cells.resize(table[0].cells.size());
    double sum = 0;
    for (unsigned int j = 0; j < n_nodes; ++j)
    {
      const double distance = place - quarter - nodes[j];
      const double factor   = node_weights[j] / (distance == 0 ? 1e-300 : distance);
      sum += factor;
      for (unsigned int c = 0; c < weights.cells.size(); ++c)
        for (unsigned int i = 0; i < 3; ++i)
          weights.cells[c][i] += factor * table[j].cells[c][i];
    }
    for (auto &moments : weights.cells)
      for (double &moment : moments)
        moment /= sum;
    return weights;
  }
} // namespace caudal
