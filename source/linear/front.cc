// SPDX-License-Identifier: LGPL-2.1-or-later
#include "front.h"

#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /** Columns that are eliminated at once: few enough for the cache, many enough for BLAS. */
    constexpr int panel_width = 32;
    /** Columns of a panel's triangular solution at once; BLAS is slow at those. */
    constexpr int small_width = 8;

    /** A pivot is poor where the entries below it are larger by this factor. */

    constexpr double largest_growth = 1e6;
    /** c := beta c + alpha a b */
    void multiply(const double alpha, const Block &a, const Block &b, const double beta,
                  const Block &c)
    {
      if (c.n_rows == 0 || c.n_columns == 0)
        return;
      const types::blas_int m = c.n_rows, n = c.n_columns, k = a.n_columns;
      const types::blas_int stride_a = a.stride, stride_b = b.stride, stride_c = c.stride;
      gemm("N", "N", &m, &n, &k, &alpha, a.data, &stride_a, b.data, &stride_b, &beta, c.data,
           &stride_c);
    }

    /** LU of a panel without any BLAS, rows exchanged; returns false if a pivot is zero. */
    bool factorize_panel(const Block &panel, int *exchanges)
    {
      for (int c = 0; c < panel.n_columns; ++c)
      {
        double    *pivot_column = panel.column(c);
        const auto largest      = std::max_element(
                 pivot_column + c, pivot_column + panel.n_rows,
                 [](const double a, const double b) { return std::abs(a) < std::abs(b); });
        if (!(std::abs(*largest) > 0.))
          return false;
        exchanges[c] = largest - pivot_column;
        if (exchanges[c] != c)
          for (int j = 0; j < panel.n_columns; ++j)
            std::swap(panel.column(j)[c], panel.column(j)[exchanges[c]]);
        const double inverse = 1 / pivot_column[c];
#pragma omp simd
        for (int i = c + 1; i < panel.n_rows; ++i)
          pivot_column[i] *= inverse;
        for (int j = c + 1; j < panel.n_columns; ++j)
        {
          double      *column = panel.column(j);
          const double factor = column[c];
#pragma omp simd
          for (int i = c + 1; i < panel.n_rows; ++i)
            column[i] -= pivot_column[i] * factor;
        }
      }
      return true;
    }

    /** The inverse of the unit lower triangle of @p lower, whose entries are at most one. */
    void invert_unit_lower_triangle(const Block &lower, const Block &inverse)
    {
      const int n = lower.n_columns;
      for (int c = 0; c < n; ++c)
      {
        double *column = inverse.column(c);
        std::fill(column, column + n, 0.);
        column[c] = 1;
        for (int j = c; j < n; ++j)
        {
          const double *l      = lower.column(j);
          const double  factor = column[j];
#pragma omp simd
          for (int i = j + 1; i < n; ++i)
            column[i] -= factor * l[i];
        }
      }
    }

    /**
     * x := x U^-1, U the upper triangle of @p upper: by substitution, since the augmented matrix
     * makes its condition number 1e9, and an explicit inverse loses half of the digits.
     */
    void solve_from_right(const Block &upper, const Block &x)
    {
      for (int begin = 0; begin < upper.n_columns; begin += small_width)
      {
        const int end = std::min(begin + small_width, upper.n_columns);
        for (int j = begin; j < end; ++j)
        {
          double       *column = x.column(j);
          const double *u      = upper.column(j);
          for (int i = begin; i < j; ++i)
          {
            const double *other  = x.column(i);
            const double  factor = u[i];
#pragma omp simd
            for (int row = 0; row < x.n_rows; ++row)
              column[row] -= factor * other[row];
          }
          const double inverse = 1 / u[j];
#pragma omp simd
          for (int row = 0; row < x.n_rows; ++row)
            column[row] *= inverse;
        }
        const int n_left = upper.n_columns - end;
        multiply(-1, x.part(0, begin, x.n_rows, end - begin),
                 upper.part(begin, end, end - begin, n_left), 1, x.part(0, end, x.n_rows, n_left));
      }
    }

    void exchange_rows(const Block &block, const int first, const int second)
    {
      for (int j = 0; j < block.n_columns; ++j)
        std::swap(block.column(j)[first], block.column(j)[second]);
    }

    /** right := L^-1 right for a panel's rows, L its unit lower triangle. */
    void solve_from_left(const Block &inverse, const Block &right, std::vector<double> &buffer)
    {
      buffer.resize(static_cast<std::size_t>(right.n_rows) * right.n_columns);
      const Block copy{buffer.data(), right.n_rows, right.n_columns, right.n_rows};
      for (int j = 0; j < right.n_columns; ++j)
        std::copy_n(right.column(j), right.n_rows, copy.column(j));
      multiply(1, inverse, copy, 0, right);
    }
  } // namespace

  void multiply(const double alpha, const Block &a, const double *x, double *y)
  {
    if (a.n_rows == 0 || a.n_columns == 0)
      return;
    const types::blas_int m = a.n_rows, n = a.n_columns, stride = a.stride, one = 1;
    const double          beta = 1;
    gemv("N", &m, &n, &alpha, a.data, &stride, x, &one, &beta, y, &one);
  }

  bool eliminate_pivots(const FrontFactors &front, const Block &update, std::vector<double> &buffer)
  {
    const int n = front.pivots.n_columns;
    double    inverse_data[panel_width * panel_width];
    for (int begin = 0; begin < n; begin += panel_width)
    {
      const int   width = std::min(panel_width, n - begin), end = begin + width;
      const Block panel = front.pivots.part(begin, begin, n - begin, width);
      if (!factorize_panel(panel, front.exchanges + begin))
        return false;
      for (int c = begin; c < end; ++c)
      {
        front.exchanges[c] += begin;
        if (front.exchanges[c] == c)
          continue;
        exchange_rows(front.pivots.part(0, 0, n, begin), c, front.exchanges[c]);
        exchange_rows(front.pivots.part(0, end, n, n - end), c, front.exchanges[c]);
        exchange_rows(front.right, c, front.exchanges[c]);
      }
      const Block diagonal = panel.part(0, 0, width, width);
      const Block lower    = panel.part(width, 0, n - end, width);
      const Block inverse{inverse_data, width, width, width};
      invert_unit_lower_triangle(diagonal, inverse);

      const Block upper = front.pivots.part(begin, end, width, n - end);
      const Block right = front.right.part(begin, 0, width, front.right.n_columns);
      const Block below = front.below.part(0, begin, front.below.n_rows, width);
      solve_from_left(inverse, upper, buffer);
      solve_from_left(inverse, right, buffer);
      solve_from_right(diagonal, below);
      multiply(-1, lower, upper, 1, front.pivots.part(end, end, n - end, n - end));
      multiply(-1, lower, right, 1, front.right.part(end, 0, n - end, right.n_columns));
      multiply(-1, below, upper, 1, front.below.part(0, end, below.n_rows, n - end));
    }
    multiply(-1, front.below, front.right, 1, update);
    return true;
  }

  unsigned int count_poor_pivots(const FrontFactors &front)
  {
    unsigned int n_poor = 0;
    for (int j = 0; j < front.below.n_columns; ++j)
    {
      const double *column  = front.below.column(j);
      double        largest = 0;
      for (int i = 0; i < front.below.n_rows; ++i)
        largest = std::max(largest, std::abs(column[i]));
      if (!(largest < largest_growth))
        ++n_poor;
    }
    return n_poor;
  }
} // namespace caudal
