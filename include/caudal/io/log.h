// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_log_h
#define caudal_io_log_h

#include <deal.II/base/mpi.h>

#include <fstream>
#include <memory>
#include <ostream>
#include <string>

namespace caudal
{
  /**
   * Text for the user: rank 0 writes it to the terminal and to a file, the other
   * ranks write nothing. On a terminal each new line first clears what stands
   * there, so that a message replaces the progress line.
   */
  class Log : public std::ostream
  {
  public:
    /** @p file is emptied, or continued if @p append. Rank 0 alone opens it. */
    Log(const std::string &file, MPI_Comm communicator, bool append = false);
    ~Log() override;

    /** From here on the terminal gets nothing, or warnings only; the file gets all. */
    void keep_from_terminal(bool but_for_warnings);

    /** Writes versions, machine and linear algebra library. */
    void print_banner();

    std::ostream &get_stream()
    {
      return *this;
    }

  private:
    class Buffer;

    const MPI_Comm          communicator;
    std::ofstream           file;
    std::unique_ptr<Buffer> buffer; // none on the other ranks
  };
} // namespace caudal

#endif
