// SPDX-License-Identifier: LGPL-2.1-or-later
#include "division.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <tuple>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /**
     * Cost of the elimination of an unknown without a position in units of one with a position:
     * those of a body are coupled with more others.
     */
    constexpr double relative_cost = 6;

    constexpr double nowhere = std::numeric_limits<double>::lowest();

    /** Which groups this rank's parts touch. */
    std::vector<int> find_touched(const Groups &groups, const MatrixParts &matrix)
    {
      std::vector<int> touched(groups.count());
      for (const ElementMatrix &element : matrix.elements)
        for (int i = 0; i < element.n; ++i)
          touched[groups.of_unknown[element.unknowns[i]]] = 1;
      for (const auto *indices : {&matrix.entries.rows, &matrix.entries.columns})
        for (const int unknown : *indices)
          touched[groups.of_unknown[unknown]] = 1;
      return touched;
    }
  } // namespace

  Groups::Groups(const std::vector<int> &begins, const int n_placed)
      : n_placed_groups(std::lower_bound(begins.begin(), begins.end(), n_placed) - begins.begin())
      , begins(begins)
      , of_unknown(begins.back())
  {
    AssertDimension(begins[n_placed_groups], n_placed);
    for (int group = 0; group < count(); ++group)
      std::fill(of_unknown.begin() + begins[group], of_unknown.begin() + begins[group + 1], group);
  }

  void Positions::set(const std::vector<double> &own, const MPI_Comm communicator)
  {
    positions.clear();
    for (const auto &part : Utilities::MPI::all_gather(communicator, own))
      positions.insert(positions.end(), part.begin(), part.end());
    sorted = positions;
    std::sort(sorted.begin(), sorted.end());
  }

  std::vector<double> Positions::place_groups(const Groups &groups, const Triplets &entries,
                                              const MPI_Comm communicator) const
  {
    std::vector<double> place(groups.count(), nowhere);
    for (int group = 0; group < groups.n_placed_groups; ++group)
      place[group] = positions[groups.begins[group]];
    std::vector<std::pair<int, int>> neighbours;
    for (std::size_t k = 0; k < entries.values.size(); ++k)
    {
      const int row    = groups.of_unknown[entries.rows[k]];
      const int column = groups.of_unknown[entries.columns[k]];
      if (std::max(row, column) >= groups.n_placed_groups)
        neighbours.emplace_back(row, column);
    }
    // Neighbours of neighbours follow, until nothing more is reached.
    const auto first_free = place.begin() + groups.n_placed_groups;
    for (bool some_reached = true; some_reached;)
    {
      std::vector<double> reached(first_free, place.end());
      const auto          reach = [&](const int group, const int from) {
        if (place[group] == nowhere)
        {
          double &position = reached[group - groups.n_placed_groups];
          position         = std::max(position, place[from]);
        }
      };
      for (const auto &[row, column] : neighbours)
      {
        reach(row, column);
        reach(column, row);
      }
      Utilities::MPI::max(reached, communicator, reached);
      some_reached = !std::equal(reached.begin(), reached.end(), first_free);
      std::copy(reached.begin(), reached.end(), first_free);
    }
    return place;
  }

  std::vector<double> Positions::find_cuts(std::vector<double> others,
                                           const unsigned int  n_ranks) const
  {
    std::sort(others.begin(), others.end());
    const auto count_before = [](const std::vector<double> &values, const double position) {
      return std::lower_bound(values.begin(), values.end(), position) - values.begin();
    };
    const double        total = sorted.size() + relative_cost * others.size();
    std::vector<double> cuts;
    for (unsigned int rank = 1; rank < n_ranks; ++rank)
    {
      const auto cut =
          std::partition_point(sorted.begin(), sorted.end(), [&](const double position) {
            return count_before(sorted, position) + relative_cost * count_before(others, position) <
                   rank * total / n_ranks;
          });
      cuts.push_back(cut == sorted.end() ? std::numeric_limits<double>::max() : *cut);
    }
    return cuts;
  }

  std::vector<int> Positions::divide(const Groups &groups, const MatrixParts &parts,
                                     const MPI_Comm communicator) const
  {
    const std::vector<double> place = place_groups(groups, parts.entries, communicator);
    std::vector<double>       others;
    for (int group = groups.n_placed_groups; group < groups.count(); ++group)
      others.insert(others.end(), groups.begins[group + 1] - groups.begins[group], place[group]);
    const auto cuts = find_cuts(others, Utilities::MPI::n_mpi_processes(communicator));
    // Positions that differ by round-off are one.
    const double     tolerance = sorted.empty() ? 0. : 1e-9 * (sorted.back() - sorted.front());
    std::vector<int> rank_of(groups.of_unknown.size());
    for (std::size_t unknown = 0; unknown < rank_of.size(); ++unknown)
      rank_of[unknown] = std::upper_bound(cuts.begin(), cuts.end(),
                                          place[groups.of_unknown[unknown]] + tolerance) -
                         cuts.begin();
    return rank_of;
  }

  Share::Share(const Groups &groups, const MatrixParts &parts, const MPI_Comm communicator)
      : place(groups.begins.back())
  {
    const std::vector<int> touched = find_touched(groups, parts);
    std::vector<int>       n_touching(touched);
    Utilities::MPI::sum(n_touching, communicator, n_touching);
    const auto add = [&](const int group) {
      group_begins.push_back(unknowns.size());
      for (int unknown = groups.begins[group]; unknown < groups.begins[group + 1]; ++unknown)
      {
        place[unknown] = unknowns.size();
        unknowns.push_back(unknown);
      }
    };
    // What nobody touches makes the matrix singular, and the root notice it.
    const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
    for (int group = 0; group < groups.count(); ++group)
      if (n_touching[group] == 1 ? touched[group] == 1 : n_touching[group] == 0 && is_root)
        add(group);
    n_interior = unknowns.size();
    for (int group = 0; group < groups.count(); ++group)
      if (n_touching[group] > 1)
      {
        if (touched[group])
          add(group);
        for (int unknown = groups.begins[group]; unknown < groups.begins[group + 1]; ++unknown)
        {
          if (touched[group])
            interface_places.push_back(interface_unknowns.size());
          interface_unknowns.push_back(unknown);
        }
      }
    group_begins.push_back(unknowns.size());
  }
} // namespace caudal
