// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/memory.h>
#include <caudal/base/print.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>

using namespace dealii;

namespace caudal
{
  namespace
  {
    constexpr double kibibyte = 1024.;
    constexpr double no_limit = std::numeric_limits<double>::infinity();

    /** The number behind the word @p name in a file of the kernel; infinite if it is not there. */
    double read_number(const std::string &file, const std::string &name)
    {
      std::ifstream stream(file);
      double        number = 0;
      for (std::string word; stream >> word;)
        if (word == name && stream >> number)
          return number;
      return no_limit;
    }

    double get_free_memory_of_system()
    {
      return read_number("/proc/meminfo", "MemAvailable:") * kibibyte;
    }

    double get_free_memory_of_group()
    {
      double        limit = no_limit, used = 0;
      std::ifstream limit_file("/sys/fs/cgroup/memory.max"),
          used_file("/sys/fs/cgroup/memory.current");
      if (!(limit_file >> limit)) // "max", or there is none
        return no_limit;
      used_file >> used;
      // The cache of files counts as used, and is given back.
      const double cache = read_number("/sys/fs/cgroup/memory.stat", "inactive_file");
      return std::max(0., limit - used + (cache < no_limit ? cache : 0.));
    }

    double get_free_address_space()
    {
      rlimit limit;
      if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return no_limit;
      Utilities::System::MemoryStats used;
      Utilities::System::get_memory_stats(used);
      return std::max(0., limit.rlim_cur - used.VmSize * kibibyte);
    }

    std::string print_size(const double bytes)
    {
      return print_rounded(bytes / (kibibyte * kibibyte * kibibyte)) + " GiB";
    }
  } // namespace

  double get_free_memory(const unsigned int n_processes)
  {
    return std::min({get_free_memory_of_system() / n_processes,
                     get_free_memory_of_group() / n_processes, get_free_address_space()});
  }

  void check_memory(const MPI_Comm communicator, const double need, const std::string &what,
                    const std::string &remedy)
  {
    // The ranks of a machine share its memory.
    MPI_Comm  machine;
    const int error =
        MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    AssertThrowMPI(error);
    const unsigned int n_here = Utilities::MPI::n_mpi_processes(machine);
    MPI_Comm_free(&machine);
    const double free = Utilities::MPI::min(get_free_memory(n_here), communicator) *
                        Utilities::MPI::n_mpi_processes(communicator);
    AssertThrow(need <= free, ExcMessage(what + ", for which at least " + print_size(need) +
                                         " of memory are needed, and " + print_size(free) +
                                         " are free. " + remedy));
  }

  std::string describe_lack_of_memory()
  {
    return "The memory does not suffice; " + print_size(get_free_memory()) +
           " are free. Use a coarser grid (Domain/Levels, Domain/Cells, Refinement/Largest number "
           "of cells; Elements of bodies), a larger limit (ulimit -v) or a larger machine.";
  }
} // namespace caudal
