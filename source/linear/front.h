// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_front_h
#define caudal_linear_front_h

#include "elimination_tree.h"

namespace caudal
{
  /** Dense matrix stored column by column, or a part of one; non-owning. */
  struct Block
  {
    double *data;
    int     n_rows, n_columns, stride;

    double *column(const int j) const
    {
      return data + static_cast<std::size_t>(j) * stride;
    }

    Block part(const int row, const int column_index, const int rows, const int columns) const
    {
      return {column(column_index) + row, rows, columns, stride};
    }
  };

  /** y += alpha a x */
  void multiply(double alpha, const Block &a, const double *x, double *y);

  /**
   * Factors of a front: A = [pivots, right; below, update] becomes L U with
   * pivots = L_11 U_11 (rows exchanged), right = U_12, below = L_21.
   */
  struct FrontFactors
  {
    FrontFactors(const EliminationTree::Front &front, double *data, int *exchanges)
        : pivots{data, static_cast<int>(front.n_pivots), static_cast<int>(front.n_pivots),
                 static_cast<int>(front.n_pivots)}
        , right{pivots.column(front.n_pivots), pivots.n_rows, static_cast<int>(front.n_rest),
                pivots.stride}
        , below{right.column(front.n_rest), static_cast<int>(front.n_rest), pivots.n_columns,
                static_cast<int>(front.n_rest)}
        , exchanges(exchanges)
    {}

    static std::size_t count(const EliminationTree::Front &front)
    {
      return static_cast<std::size_t>(front.n_pivots) * (front.n_pivots + 2 * front.n_rest);
    }

    Block pivots, right, below;
    int  *exchanges;
  };

  /**
   * Eliminates the pivots of a front, panel by panel: assembled blocks become factors, and
   * @p update what is left for the rest. @p buffer is work space. Returns false if a pivot is
   * zero.
   */
  bool eliminate_pivots(const FrontFactors &front, const Block &update,
                        std::vector<double> &buffer);

  /** Counts pivots that are much smaller than the entries below them. */
  unsigned int count_poor_pivots(const FrontFactors &front);
} // namespace caudal

#endif
