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
   * each: an unknown that is constrained has nothing but, in a square matrix, an entry on the
   * diagonal. A matrix that changes in each step then needs no look-up of places in a global one.
   */
  class CellwiseMatrix
  {
  public:
    /** A square matrix of zeros for the locally owned cells of @p dofs, in their order. */
    template <int dim>
    void reinit(const DoFHandler<dim> &dofs, const AffineConstraints<double> &constraints);

    /** A matrix whose rows are the unknowns of another space on this grid, without constraints. */
    template <int dim>
    void reinit(const DoFHandler<dim> &row_dofs, const DoFHandler<dim> &dofs,
                const AffineConstraints<double> &constraints);

    /** Sets the matrix of the locally owned cell number @p cell, without constraints in it. */
    void set(unsigned int cell, const FullMatrix<double> &matrix);

    /** result = A source; updates the ghost entries of @p source. Collective. */
    void vmult(FieldVector &result, const FieldVector &source) const;

    /** result += A^T source, of a matrix that is not square. Collective. */
    void Tvmult_add(FieldVector &result, const FieldVector &source) const;

    /** result += the diagonal of a square matrix. Collective. */
    void add_diagonal(FieldVector &result) const;

    /**
     * result += the diagonal of the sum of A_c^T W_c A_c, A_c the matrix of the cell c, for a
     * matrix that is not square, with @p weights W_c of the cells in their order. Collective.
     */
    void add_diagonal_of_squares(const std::vector<const FullMatrix<double> *> &weights,
                                 FieldVector                                   &result) const;

    /** This rank's entries of a matrix that is not square: global rows and columns. */
    Triplets to_triplets() const;

    /** Appends this rank's cells. They refer to this object and are valid until it changes. */
    void append_to(MatrixParts &matrix) const;

  private:
    /** What an unknown of a cell stands for: those that are left in the cell, times weights. */
    using Resolution = std::vector<std::pair<unsigned int, double>>;

    /** Indices of some unknowns of each cell: global ones, and those among this rank's entries. */
    struct CellIndices
    {
      std::vector<std::size_t>  begins{0}; // of the cells, and the end
      std::vector<int>          global;
      std::vector<unsigned int> local;

      unsigned int n(const unsigned int cell) const
      {
        return begins[cell + 1] - begins[cell];
      }
    };

    /** The unknowns of a space, cell by cell. */
    struct Unknowns
    {
      template <int dim>
      Unknowns(const DoFHandler<dim> &dofs, const AffineConstraints<double> &constraints);

      /** Unknowns that are left after the constraints are resolved, and constrained ones. */
      CellIndices left, constrained;
      /** Resolutions of all unknowns of a cell of which some are constrained; else none. */
      std::vector<std::vector<Resolution>> resolutions;
    };

    std::shared_ptr<const Unknowns> rows, columns; // the same if the matrix is square
    std::vector<std::size_t>        begins;        // of the cells' values
    std::vector<double>             values;        // row by row
    std::vector<double>             diagonals;     // for the constrained unknowns of each cell

    void allocate();
  };
} // namespace caudal

#endif
