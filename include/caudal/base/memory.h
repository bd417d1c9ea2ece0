// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_memory_h
#define caudal_base_memory_h

#include <deal.II/base/mpi.h>

#include <string>

namespace caudal
{
  /**
   * The memory that this process may still take [bytes]: what the system, its control group
   * (containers, batch systems) and the limit of its address space (ulimit -v) leave, if the former
   * two are shared equally by @p n_processes.
   */
  double get_free_memory(unsigned int n_processes = 1);

  /**
   * Throws a sentence if this run, which needs at least @p need [bytes] on all ranks together,
   * can't have it: @p what is needed ("the fluid's grid has 3e9 cells"), @p remedy is a sentence.
   * Collective.
   */
  void check_memory(MPI_Comm communicator, double need, const std::string &what,
                    const std::string &remedy);

  /** What to say when the system has refused memory. */
  std::string describe_lack_of_memory();
} // namespace caudal

#endif
