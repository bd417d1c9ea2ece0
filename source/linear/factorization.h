// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_factorization_h
#define caudal_linear_factorization_h

#include "front.h"

#include <deal.II/base/aligned_vector.h>

namespace caudal
{
  /**
   * Multifrontal LU factorisation of a matrix on one rank, D A D = L U with a diagonal D for which
   * entries are up to about one; rows are exchanged within the pivots of a front. The last
   * unknowns may be kept out of the elimination; their system is solved by the caller between
   * condense() and expand().
   */
  class Factorization
  {
  public:
    /**
     * Orders and factorises @p matrix, with the groups and the kept unknowns of
     * EliminationTree::update(). Returns whether the pivots are sound; if not, there are no
     * factors.
     */
    bool compute(const std::vector<int> &group_begins, const MatrixParts &matrix,
                 unsigned int n_kept);

    /** S = A_kk - A_ki A_ii^-1 A_ik of the eliminated unknowns i and the kept ones k, row by row.
     */
    const std::vector<double> &get_schur_complement() const
    {
      return schur_complement;
    }

    /**
     * Replaces the kept part of @p vector by b_k - A_ki A_ii^-1 b_i, the other one by what
     * expand() needs.
     */
    void condense(std::vector<double> &vector);

    /** Replaces @p vector of condense(), which got the kept part of the solution, by all of it. */
    void expand(std::vector<double> &vector);

    /** Entries of the factors. */
    double get_n_entries() const
    {
      return factors.size();
    }
    /** Operations for the factors. */
    double get_n_operations() const;

    unsigned int get_n_orderings() const
    {
      return n_orderings;
    }

  private:
    EliminationTree tree;
    unsigned int    n_eliminated = 0, n_orderings = 0;

    std::vector<double> scales; // the diagonal of D

    /** Begins of the fronts' factors and row exchanges. */
    std::vector<std::size_t>      factor_begins, exchange_begins;
    dealii::AlignedVector<double> factors;
    std::vector<int>              exchanges;
    std::vector<double>           schur_complement;

    /** Work space: what fronts leave for their parents, and where that of each begins. */
    dealii::AlignedVector<double> updates;
    std::vector<std::size_t>      update_begins;

    void compute_scales(const MatrixParts &matrix, unsigned int n);
    void lay_out_factors();
    void lay_out_updates();
    bool eliminate(const MatrixParts &matrix);

    /** Factors of front number @p f. */
    FrontFactors get_factors(std::size_t f);
  };
} // namespace caudal

#endif
