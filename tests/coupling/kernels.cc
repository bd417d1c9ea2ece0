// SPDX-License-Identifier: LGPL-2.1-or-later
// Which moment conditions each kernel has on a lattice of spacing 1, for any
// position r: the zeroth and first one, the even-odd condition of Peskin (2002)
// (both halves of a chequered lattice weigh 1/2) and the sum of squares.
// Weights along a line: they are those of a convolution, so that interpolation
// and differentiation commute, which is what makes it preserve volume.

#include <caudal/coupling/kernel.h>
#include <caudal/coupling/line_weights.h>

#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>

#include "../round_off.h"

using namespace caudal;

// The largest deviation of sum_j term(r - j) from its value at r = 0
double deviation(const std::function<double(double, int)> &term, double &at_zero)
{
  const auto sum = [&](const double r) {
    double s = 0.;
    for (int j = -8; j <= 8; ++j)
      s += term(r - j, j);
    return s;
  };
  at_zero      = sum(0.);
  double worst = 0.;
  for (unsigned int i = 0; i <= 1000; ++i)
    worst = std::max(worst, std::abs(sum(i * 1e-3) - at_zero));
  return worst;
}

void check(const std::string &name, const DeltaKernel &kernel)
{
  const auto phi = [&](const double r) { return kernel.value(r); };
  double     zeroth, first, even, squares;
  const bool has_zeroth = deviation([&](double r, int) { return phi(r); }, zeroth) < 1e-12;
  const bool has_first  = deviation([&](double r, int) { return r * phi(r); }, first) < 1e-12;
  const bool has_even =
      deviation([&](double r, int j) { return j % 2 == 0 ? phi(r) : 0.; }, even) < 1e-12;
  const bool has_squares =
      deviation([&](double r, int) { return phi(r) * phi(r); }, squares) < 1e-12;

  double integral = 0., jump = 0., asymmetry = 0., smallest = 0.;
  for (int i = -4000; i < 4000; ++i)
  {
    const double r = (i + 0.5) * 1e-3;
    integral += 1e-3 * phi(r);
    jump      = std::max(jump, std::abs(phi(r + 5e-4 + 1e-9) - phi(r + 5e-4 - 1e-9)));
    asymmetry = std::max(asymmetry, std::abs(phi(r) - phi(-r)));
    smallest  = std::min(smallest, phi(r));
  }
  const double outside = std::abs(phi(kernel.radius)) + std::abs(phi(kernel.radius + 0.3));

  const auto yes = [](const bool condition) { return condition ? "  yes" : "   no"; };
  std::cout << std::left << std::setw(30) << name << std::right << std::setw(5) << kernel.radius
            << yes(has_zeroth && std::abs(zeroth - 1.) < 1e-12)
            << yes(has_first && std::abs(first) < 1e-12)
            << yes(has_even && std::abs(even - 0.5) < 1e-12) << yes(has_squares) << std::setw(9)
            << std::setprecision(4) << squares << yes(std::abs(integral - 1.) < 1e-5)
            << yes(jump < 1e-3 && asymmetry < 1e-14 && outside == 0. && smallest == 0.)
            << std::setw(9) << phi(0.) << std::endl;
}

// A continuous, piecewise quadratic function: its value at node @p n (two to a cell),
// and its slope at node @p i of the three of @p cell.
double value(const int n)
{
  return std::sin(0.7 * n) + 0.3 * std::cos(2.1 * n);
}

double slope(const int cell, const unsigned int i)
{
  const double a = value(2 * cell), b = value(2 * cell + 1), c = value(2 * cell + 2);
  return std::array<double, 3>{{-3 * a + 4 * b - c, c - a, a - 4 * b + 3 * c}}[i];
}

void check_convolution(const std::string &name, const DeltaKernel &kernel)
{
  const LineTable table(kernel);
  double          table_error = 0.;
  const auto      interpolate = [&](const double x, const auto &function) {
    const LineWeights weights = table.evaluate(x), exact = integrate_line_weights(x, kernel);
    for (unsigned int c = 0; c < weights.cells.size(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        table_error = std::max(table_error, std::abs(weights.cells[c][i] - exact.cells[c][i]));
    double sum = 0.;
    for (unsigned int c = 0; c < weights.cells.size(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        sum += weights.cells[c][i] * function(weights.first_cell + static_cast<int>(c), i);
    return sum;
  };
  const auto values = [](const int cell, const unsigned int i) { return value(2 * cell + i); };
  double     worst = 0., linear = 0.;
  for (double x = -2.; x < 2.; x += 0.0137)
  {
    const double step = 1e-4;
    const double differences =
        (interpolate(x + step, values) - interpolate(x - step, values)) / (2. * step);
    worst  = std::max(worst, std::abs(differences - interpolate(x, slope)));
    linear = std::max(linear,
                      std::abs(interpolate(x, [](const int          cell,
                                                 const unsigned int i) { return cell + 0.5 * i; }) -
                               x));
  }
  std::cout << std::left << std::setw(30) << name << std::right
            << (worst < 1e-4 ? "  yes" : "   no") << (linear < 1e-11 ? "  yes" : "   no")
            << (table_error < 1e-11 ? "  yes" : "   no") << std::endl;
}

int main()
{
  std::cout << "kernel, radius, zeroth moment, first moment, even-odd, constant sum of squares "
               "(its value at 0), integral 1, even and continuous and not negative, value at 0"
            << std::endl;
  for (const auto &[name, member] : Registry<DeltaKernel>::get_members())
  {
    const auto kernel = member.create();
    if (kernel->radius == 0.)
      std::cout << name << ": radius " << kernel->radius << std::endl;
    else if (kernel->is_isotropic())
      check(name, *kernel);
    else
    {
      check(name + ", along", *kernel);
      check(name + ", across", kernel->across());

      // The identity behind the divergence-free interpolation
      double worst = 0.;
      for (double r = -3.; r < 3.; r += 0.0137)
      {
        const double slope  = (kernel->value(r + 1e-5) - kernel->value(r - 1e-5)) / 2e-5;
        const double across = kernel->across().value(r + 0.5) - kernel->across().value(r - 0.5);
        worst               = std::max(worst, std::abs(slope - across));
      }
      std::cout << "  slope along less the difference across: " << in_units(1e-9, worst)
                << std::endl;
    }
  }

  std::cout << "convolution: commutes with differentiation, reproduces linear functions, the table "
               "equals "
               "the integrals"
            << std::endl;
  for (const auto &[name, member] : Registry<DeltaKernel>::get_members())
    if (const auto kernel = member.create(); kernel->is_isotropic() && kernel->radius > 0.)
      check_convolution(name, *kernel);
}
