// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_types_h
#define caudal_base_types_h

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace caudal
{
  /** A fluid field, distributed over the ranks. */
  using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /**
   * target := source, layout included. The assignment operator keeps the ghost
   * layout of the target if both vectors have the same owned range, as it can
   * happen by chance after an adaptation of the grid; the ghost entries would
   * then be those of the old grid.
   */
  inline void copy_with_layout(const FieldVector &source, FieldVector &target)
  {
    target.reinit(source, /*omit_zeroing_entries=*/true);
    target = source;
  }

  /** Several of them: the unknowns of a coupled linear system. */
  using BlockFieldVector = dealii::LinearAlgebra::distributed::BlockVector<double>;
} // namespace caudal

#endif
