#ifndef caudal_io_on_root_h
#define caudal_io_on_root_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <exception>
#include <sstream>
#include <string>

namespace caudal
{
  /**
   * Runs @p action on rank 0 of @p communicator only. If it throws, every rank
   * throws the same sentence, so that no rank waits for another one in vain.
   * Collective.
   */
  template <typename Action>
  void run_on_root(const MPI_Comm communicator, const Action &action)
  {
    std::string error;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
      {
        action();
      }
      catch (dealii::ExceptionBase &exception)
      {
        std::ostringstream text;
        exception.print_info(text);
        error = dealii::Utilities::trim(text.str());
      }
      catch (std::exception &exception)
      {
        error = exception.what();
      }
    error = dealii::Utilities::MPI::broadcast(communicator, error);
    AssertThrow(error.empty(), dealii::ExcMessage(error));
  }
} // namespace caudal

#endif
