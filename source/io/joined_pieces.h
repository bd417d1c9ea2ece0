// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_source_io_joined_pieces_h
#define caudal_source_io_joined_pieces_h

#include <mpi.h>

#include <functional>
#include <string>

namespace caudal
{
  /**
   * Writes one VTU file from what deal.II would write of each rank's cells, @p make_text. Rank 0
   * gets the pieces of the others in small parts, one after the other, and holds none of them;
   * @p get_path is called there. MPI's own parallel output does not tell when the disk is full.
   * What goes wrong on one rank, all throw. Collective.
   */
  void write_joined_pieces(const std::function<std::string()> &get_path,
                           const std::function<std::string()> &make_text, MPI_Comm communicator);
} // namespace caudal

#endif
