// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_triplets_h
#define caudal_linear_triplets_h

#include <boost/serialization/vector.hpp>

#include <mpi.h>

#include <vector>

namespace caudal
{
  /** Entries (row, column, value) of a matrix; entries of one place add up. */
  struct Triplets
  {
    std::vector<int>    rows, columns;
    std::vector<double> values;

    std::size_t size() const
    {
      return values.size();
    }

    void add(const int row, const int column, const double value)
    {
      rows.push_back(row);
      columns.push_back(column);
      values.push_back(value);
    }

    void add(const Triplets &others)
    {
      rows.insert(rows.end(), others.rows.begin(), others.rows.end());
      columns.insert(columns.end(), others.columns.begin(), others.columns.end());
      values.insert(values.end(), others.values.begin(), others.values.end());
    }

    bool operator==(const Triplets &other) const
    {
      return rows == other.rows && columns == other.columns && values == other.values;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &rows &columns &values;
    }
  };

  /** All ranks' entries on rank 0, rank by rank; nothing on the others. Collective. */
  Triplets gather_on_root(const Triplets &own, MPI_Comm communicator);

  /**
   * Sends each entry to the rank that @p rank_of tells for it; returns what this rank is sent, rank
   * by rank of those that send. Collective.
   */
  Triplets exchange(const Triplets &own, const std::vector<unsigned int> &rank_of,
                    MPI_Comm communicator);
} // namespace caudal

#endif
