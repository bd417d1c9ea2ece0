// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_cellwise_matrix_h
#define caudal_fluid_cellwise_matrix_h

#include <caudal/base/types.h>
#include <caudal/linear/multifrontal.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

namespace caudal
{
  using namespace dealii;

  /**
   * A sparse matrix that is kept as the matrices of the cells it is the sum of (Hughes, Levit &
   * Winget 1983, doi:10.1016/0045-7825(83)90115-9), with homogeneous constraints resolved in
   * each: an unknown that is constrained has nothing but an entry on the diagonal. A matrix that
   * changes in each step then needs no look-up of places in a global one.
   */
  class CellwiseMatrix
  {
  public:
    /** For the locally owned cells of @p dofs, in their order. All matrices are zero. */
    template <int dim>
    void reinit(const DoFHandler<dim> &dofs, const AffineConstraints<double> &constraints);

    /** Sets the matrix of the locally owned cell number @p cell, without constraints in it. */
    void set(unsigned int cell, const FullMatrix<double> &matrix);

    /** result = A source; updates the ghost entries of @p source. Collective. */
    void vmult(FieldVector &result, const FieldVector &source) const;

    /** Appends this rank's cells. They refer to this object and are valid until it changes. */
    void append_to(MatrixParts &matrix) const;

  private:
    /** What an unknown of a constrained cell stands for: the cell's unknowns times weights. */
    using Resolution = std::vector<std::pair<unsigned int, double>>;

    /** Begins of the cells in the vectors below, and the ends. */
    std::vector<std::size_t> unknowns_begin, constrained_begin, values_begin;
    /** After the constraints are resolved: global indices, and those among this rank's entries. */
    std::vector<int>          unknowns;
    std::vector<unsigned int> local_unknowns;
    /** The unknowns of the cells that are constrained, likewise. */
    std::vector<int>          constrained;
    std::vector<unsigned int> local_constrained;
    std::vector<double>       values;    // row by row
    std::vector<double>       diagonals; // for the constrained unknowns of each cell
    /** For each cell that has constrained unknowns all of its resolutions, else none. */
    std::vector<std::vector<Resolution>> resolutions;
  };
} // namespace caudal

#endif
