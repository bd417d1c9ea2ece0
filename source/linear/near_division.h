// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_source_linear_near_division_h
#define caudal_source_linear_near_division_h

#include <caudal/linear/near_system.h>

namespace caudal
{
  /**
   * Who does what of a NearSystem. The multipliers q and the force densities f are divided into
   * slices of equal numbers across the axis along which they reach farthest, a slice for each rank
   * from 0 on. Slices of less than @p smallest unknowns would be little more than their
   * interfaces; then the last ranks have none. What else a body has is with the rank that has most
   * of its forces. The same on all ranks, given the same positions.
   */
  struct NearDivision
  {
    NearDivision(const NearMatrices &matrices, unsigned int smallest, MPI_Comm communicator);

    /** Of the unknowns q and f, numbered slice by slice. */
    dealii::IndexSet owned;
    /** Their numbers; for x that are no force density -1. */
    std::vector<int>  place_of_q, place_of_x;
    std::vector<bool> is_force; // by the number
    std::vector<int>  own_q;
    /** Bodies that this rank has but for their forces. */
    std::vector<unsigned int> own_bodies;
  };
} // namespace caudal

#endif
