// SPDX-License-Identifier: LGPL-2.1-or-later
#include "factorization.h"

#include "front_assembly.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /**
     * Where more pivots than this part are poor, the others are not good either. Schools of
     * bodies with nodes 0.36 cells apart: 9 %, and 13 to 40 iterations; else none, and 1 to 4.
     */
    constexpr double largest_part_poor = 0.01;

    /** Room for @p size numbers, whatever they are; some more where there was too little. */
    void resize_anew(AlignedVector<double> &numbers, const std::size_t size)
    {
      if (size > numbers.capacity())
      {
        numbers.clear(); // they need not be copied
        numbers.reserve(size + size / 8);
      }
      numbers.resize_fast(size);
    }

    void gather(const std::vector<double> &vector, const int *unknowns, const unsigned int n,
                std::vector<double> &result)
    {
      result.resize(n);
      for (unsigned int i = 0; i < n; ++i)
        result[i] = vector[unknowns[i]];
    }
  } // namespace

  void Factorization::compute_scales(const MatrixParts &matrix, const unsigned int n)
  {
    scales.assign(n, 0.);
    const auto regard = [&](const int unknown, const double value) {
      scales[unknown] = std::max(scales[unknown], std::abs(value));
    };
    for (const ElementMatrix &element : matrix.elements)
    {
      const double *value = element.values;
      for (int i = 0; i < element.n; ++i)
        for (int j = 0; j < element.n; ++j, ++value)
        {
          regard(element.unknowns[i], *value);
          regard(element.unknowns[j], *value);
        }
    }
    const Triplets &entries = matrix.entries;
    for (std::size_t k = 0; k < entries.values.size(); ++k)
    {
      regard(entries.rows[k], entries.values[k]);
      regard(entries.columns[k], entries.values[k]);
    }
    for (unsigned int i = 0; i < n; ++i)
      scales[i] = i < n_eliminated && scales[i] > 0. ? 1 / std::sqrt(scales[i]) : 1.;
  }

  void Factorization::lay_out_factors()
  {
    factor_begins.assign(1, 0);
    exchange_begins.assign(1, 0);
    for (const auto &front : tree.fronts)
    {
      factor_begins.push_back(factor_begins.back() + FrontFactors::count(front));
      exchange_begins.push_back(exchange_begins.back() + front.n_pivots);
    }
    resize_anew(factors, factor_begins.back());
    exchanges.resize(exchange_begins.back());
  }

  /**
   * Two stacks, which alternate from one level of the tree to the next: a front's update is made
   * on one of them while those of its children lie on top of the other.
   */
  void Factorization::lay_out_updates()
  {
    const auto get_size = [](const EliminationTree::Front &front) {
      return static_cast<std::size_t>(front.n_rest) * front.n_rest;
    };
    std::vector<int> stack_of(tree.fronts.size(), 0);
    for (std::size_t f = tree.fronts.size(); f-- > 0;)
      if (tree.fronts[f].parent >= 0)
        stack_of[f] = 1 - stack_of[tree.fronts[f].parent];

    std::array<std::size_t, 2> top{}, height{};
    update_begins.resize(tree.fronts.size());
    std::vector<std::size_t> of_children(tree.fronts.size(), 0); // their size
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
    {
      const int         stack = stack_of[f], parent = tree.fronts[f].parent;
      const std::size_t size = get_size(tree.fronts[f]);
      // In postorder those of the children are on top.
      Assert(of_children[f] <= top[1 - stack], ExcInternalError());
      top[1 - stack] -= of_children[f];
      update_begins[f] = top[stack];
      height[stack]    = std::max(height[stack], top[stack] + size);
      if (parent >= 0)
      {
        top[stack] += size;
        of_children[parent] += size;
      }
    }
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
      if (stack_of[f] == 1)
        update_begins[f] += height[0];
    resize_anew(updates, height[0] + height[1]);
  }

  bool Factorization::compute(const std::vector<int> &group_begins, const MatrixParts &matrix,
                              const unsigned int n_kept)
  {
    const unsigned int n = group_begins.back();
    n_eliminated         = n - n_kept;
    if (tree.update(group_begins, matrix, n_kept))
    {
      ++n_orderings;
      lay_out_factors();
      lay_out_updates();
    }
    compute_scales(matrix, n);
    schur_complement.assign(static_cast<std::size_t>(n_kept) * n_kept, 0.);
    return eliminate(matrix);
  }

  bool Factorization::eliminate(const MatrixParts &matrix)
  {
    FrontAssembly                 assembly(tree, matrix, scales);
    std::vector<std::vector<int>> children(tree.fronts.size());
    std::vector<double>           buffer;
    unsigned int                  n_poor_pivots = 0;
    const std::size_t             n_kept        = scales.size() - n_eliminated;
    const auto add_to_schur_complement = [&](const int row, const int column, const double value) {
      schur_complement[(row - n_eliminated) * n_kept + column - n_eliminated] += value;
    };
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
    {
      const auto        &front  = tree.fronts[f];
      const FrontFactors factor = get_factors(f);
      const int          n_rest = front.n_rest;
      std::fill_n(factors.data() + factor_begins[f], FrontFactors::count(front), 0.);
      const Block update{updates.data() + update_begins[f], n_rest, n_rest, n_rest};
      for (int j = 0; j < n_rest; ++j)
        std::fill_n(update.column(j), n_rest, 0.);

      assembly.add_parts(f, factor, update);
      for (const int child : children[f])
        assembly.add_update(tree.fronts[child], updates.data() + update_begins[child], factor,
                            update);
      if (!eliminate_pivots(factor, update, buffer))
        return false;
      n_poor_pivots += count_poor_pivots(factor);

      const int *rest = tree.unknowns.data() + front.begin + front.n_pivots;
      if (front.parent >= 0)
        children[front.parent].push_back(f);
      else
        for (int j = 0; j < n_rest; ++j)
          for (int i = 0; i < n_rest; ++i)
            add_to_schur_complement(rest[i], rest[j], update.column(j)[i]);
    }
    assembly.for_each_kept_entry(add_to_schur_complement);
    return n_poor_pivots <= largest_part_poor * n_eliminated;
  }

  FrontFactors Factorization::get_factors(const std::size_t f)
  {
    return {tree.fronts[f], factors.data() + factor_begins[f], &exchanges[exchange_begins[f]]};
  }

  double Factorization::get_n_operations() const
  {
    double sum = 0;
    for (const auto &[begin, n_pivots, n_rest, parent] : tree.fronts)
    {
      const double k = n_pivots, r = n_rest;
      sum += k * (2. / 3. * k * k + 2 * k * r + 2 * r * r);
    }
    return sum;
  }

  void Factorization::condense(std::vector<double> &vector)
  {
    AssertDimension(vector.size(), scales.size());
    for (unsigned int i = 0; i < n_eliminated; ++i)
      vector[i] *= scales[i];
    std::vector<double> pivots, rest;
    for (std::size_t f = 0; f < tree.fronts.size(); ++f)
    {
      const auto        &front    = tree.fronts[f];
      const int         *unknowns = tree.unknowns.data() + front.begin;
      const FrontFactors factor   = get_factors(f);
      gather(vector, unknowns, front.n_pivots, pivots);
      for (unsigned int i = 0; i < front.n_pivots; ++i)
        std::swap(pivots[i], pivots[factor.exchanges[i]]);
      for (unsigned int j = 0; j < front.n_pivots; ++j)
        for (unsigned int i = j + 1; i < front.n_pivots; ++i)
          pivots[i] -= factor.pivots.column(j)[i] * pivots[j];
      for (unsigned int i = 0; i < front.n_pivots; ++i)
        vector[unknowns[i]] = pivots[i];
      rest.assign(front.n_rest, 0.);
      multiply(1, factor.below, pivots.data(), rest.data());
      for (unsigned int i = 0; i < front.n_rest; ++i)
        vector[unknowns[front.n_pivots + i]] -= rest[i];
    }
  }

  void Factorization::expand(std::vector<double> &vector)
  {
    AssertDimension(vector.size(), scales.size());
    std::vector<double> pivots, rest;
    for (std::size_t f = tree.fronts.size(); f-- > 0;)
    {
      const auto        &front    = tree.fronts[f];
      const int         *unknowns = tree.unknowns.data() + front.begin;
      const FrontFactors factor   = get_factors(f);
      gather(vector, unknowns, front.n_pivots, pivots);
      gather(vector, unknowns + front.n_pivots, front.n_rest, rest);
      multiply(-1, factor.right, rest.data(), pivots.data());
      for (unsigned int j = front.n_pivots; j-- > 0;)
      {
        pivots[j] /= factor.pivots.column(j)[j];
        for (unsigned int i = 0; i < j; ++i)
          pivots[i] -= factor.pivots.column(j)[i] * pivots[j];
      }
      for (unsigned int i = 0; i < front.n_pivots; ++i)
        vector[unknowns[i]] = pivots[i];
    }
    for (unsigned int i = 0; i < n_eliminated; ++i)
      vector[i] *= scales[i];
  }
} // namespace caudal
