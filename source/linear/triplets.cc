// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/linear/triplets.h>

#include <deal.II/base/mpi.h>

#include <map>

using namespace dealii;

namespace caudal
{
  Triplets exchange(const Triplets &own, const std::vector<unsigned int> &rank_of,
                    const MPI_Comm communicator)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return own;
    std::map<unsigned int, Triplets> messages;
    for (std::size_t k = 0; k < own.size(); ++k)
      messages[rank_of[k]].add(own.rows[k], own.columns[k], own.values[k]);
    Triplets all; // messages that are not compressed, which takes longer than to send them
    for (const auto &message : Utilities::MPI::some_to_some(communicator, messages))
      all.add(message.second);
    return all;
  }

  Triplets gather_on_root(const Triplets &own, const MPI_Comm communicator)
  {
    return exchange(own, std::vector<unsigned int>(own.size(), 0), communicator);
  }
} // namespace caudal
