// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_types_h
#define caudal_base_types_h

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace caudal
{
  /** A fluid field, distributed over the ranks. */
  using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /** Several of them: the unknowns of a coupled linear system. */
  using BlockFieldVector = dealii::LinearAlgebra::distributed::BlockVector<double>;
} // namespace caudal

#endif
