// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_elimination_tree_h
#define caudal_linear_elimination_tree_h

#include <caudal/linear/multifrontal.h>

namespace caudal
{
  /**
   * Fronts in which a sparse matrix is eliminated: each has the unknowns that it eliminates, its
   * pivots, and the rest of the unknowns that these are coupled with by then. What it leaves for
   * its rest goes to the front that eliminates the first one of it (Liu 1992,
   * doi:10.1137/1034004). Fronts are in postorder: each comes right behind those of its subtree.
   *
   * The order is that of constrained approximate minimum degree, the fronts are those of CHOLMOD's
   * supernodes (Chen, Davis, Hager & Rajamanickam 2008, doi:10.1145/1391989.1391995). Both regard
   * the pattern as symmetric.
   */
  class EliminationTree
  {
  public:
    struct Front
    {
      std::size_t  begin; // of its unknowns in `unknowns`: first its pivots, then its rest
      unsigned int n_pivots, n_rest;
      int          parent; // -1: none, all of its rest is kept
    };

    /** Numbers of a matrix' parts, front by front; last those that couple kept unknowns only. */
    struct PartsOfFronts
    {
      std::vector<int> begins, numbers;
    };

    /**
     * Analyses @p matrix, unless its pattern is that of the last call. Unknowns are ordered in
     * groups with consecutive indices: @p group_begins has their first unknowns, and behind them
     * the number of all unknowns. The last @p n_kept unknowns, which are whole groups, are not
     * eliminated. Returns whether the tree is a new one.
     */
    bool update(const std::vector<int> &group_begins, const MatrixParts &matrix,
                unsigned int n_kept);

    std::vector<Front> fronts;
    std::vector<int>   unknowns;
    /** Parts that begin with a pivot of each front. */
    PartsOfFronts elements, entries;

  private:
    /** All that the fronts depend on. */
    std::vector<int> pattern;
    /** For each unknown its place in the order of elimination; kept ones come after all others. */
    std::vector<int> place;
    /** For each unknown the front that eliminates it, -1 for kept ones. */
    std::vector<int> front_of;

    void find_fronts(const std::vector<int> &group_begins, const MatrixParts &matrix,
                     int first_kept_group, const std::vector<int> &group_of);
    void assign_parts(const MatrixParts &matrix);
  };
} // namespace caudal

#endif
