#ifndef caudal_app_verify_restart_h
#define caudal_app_verify_restart_h

#include <caudal/base/parameter_file.h>

#include <deal.II/base/mpi.h>

namespace caudal
{
  /**
   * Runs @p n_steps of the case, an even number, and half of them, resumed for the other half,
   * and compares: the last checkpoints, statistics.txt and the list of fields, byte by byte.
   * A third run without a checkpoint must differ by no more than the solver allows. Returns what
   * was compared; throws if there is a difference. The results are left in
   * `<Output/Folder>.verify`. Rank 0 factorises alone (Solver/Reproducible).
   */
  template <int dim>
  std::string verify_restart(const ParameterFile &file, unsigned int n_steps,
                             MPI_Comm communicator);
} // namespace caudal

#endif
