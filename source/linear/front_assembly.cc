// SPDX-License-Identifier: LGPL-2.1-or-later
#include "front_assembly.h"

#include <algorithm>

namespace caudal
{
  namespace
  {
    /** Column of a front, which is in two blocks. */
    struct Column
    {
      Column(const int column, const FrontFactors &front, const Block &update)
          : n_pivots(front.pivots.n_columns)
          , top(column < n_pivots ? front.pivots.column(column)
                                  : front.right.column(column - n_pivots))
          , bottom(column < n_pivots ? front.below.column(column)
                                     : update.column(column - n_pivots))
      {}

      double &operator[](const int row) const
      {
        return row < n_pivots ? top[row] : bottom[row - n_pivots];
      }

      const int     n_pivots;
      double *const top, *const bottom;
    };
  } // namespace

  FrontAssembly::FrontAssembly(const EliminationTree &tree, const MatrixParts &matrix,
                               const std::vector<double> &scales)
      : tree(tree)
      , matrix(matrix)
      , scales(scales)
      , places(scales.size())
  {}

  void FrontAssembly::add_parts(const std::size_t index, const FrontFactors &front,
                                const Block &update)
  {
    const auto &[begin, n_pivots, n_rest, parent] = tree.fronts[index];
    for (unsigned int i = 0; i < n_pivots + n_rest; ++i)
      places[tree.unknowns[begin + i]] = i;
    for (int k = tree.elements.begins[index]; k < tree.elements.begins[index + 1]; ++k)
      add_element(matrix.elements[tree.elements.numbers[k]], front, update);
    for (int k = tree.entries.begins[index]; k < tree.entries.begins[index + 1]; ++k)
    {
      const int    entry  = tree.entries.numbers[k];
      const int    row    = matrix.entries.rows[entry];
      const int    column = matrix.entries.columns[entry];
      const double value  = matrix.entries.values[entry];
      Column(places[column], front, update)[places[row]] += scales[row] * scales[column] * value;
    }
  }

  void FrontAssembly::add_element(const ElementMatrix &element, const FrontFactors &front,
                                  const Block &update) const
  {
    for (int j = 0; j < element.n; ++j)
    {
      const int     column = element.unknowns[j];
      const Column  target(places[column], front, update);
      const double *value = element.values + j;
      for (int i = 0; i < element.n; ++i, value += element.n)
      {
        const int row = element.unknowns[i];
        target[places[row]] += scales[row] * scales[column] * *value;
      }
    }
  }

  void FrontAssembly::add_update(const EliminationTree::Front &child, const double *child_update,
                                 const FrontFactors &front, const Block &update)
  {
    const int  n    = child.n_rest;
    const int *rest = tree.unknowns.data() + child.begin + child.n_pivots;
    rows.resize(n);
    std::transform(rest, rest + n, rows.begin(),
                   [&](const int unknown) { return places[unknown]; });
    find_runs(front.pivots.n_columns);
    for (int j = 0; j < n; ++j)
    {
      const Column target(rows[j], front, update);
      for (const Run &run : runs)
      {
        const double *source = child_update + static_cast<std::size_t>(j) * n + run.begin;
        double       *sum    = &target[rows[run.begin]];
#pragma omp simd
        for (int i = 0; i < run.length; ++i)
          sum[i] += source[i];
      }
    }
  }

  /** Rows ascend; no run crosses from the front's pivots to its rest. */
  void FrontAssembly::find_runs(const int n_pivots)
  {
    runs.clear();
    for (int i = 0; i < static_cast<int>(rows.size()); ++i)
      if (i > 0 && rows[i] == rows[i - 1] + 1 && rows[i] != n_pivots)
        ++runs.back().length;
      else
        runs.push_back({i, 1});
  }
} // namespace caudal
