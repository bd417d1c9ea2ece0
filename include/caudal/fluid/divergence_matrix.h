// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_divergence_matrix_h
#define caudal_fluid_divergence_matrix_h

#include <caudal/base/types.h>
#include <caudal/fluid/fluid_space.h>

namespace caudal
{
  using namespace dealii;

  /**
   * The matrix B of the continuity equation, B_kj = int q_k div v_j dx, with the pressures q_k as
   * rows and the velocities v_j as columns, of which constrained ones are resolved. Pressures are
   * discontinuous: the rows of a cell involve its own velocities only and are kept together.
   */
  class DivergenceMatrix
  {
  public:
    /** To be called after each change of the grid; @p constraints are those of the velocity. */
    template <int dim>
    void reinit(const FluidSpace<dim> &space, const AffineConstraints<double> &constraints);

    /** pressure = B velocity; updates the ghost entries of @p velocity. Collective. */
    void vmult(FieldVector &pressure, const FieldVector &velocity) const;

    /** velocity = B^T pressure. Collective. */
    void Tvmult(FieldVector &velocity, const FieldVector &pressure) const;

    /** velocity += B^T pressure. Collective. */
    void Tvmult_add(FieldVector &velocity, const FieldVector &pressure) const;

  private:
    /** Rows and columns of each cell in turn, as places among this rank's entries. */
    std::vector<unsigned int> rows, columns;
    std::vector<std::size_t>  columns_begin;
    std::vector<double>       values; // cell by cell, row by row
    unsigned int              rows_per_cell = 0;

    /** Calls operation(row, first, last, values) for each row: its place and its columns. */
    template <class Operation>
    void for_each_row(const Operation &operation) const;
  };
} // namespace caudal

#endif
