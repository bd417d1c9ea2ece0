// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/memory.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <new>
#include <sstream>

using namespace dealii;

namespace caudal
{
  std::string catch_error(const std::function<void()> &action)
  {
    try
    {
      action();
    }
    catch (const ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      return Utilities::trim(text.str());
    }
    catch (const std::bad_alloc &)
    {
      return describe_lack_of_memory();
    }
    catch (const std::exception &exception)
    {
      return exception.what();
    }
    return "";
  }

  void run_on_root(const MPI_Comm communicator, const std::function<void()> &action)
  {
    std::string error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      error = catch_error(action);
    error = Utilities::MPI::broadcast(communicator, error);
    AssertThrow(error.empty(), ExcMessage(error));
  }

  std::string find_first_error(const MPI_Comm communicator, const std::string &error)
  {
    const unsigned int rank  = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int none  = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int first = Utilities::MPI::min(error.empty() ? none : rank, communicator);
    return first == none ? "" : Utilities::MPI::broadcast(communicator, error, first);
  }

  void throw_on_all(const MPI_Comm communicator, const std::string &error)
  {
    const std::string first = find_first_error(communicator, error);
    AssertThrow(first.empty(), ExcMessage(first));
  }

  void run_on_all(const MPI_Comm communicator, const std::function<void()> &action)
  {
    throw_on_all(communicator, catch_error(action));
  }
} // namespace caudal
