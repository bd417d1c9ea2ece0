// SPDX-License-Identifier: LGPL-2.1-or-later
#include "divided_factors.h"

#include <caudal/linear/near_system.h>

#include <deal.II/base/mpi.h>

using namespace dealii;

namespace caudal
{
  NearSystem::NearSystem(const MPI_Comm communicator, const unsigned int largest_complete,
                         const unsigned int smallest_slice)
      : communicator(communicator)
      , largest_complete(largest_complete)
      , smallest_slice(smallest_slice)
  {}

  NearSystem::~NearSystem() = default;

  void NearSystem::factorize(const NearMatrices &matrices)
  {
    factors.reset(); // before there are others
    n_entries = 0;
    if (matrices.n_q + matrices.owned_x.size() <= largest_complete)
      factors = std::make_unique<CompleteFactors>(matrices, communicator);
    else
      factors = std::make_unique<DividedFactors>(matrices, smallest_slice, communicator);
    n_entries = Utilities::MPI::sum(factors->get_n_entries(), communicator);
    pivoted   = Utilities::MPI::max(static_cast<int>(factors->has_pivoted()), communicator) == 1;
  }

  const std::vector<int> &NearSystem::get_own_q() const
  {
    return factors->get_own_q();
  }

  void NearSystem::solve(Vector<double> &own_q, FieldVector &x) const
  {
    factors->solve(own_q, x);
  }
} // namespace caudal
