// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_least_squares_h
#define caudal_fish_least_squares_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/householder.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace caudal
{
  /** The c_j, j < @p n, with which sum_j c_j basis(x, j) is closest to the @p values at the places
   * x.
   */
  template <class Basis>
  dealii::Vector<double> fit_least_squares(const std::vector<double> &x,
                                           const std::vector<double> &values, const unsigned int n,
                                           const Basis &basis)
  {
    dealii::FullMatrix<double> matrix(x.size(), n);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (unsigned int j = 0; j < n; ++j)
        matrix(i, j) = basis(x[i], j);
    dealii::Vector<double> coefficients(n);
    dealii::Householder<double>(matrix).least_squares(
        coefficients, dealii::Vector<double>(values.begin(), values.end()));
    return coefficients;
  }
} // namespace caudal

#endif
