// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_app_verify_restart_h
#define caudal_app_verify_restart_h

#include <caudal/base/parameter_file.h>

#include <deal.II/base/mpi.h>

namespace caudal
{
  /**
   * Runs @p n_steps of the case without a checkpoint; then again, but stopped after a random step
   * and resumed for the rest. Compares the final states, the tables and the list of fields, byte by
   * byte. Returns what was compared; throws if there is a difference. The results are left in
   * `<Output/Folder>.verify`.
   */
  template <class Swimmer>
  std::string verify_restart(const ParameterFile &file, unsigned int n_steps,
                             MPI_Comm communicator);
} // namespace caudal

#endif
