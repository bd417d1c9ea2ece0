// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_own_parts_h
#define caudal_linear_own_parts_h

#include <caudal/linear/multifrontal.h>

#include <mpi.h>

#include <map>

namespace caudal
{
  /**
   * This rank's parts of a matrix after an exchange between all ranks: each part goes to the lowest
   * one of the ranks of its unknowns. The result does not depend on the order in which messages
   * arrive.
   */
  class OwnParts
  {
  public:
    /** @p rank_of: for each unknown. The values of @p matrix are not copied. Collective. */
    OwnParts(const MatrixParts &matrix, const std::vector<int> &rank_of, MPI_Comm communicator);

    OwnParts(const OwnParts &)            = delete;
    OwnParts &operator=(const OwnParts &) = delete;

    const MatrixParts &get() const
    {
      return parts;
    }

    /** Each unknown becomes new_index[unknown]. */
    void renumber(const std::vector<int> &new_index);

  private:
    /** Elements as (number of unknowns, unknowns), single entries as (single_entry, row, column).
     */
    struct Message
    {
      std::vector<int>    indices;
      std::vector<double> values;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &indices &values;
      }
    };

    MatrixParts                     parts;
    std::vector<int>                unknowns; // of the elements
    std::map<unsigned int, Message> received;

    void add(const ElementMatrix &element);
    void unpack(const Message &message);
  };
} // namespace caudal

#endif
