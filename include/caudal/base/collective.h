#ifndef caudal_base_collective_h
#define caudal_base_collective_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <exception>
#include <sstream>
#include <string>

namespace caudal
{
  /** Runs @p action; what it throws is returned as a sentence. */
  template <typename Action>
  std::string catch_error(const Action &action)
  {
    try
    {
      action();
    }
    catch (dealii::ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      return dealii::Utilities::trim(text.str());
    }
    catch (std::exception &exception)
    {
      return exception.what();
    }
    return "";
  }

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
      error = catch_error(action);
    error = dealii::Utilities::MPI::broadcast(communicator, error);
    AssertThrow(error.empty(), dealii::ExcMessage(error));
  }

  /** Throws the error of the first rank that has one on all ranks. Collective. */
  inline void throw_on_all(const MPI_Comm communicator, const std::string &error)
  {
    const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    const unsigned int none = dealii::Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int first =
        dealii::Utilities::MPI::min(error.empty() ? none : rank, communicator);
    AssertThrow(first == none,
                dealii::ExcMessage(dealii::Utilities::MPI::broadcast(communicator, error, first)));
  }

  /** Runs @p action on all ranks; what the first of them throws, all throw. Collective. */
  template <typename Action>
  void run_on_all(const MPI_Comm communicator, const Action &action)
  {
    throw_on_all(communicator, catch_error(action));
  }
} // namespace caudal

#endif
