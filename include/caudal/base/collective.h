// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_collective_h
#define caudal_base_collective_h

#include <mpi.h>

#include <functional>
#include <string>

namespace caudal
{
  /** Runs @p action; what it throws is returned as a sentence, nothing else is an empty text. */
  std::string catch_error(const std::function<void()> &action);

  /**
   * Runs @p action on rank 0 of @p communicator only. If it throws, every rank
   * throws the same sentence, so that no rank waits for another one in vain.
   * Collective.
   */
  void run_on_root(MPI_Comm communicator, const std::function<void()> &action);

  /** The error of the first rank that has one, on all ranks; "" if none has. Collective. */
  std::string find_first_error(MPI_Comm communicator, const std::string &error);

  /** Throws the error of the first rank that has one on all ranks. Collective. */
  void throw_on_all(MPI_Comm communicator, const std::string &error);

  /** Runs @p action on all ranks; what the first of them throws, all throw. Collective. */
  void run_on_all(MPI_Comm communicator, const std::function<void()> &action);
} // namespace caudal

#endif
