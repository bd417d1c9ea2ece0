#ifndef caudal_linear_own_parts_h
#define caudal_linear_own_parts_h

#include <caudal/linear/matrix_parts.h>

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
    MatrixParts                                 parts;
    std::vector<int>                            unknowns; // of the elements
    std::map<unsigned int, std::vector<double>> received_values;

    /** Its unknowns are copied, and found when all are there. */
    void add(const ElementMatrix &element);
    void unpack(const std::vector<int> &indices, const std::vector<double> &values);
  };
} // namespace caudal

#endif
