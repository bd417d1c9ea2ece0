#ifndef caudal_io_log_h
#define caudal_io_log_h

#include <deal.II/base/mpi.h>

#include <fstream>
#include <memory>
#include <ostream>
#include <string>

namespace caudal
{
  /** The linear algebra library that serves the calls to dgemm: its name and a verdict. */
  std::string get_blas();

  /**
   * Text for the user: rank 0 writes it to the terminal and to a file, the other
   * ranks write nothing. On a terminal each new line first clears what stands
   * there, so that a message replaces the progress line.
   */
  class Log
  {
  public:
    /** @p file is emptied, or continued if @p append. Rank 0 alone opens it. */
    Log(const std::string &file, MPI_Comm communicator, bool append = false);
    ~Log();

    /** From here on the terminal gets nothing, or warnings only; the file gets all. */
    void keep_from_terminal(bool but_for_warnings);

    /** Writes versions, machine and linear algebra library. */
    void print_banner();

    /** The stream behind this object, for functions that want one. */
    std::ostream &get_stream()
    {
      return *stream;
    }

    template <typename T>
    Log &operator<<(const T &value)
    {
      *stream << value;
      return *this;
    }

    /** For std::endl and other manipulators. */
    Log &operator<<(std::ostream &(*manipulator)(std::ostream &))
    {
      *stream << manipulator;
      return *this;
    }

  private:
    class Buffer;

    const MPI_Comm                communicator;
    std::ofstream                 file;
    std::unique_ptr<Buffer>       buffer; // none on the other ranks
    std::unique_ptr<std::ostream> stream;
  };
} // namespace caudal

#endif
