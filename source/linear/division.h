// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_division_h
#define caudal_linear_division_h

#include <caudal/linear/multifrontal.h>

#include <mpi.h>

namespace caudal
{
  /** Unknowns in groups: first those that have a position, then the others. */
  struct Groups
  {
    Groups(const std::vector<int> &begins, int n_placed);

    int count() const
    {
      return begins.size() - 1;
    }

    const int               n_placed_groups;
    const std::vector<int> &begins;
    std::vector<int>        of_unknown;
  };

  /** Positions of the first unknowns along a line, by which they are divided among the ranks. */
  class Positions
  {
  public:
    /** @p own: those of this rank's unknowns, which follow those of the rank before. Collective. */
    void set(const std::vector<double> &own, MPI_Comm communicator);

    std::size_t size() const
    {
      return positions.size();
    }

    /**
     * The rank of each unknown: the line is cut into one strip for each rank, so that strips cost
     * about the same. A group without a position has that of the last one of its neighbours, so
     * that few reach from one rank to another. Depends on the pattern only. Collective.
     */
    std::vector<int> divide(const Groups &groups, const MatrixParts &parts,
                            MPI_Comm communicator) const;

  private:
    std::vector<double> positions, sorted;

    std::vector<double> place_groups(const Groups &groups, const Triplets &entries,
                                     MPI_Comm communicator) const;
    /** Where strips begin, but for the first; @p others: positions of the other unknowns. */
    std::vector<double> find_cuts(std::vector<double> others, unsigned int n_ranks) const;
  };

  /** This rank's share of the unknowns. */
  struct Share
  {
    Share(const Groups &groups, const MatrixParts &parts, MPI_Comm communicator);

    /** The unknowns it eliminates, then those of the interface that it touches. */
    std::vector<int> unknowns;
    unsigned int     n_interior = 0;
    /** In groups, by their numbers in `unknowns`. */
    std::vector<int> group_begins;
    /** For each unknown its number in `unknowns`. */
    std::vector<int> place;
    /** The whole interface between the ranks, and the places there of this rank's unknowns. */
    std::vector<int> interface_unknowns, interface_places;
  };
} // namespace caudal

#endif
