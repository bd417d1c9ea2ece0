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
   * Winget 1983, doi:10.1016/0045-7825(83)90115-9):
   *   A = sum_c R_c^T (L + C_c x I) R_c,
   * L that of the cell's refinement level, C_c a scalar matrix of the cell alone, which acts on
   * each component, and R_c what the cell's unknowns stand for after homogeneous constraints. An
   * unknown that is constrained has nothing but, in a square matrix, an entry on the diagonal.
   * Products take many cells of a level at once, and a cell stores no more than C_c: in 3D a tenth
   * of its matrix.
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

    /** Sets the matrices L of all levels, unknowns numbered as by the finite elements. */
    void set_level_matrices(std::vector<FullMatrix<double>> matrices);

    /** Sets C of the locally owned cell number @p cell of a square matrix; at first it is 0. */
    void set_scalar_matrix(unsigned int cell, const FullMatrix<double> &matrix);

    /** Sets all C to 0. */
    void clear_scalar_matrices();

    /** result = A source; updates the ghost entries of @p source. Collective. */
    void vmult(FieldVector &result, const FieldVector &source) const;

    /** result += A^T source, of a matrix that is not square. Collective. */
    void Tvmult_add(FieldVector &result, const FieldVector &source) const;

    /** Of a square matrix: all, or L alone, which cells have in common. */
    enum class Parts
    {
      all,
      of_levels
    };

    /** result += the diagonal of a square matrix. Collective. */
    void add_diagonal(FieldVector &result, Parts parts = Parts::all) const;

    /**
     * result += the diagonal of the sum of A_c^T W_c A_c, A_c the matrix of the cell c, for a
     * matrix that is not square, with @p weights W_c of the cells in their order. Collective.
     */
    void add_diagonal_of_squares(const std::vector<const FullMatrix<double> *> &weights,
                                 FieldVector                                   &result) const;

    /** This rank's entries of a matrix that is not square: global rows and columns. */
    Triplets to_triplets() const;

    /** Appends this rank's cells of a square matrix. They are valid until reinit(). */
    void append_to(MatrixParts &matrix) const;

  private:
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

      /** R_c source and result += R_c^T values, with @p values component by component. */
      void gather(unsigned int cell, const double *source, double *values) const;
      void scatter(unsigned int cell, const double *values, double *result) const;

      bool is_constrained(const unsigned int cell) const
      {
        return constrained.n(cell) > 0;
      }

      /** Calls operation(place among those left, weight) for what unknown @p i stands for. */
      template <typename Operation>
      void for_each_left(unsigned int cell, unsigned int i, const Operation &operation) const;

      unsigned int n_per_cell, n_components;
      /** The place of an unknown of the element in an order component by component. */
      std::vector<unsigned int> places;
      /** Unknowns that are left after the constraints are resolved, and constrained ones. */
      CellIndices left, constrained;
      /** First entries of R_c, for each unknown of the cells with constrained ones; of those the
       * place among the unknowns that are left, and the weight. */
      std::vector<std::size_t>                     first_resolution; // of the cells
      std::vector<std::size_t>                     resolution_begins{0};
      std::vector<std::pair<unsigned int, double>> resolutions;
    };

    std::shared_ptr<const Unknowns> rows, columns; // the same if the matrix is square
    std::vector<unsigned int>       level_begins;  // first cells of the levels, and the end
    std::vector<FullMatrix<double>> level_matrices, level_matrices_by_component;
    std::vector<double>             scalar_matrices; // transposed, row by row; none or of all cells

    unsigned int n_scalar() const
    {
      return columns->n_per_cell / columns->n_components;
    }
    template <int dim>
    void count_levels(const DoFHandler<dim> &dofs);

    /** Calls operation(level, first cell, number of cells) for blocks of cells of a level. */
    template <typename Operation>
    void for_each_block(const Operation &operation) const;

    /** result += (C_c x I) source */
    void add_scalar_product(unsigned int cell, const double *source, double *result) const;

    /** (L + C_c x I) of the cell, unknowns numbered as by the element. */
    void get_cell_matrix(unsigned int level, unsigned int cell, FullMatrix<double> &matrix) const;

    /** R_c^T matrix R_c, for the unknowns that are left, row by row; added to @p values. */
    void resolve(unsigned int cell, const FullMatrix<double> &matrix, double *values) const;

    /** Calls operation(cell, values) with the resolved matrices of all cells, row by row. */
    template <typename Operation>
    void for_each_resolved(const Operation &operation) const;

    /** The diagonal entry of unknown @p i of the element in (L + C_c x I), or in L. */
    double get_diagonal_entry(unsigned int level, unsigned int cell, unsigned int i,
                              Parts parts) const;

    /** The entry on the diagonal for constrained unknowns of the cell. */
    double get_constrained_entry(unsigned int level, unsigned int cell, Parts parts) const;
  };
} // namespace caudal

#endif
