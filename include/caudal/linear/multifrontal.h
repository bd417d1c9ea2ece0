// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_multifrontal_h
#define caudal_linear_multifrontal_h

#include <caudal/linear/triplets.h>

#include <deal.II/lac/la_parallel_block_vector.h>

#include <memory>
#include <vector>

namespace caudal
{
  /** Dense matrix that couples some unknowns with each other; non-owning. */
  struct ElementMatrix
  {
    int           n;
    const int    *unknowns;
    const double *values; // row by row

    std::size_t n_entries() const
    {
      return static_cast<std::size_t>(n) * n;
    }
  };

  /** Sparse matrix, or a rank's part of one, as a sum that is never assembled. */
  struct MatrixParts
  {
    std::vector<ElementMatrix> elements;
    Triplets                   entries;
    /** Values of elements that nobody else keeps. */
    std::vector<std::vector<double>> storage{};

    Triplets to_triplets() const;
  };

  /**
   * Sparse direct solver of all ranks for unsymmetric matrices with a symmetric pattern. Each rank
   * eliminates the unknowns that no other rank's entries touch by the multifrontal method (Duff &
   * Reid 1983, doi:10.1145/356044.356047); the Schur complements
   *   S = A_kk - A_ki A_ii^-1 A_ik
   * that they leave for the unknowns k between the ranks add up to a dense matrix, which each rank
   * factorises (substructuring: Przemieniecki 1963, doi:10.2514/3.1728). Rows are exchanged within
   * a front only; pivoting beyond that is left to UMFPACK, and that only on request.
   *
   * The factors are a function of the positions, the groups and the matrix, bit by bit: neither the
   * order in which messages arrive nor what was factorised before has an influence. The ordering
   * is reused while the pattern is exactly the same. Member functions are collective.
   */
  class MultifrontalSolver
  {
  public:
    explicit MultifrontalSolver(MPI_Comm communicator);
    ~MultifrontalSolver();

    /**
     * Divides the unknowns among the ranks by @p positions, along some line: each rank gives those
     * of its unknowns, and all ranks' together are those of the first unknowns. The others, such
     * as those of immersed bodies, go to where their neighbours are; they have no elements.
     * Forgets the factors.
     */
    void set_positions(const std::vector<double> &positions);

    /**
     * Orders and factorises the sum of all ranks' @p parts (indices from 0). Groups of consecutive
     * unknowns, such as the components of a velocity, are eliminated together: @p group_begins has
     * their first unknowns, and behind them the number of all unknowns. Unknowns of a group have
     * one position, or none. Returns whether the pivots are sound; if not, there are no factors,
     * and other groups may do better. Throws if the dense matrix between the ranks is singular.
     */
    bool factorize(const std::vector<int> &group_begins, const MatrixParts &parts);

    /**
     * Factorises a matrix of @p n unknowns on rank 0 with pivots from all rows, by UMFPACK (Davis
     * 2004, doi:10.1145/992200.992206): 5 to 20 times slower. Throws if the matrix is singular.
     */
    void factorize_with_pivoting(unsigned int n, const MatrixParts &parts);

    /** Replaces @p vector by the solution: the unknowns block by block and rank by rank. */
    void solve(dealii::LinearAlgebra::distributed::BlockVector<double> &vector) const;

    /** Forgets the factors. */
    void clear();

    bool is_factorized() const;

    /** Number of entries of the factors, over all ranks (0 for those of UMFPACK). */
    double get_factor_entries() const;

    /** Number of factorisations of this rank that needed a new ordering. */
    unsigned int get_n_orderings() const;

    /**
     * Cost of the factorisation in operations for an entry of the factors: in units of a solution,
     * up to a constant. Estimated, so that equal matrices give equal numbers.
     */
    double get_factorisation_cost() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace caudal

#endif
