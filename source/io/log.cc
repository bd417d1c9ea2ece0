// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/log.h>

#include <caudal/base/version.h>
#include <caudal/io/progress.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <dlfcn.h>

#include <ctime>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <thread>

using namespace dealii;

namespace caudal
{
  namespace
  {
    std::string get_processor()
    {
      std::ifstream file("/proc/cpuinfo");
      for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0)
          return Utilities::trim(line.substr(line.find(':') + 1));
      return "unknown processor";
    }

    /** The number of threads of each call, if the library is OpenBLAS; else 1. */
    unsigned int get_number_of_blas_threads()
    {
      const auto get_number =
          reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
      return get_number != nullptr ? get_number() : 1;
    }

    /** The linear algebra library that serves the calls to dgemm: its name and a verdict. */
    std::string get_blas()
    {
      Dl_info     info;
      void *const dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
      if (dgemm == nullptr || dladdr(dgemm, &info) == 0)
        return "unknown BLAS";

      std::error_code   error;
      const std::string path = std::filesystem::canonical(info.dli_fname, error).string();
      for (const auto &known : {std::pair("openblas", "OpenBLAS"), std::pair("mkl", "Intel MKL"),
                                std::pair("blis", "BLIS"), std::pair("atlas", "ATLAS")})
        if (path.find(known.first) != std::string::npos)
          return std::string(known.second) + " (" + path + ")";
      if (path.find("/blas/libblas") != std::string::npos)
        return "reference BLAS: slow, install libopenblas0 (" + path + ")";
      return path;
    }
  } // namespace

  /** What the terminal gets of the text. */
  enum class Shown
  {
    all,
    warnings,
    nothing
  };

  /** Writes to the file and, what is to be shown, to the terminal. */
  class Log::Buffer : public std::streambuf
  {
  public:
    Buffer(std::streambuf *terminal, std::streambuf *file)
        : terminal(terminal)
        , file(file)
        , clears_line(is_terminal())
    {}

    Shown shown = Shown::all;

  private:
    int_type overflow(const int_type character) override
    {
      if (traits_type::eq_int_type(character, traits_type::eof()))
        return traits_type::not_eof(character);
      const char c = traits_type::to_char_type(character);
      if (shown != Shown::all)
      {
        line += c;
        if (c == '\n' && shown == Shown::warnings && line.rfind("Warning", 0) == 0)
          terminal->sputn(line.data(), line.size());
        if (c == '\n')
          line.clear();
        return file->sputc(c);
      }
      if (is_at_start && clears_line)
        terminal->sputn("\033[K", 3);
      is_at_start = (c == '\n');
      terminal->sputc(c); // which may be closed: the file goes on
      return file->sputc(c);
    }

    int sync() override
    {
      terminal->pubsync();
      return file->pubsync();
    }

    std::streambuf *const terminal;
    std::streambuf *const file;
    const bool            clears_line;
    bool                  is_at_start = true;
    std::string           line; // that is not shown yet
  };

  Log::Log(const std::string &name, const MPI_Comm communicator, const bool append)
      : std::ostream(nullptr)
      , communicator(communicator)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      file.open(name, append ? std::ios::app : std::ios::trunc);
      AssertThrow(file.is_open(), ExcMessage("The log file <" + name + "> can't be written."));
      buffer = std::make_unique<Buffer>(std::cout.rdbuf(), file.rdbuf());
      rdbuf(buffer.get());
    }
  }

  Log::~Log()
  {
    flush();
  }

  void Log::keep_from_terminal(const bool but_for_warnings)
  {
    if (buffer)
      buffer->shown = but_for_warnings ? Shown::warnings : Shown::nothing;
  }

  void Log::print_banner()
  {
    const unsigned int n_ranks   = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int n_threads = get_number_of_blas_threads();
    const unsigned int n_cores   = std::max(1u, std::thread::hardware_concurrency());
    const std::time_t  now       = std::time(nullptr);

    *this << get_version() << ", " << std::put_time(std::localtime(&now), "%F %T %z")
          << "\n  on     " << Utilities::System::get_hostname() << ", " << n_cores << " x "
          << get_processor() << "\n  with   deal.II " << DEAL_II_PACKAGE_VERSION << ", " << n_ranks
          << (n_ranks == 1 ? " rank" : " ranks") << "\n  BLAS   " << get_blas() << ", " << n_threads
          << (n_threads == 1 ? " thread a rank" : " threads a rank");
    if (n_ranks > 1 && n_ranks * n_threads > n_cores)
      *this << "\n  Ranks and BLAS threads together exceed the cores, which is slow: "
               "set OPENBLAS_NUM_THREADS=1.";
    *this << "\n" << std::endl;
  }
} // namespace caudal
