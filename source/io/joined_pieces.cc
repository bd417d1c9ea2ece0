// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joined_pieces.h"

#include <caudal/base/collective.h>
#include <caudal/base/safe_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <memory>
#include <vector>

using namespace dealii;

namespace caudal
{
  namespace
  {
    constexpr std::size_t most_at_once = 1 << 24; // bytes

    /** A rank's cells in a VTU file, and what stands before and behind them. */
    struct Piece
    {
      std::string cells, before, behind;

      bool is_empty() const
      {
        return cells.find("NumberOfPoints=\"0\"") < cells.find('>');
      }
    };

    Piece split(const std::string &text)
    {
      const std::string end   = "</Piece>\n";
      const std::size_t first = text.find("<Piece"), last = text.rfind(end) + end.size();
      Assert(first != std::string::npos && last > first, ExcInternalError());
      return {text.substr(first, last - first), text.substr(0, first), text.substr(last)};
    }

    /** Sends the text to rank 0, whose take_over() gets it. */
    void hand_over(const std::string &text, const MPI_Comm communicator)
    {
      for (std::size_t begin = 0, n = 1; n > 0; begin += n) // the last part is empty
      {
        n               = std::min(most_at_once, text.size() - begin);
        const int error = MPI_Send(text.data() + begin, n, MPI_CHAR, 0, 0, communicator);
        AssertThrowMPI(error);
      }
    }

    void take_over(const unsigned int rank, std::vector<char> &buffer, const MPI_Comm communicator,
                   const std::function<void(std::size_t)> &write)
    {
      for (int n = 1; n > 0;)
      {
        MPI_Status status;
        int        error =
            MPI_Recv(buffer.data(), buffer.size(), MPI_CHAR, rank, 0, communicator, &status);
        AssertThrowMPI(error);
        error = MPI_Get_count(&status, MPI_CHAR, &n);
        AssertThrowMPI(error);
        write(n);
      }
    }
  } // namespace

  void write_joined_pieces(const std::function<std::string()> &get_path,
                           const std::function<std::string()> &make_text,
                           const MPI_Comm                      communicator)
  {
    const unsigned int        rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int        n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    Piece                     own;
    std::vector<char>         buffer;
    std::unique_ptr<SafeFile> file;
    run_on_all(communicator, [&]() {
      own = split(make_text());
      if (rank == 0)
      {
        buffer.resize(n_ranks > 1 ? most_at_once : 0);
        file = std::make_unique<SafeFile>(get_path());
      }
    });
    // A rank without cells has an empty piece, and knows less to say before it.
    const unsigned int first =
        Utilities::MPI::min(own.is_empty() ? n_ranks : rank, communicator) % n_ranks;
    const std::string before = Utilities::MPI::broadcast(communicator, own.before, first);
    if (own.is_empty() && rank != first)
      own.cells.clear();

    std::string error;
    if (rank > 0)
      hand_over(own.cells, communicator);
    else
    {
      const auto write = [&](const char *const begin, const std::size_t n) {
        if (error.empty())
          error = catch_error([&]() { file->write(begin, n); });
      };
      write(before.data(), before.size());
      write(own.cells.data(), own.cells.size());
      for (unsigned int other = 1; other < n_ranks; ++other)
        take_over(other, buffer, communicator,
                  [&](const std::size_t n) { write(buffer.data(), n); });
      write(own.behind.data(), own.behind.size());
      if (error.empty())
        error = catch_error([&]() { file->finish(); });
    }
    throw_on_all(communicator, error);
  }
} // namespace caudal
