// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_ownership_h
#define caudal_linear_ownership_h

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace caudal
{
  /** Which rank owns what of a vector, of which each rank has consecutive indices. */
  class Ownership
  {
  public:
    Ownership() = default;

    /** This rank has @p n_own, behind those of the ranks before it. Collective. */
    Ownership(const unsigned int n_own, const MPI_Comm communicator)
        : ends(dealii::Utilities::MPI::all_gather(communicator, n_own))
    {
      std::partial_sum(ends.begin(), ends.end(), ends.begin());
    }

    unsigned int find_rank(const unsigned int index) const
    {
      return std::upper_bound(ends.begin(), ends.end(), index) - ends.begin();
    }

    unsigned int get_begin(const unsigned int rank) const
    {
      return rank == 0 ? 0 : ends[rank - 1];
    }

    unsigned int get_end(const unsigned int rank) const
    {
      return ends[rank];
    }

    unsigned int size() const
    {
      return ends.back();
    }

  private:
    std::vector<unsigned int> ends;
  };
} // namespace caudal

#endif
