#ifndef caudal_app_verify_restart_h
#define caudal_app_verify_restart_h

#include <caudal/base/parameter_file.h>

#include <deal.II/base/mpi.h>

namespace caudal
{
  /**
   * Runs @p n_steps of the case, an even number, and half of them, resumed for the other half,
   * and compares: the last checkpoints, the tables and the list of fields, byte by byte.
   * Returns what was compared; throws if there is a difference. The results are left in
   * `<Output/Folder>.verify`.
   *
   * The immersed swimmer's checkpoints restart its solver; a third run without a checkpoint must
   * differ by no more than the solver allows.
   */
  template <class Swimmer>
  std::string verify_restart(const ParameterFile &file, unsigned int n_steps,
                             MPI_Comm communicator);
} // namespace caudal

#endif
