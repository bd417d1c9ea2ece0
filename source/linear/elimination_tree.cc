// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elimination_tree.h"
#include "cholmod_context.h"

#include <algorithm>
#include <memory>
#include <numeric>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /** What couples groups: the elements' groups without repetition, and pairs of groups. */
    struct Cliques
    {
      Cliques(const std::vector<int> &group_of, const int n_groups, const MatrixParts &matrix)
          : begins(1, 0)
      {
        std::vector<std::size_t> last_clique(n_groups, -1);
        const auto               add = [&](const int unknown) {
          const int group = group_of[unknown];
          if (last_clique[group] != begins.size())
          {
            last_clique[group] = begins.size();
            groups.push_back(group);
          }
        };
        for (const ElementMatrix &element : matrix.elements)
        {
          std::for_each(element.unknowns, element.unknowns + element.n, add);
          begins.push_back(groups.size());
        }
        // Entries of one pair of groups often follow each other.
        std::vector<int> last_partner(n_groups, -1);
        for (std::size_t k = 0; k < matrix.entries.values.size(); ++k)
        {
          const int row    = group_of[matrix.entries.rows[k]];
          const int column = group_of[matrix.entries.columns[k]];
          int      &last   = last_partner[std::min(row, column)];
          if (row != column && last != std::max(row, column))
          {
            last = std::max(row, column);
            groups.push_back(row);
            groups.push_back(column);
            begins.push_back(groups.size());
          }
        }
      }

      std::size_t count() const
      {
        return begins.size() - 1;
      }

      std::vector<int> begins, groups;
    };

    /** Upper triangle of the symmetric pattern in which each clique couples all of its groups. */
    Cholmod::Matrix find_pattern(Cholmod &cholmod, const int n_groups, Cliques &cliques)
    {
      cholmod_sparse members{}; // groups times cliques
      members.nrow         = n_groups;
      members.ncol         = cliques.count();
      members.nzmax        = cliques.groups.size();
      members.p            = cliques.begins.data();
      members.i            = cliques.groups.data();
      members.itype        = CHOLMOD_INT;
      members.xtype        = CHOLMOD_PATTERN;
      members.dtype        = CHOLMOD_DOUBLE;
      members.packed       = 1;
      const auto couplings = cholmod.own(cholmod_aat(&members, nullptr, 0, 0, cholmod));
      return cholmod.own(cholmod_copy(couplings.get(), 1, 0, cholmod));
    }

    std::vector<int> find_order(Cholmod &cholmod, cholmod_sparse &pattern, const int n_eliminated)
    {
      std::vector<int> order(pattern.ncol), constraints(pattern.ncol);
      std::fill(constraints.begin() + n_eliminated, constraints.end(), 1);
      cholmod.check(cholmod_camd(&pattern, nullptr, 0, constraints.data(), order.data(), cholmod) !=
                    0);
      return order;
    }

    /** Numbers that are the same if and only if the analysis is. */
    std::vector<int> list_pattern(const std::vector<int> &group_begins, const MatrixParts &matrix,
                                  const unsigned int n_kept)
    {
      std::vector<int> list(group_begins);
      list.push_back(n_kept);
      list.push_back(matrix.elements.size());
      for (const ElementMatrix &element : matrix.elements)
      {
        list.push_back(element.n);
        list.insert(list.end(), element.unknowns, element.unknowns + element.n);
      }
      list.insert(list.end(), matrix.entries.rows.begin(), matrix.entries.rows.end());
      list.insert(list.end(), matrix.entries.columns.begin(), matrix.entries.columns.end());
      return list;
    }

    EliminationTree::PartsOfFronts sort_by_front(const std::vector<int> &front_of_part,
                                                 const std::size_t       n_fronts)
    {
      EliminationTree::PartsOfFronts parts;
      parts.begins.assign(n_fronts + 1, 0);
      for (const int front : front_of_part)
        ++parts.begins[front + 1];
      std::partial_sum(parts.begins.begin(), parts.begins.end(), parts.begins.begin());
      std::vector<int> next(parts.begins);
      parts.numbers.resize(front_of_part.size());
      for (std::size_t k = 0; k < front_of_part.size(); ++k)
        parts.numbers[next[front_of_part[k]]++] = k;
      return parts;
    }
  } // namespace

  bool EliminationTree::update(const std::vector<int> &group_begins, const MatrixParts &matrix,
                               const unsigned int n_kept)
  {
    std::vector<int> new_pattern = list_pattern(group_begins, matrix, n_kept);
    if (new_pattern == pattern)
      return false;
    pattern.clear(); // in case that something throws

    const int        n_groups = group_begins.size() - 1, n = group_begins.back();
    std::vector<int> group_of(n);
    for (int group = 0; group < n_groups; ++group)
      std::fill(group_of.begin() + group_begins[group], group_of.begin() + group_begins[group + 1],
                group);
    fronts.clear();
    unknowns.clear();
    front_of.assign(n, -1);
    place.assign(n, n);
    if (const int first_kept_group = n_kept > 0 ? group_of[n - n_kept] : n_groups)
      find_fronts(group_begins, matrix, first_kept_group, group_of);
    assign_parts(matrix);
    pattern = std::move(new_pattern);
    return true;
  }

  void EliminationTree::find_fronts(const std::vector<int> &group_begins, const MatrixParts &matrix,
                                    const int first_kept_group, const std::vector<int> &group_of)
  {
    const int n_groups = group_begins.size() - 1;
    Cholmod   cholmod(CHOLMOD_GIVEN);
    // Fronts are joined where that adds few zeros. With CHOLMOD's own limits, which are meant for
    // single unknowns rather than groups, there are a tenth more operations.
    cholmod.data.nrelax[0] = 2;
    cholmod.data.nrelax[1] = 8;
    cholmod.data.nrelax[2] = 24;
    Cliques                cliques(group_of, n_groups, matrix);
    const auto             couplings = find_pattern(cholmod, n_groups, cliques);
    const std::vector<int> order     = find_order(cholmod, *couplings, first_kept_group);

    const auto factor = cholmod.own(
        cholmod_analyze_p(couplings.get(), const_cast<int *>(order.data()), nullptr, 0, cholmod));
    const auto *groups = static_cast<const int *>(factor->Perm);
    const auto *first  = static_cast<const int *>(factor->super); // places of the first pivots
    const auto *begin  = static_cast<const int *>(factor->pi);    // of a front in `rows`
    const auto *rows   = static_cast<const int *>(factor->s);     // places, ascending

    for (std::size_t s = 0; s < factor->nsuper; ++s)
    {
      Front front{unknowns.size(), 0, 0, -1};
      for (int k = begin[s]; k < begin[s + 1]; ++k)
      {
        const int  group    = groups[rows[k]];
        const bool is_pivot = rows[k] < first[s + 1] && group < first_kept_group;
        for (int unknown = group_begins[group]; unknown < group_begins[group + 1]; ++unknown)
        {
          unknowns.push_back(unknown);
          if (is_pivot)
          {
            place[unknown]    = rows[k];
            front_of[unknown] = fronts.size();
          }
          ++(is_pivot ? front.n_pivots : front.n_rest);
        }
      }
      if (front.n_pivots > 0)
        fronts.push_back(front);
      else
        unknowns.resize(front.begin);
    }
    for (Front &front : fronts)
      if (front.n_rest > 0)
        front.parent = front_of[unknowns[front.begin + front.n_pivots]];
  }

  void EliminationTree::assign_parts(const MatrixParts &matrix)
  {
    const auto is_earlier = [&](const int a, const int b) { return place[a] < place[b]; };
    const auto find_front = [&](const int unknown) {
      return front_of[unknown] < 0 ? static_cast<int>(fronts.size()) : front_of[unknown];
    };
    std::vector<int> front_of_part;
    for (const ElementMatrix &element : matrix.elements)
      front_of_part.push_back(find_front(
          *std::min_element(element.unknowns, element.unknowns + element.n, is_earlier)));
    elements = sort_by_front(front_of_part, fronts.size() + 1);
    front_of_part.clear();
    front_of_part.reserve(matrix.entries.values.size());
    for (std::size_t k = 0; k < matrix.entries.values.size(); ++k)
      front_of_part.push_back(
          find_front(std::min(matrix.entries.rows[k], matrix.entries.columns[k], is_earlier)));
    entries = sort_by_front(front_of_part, fronts.size() + 1);
  }
} // namespace caudal
