// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_cholesky_h
#define caudal_linear_cholesky_h

#include <caudal/linear/triplets.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>

namespace caudal
{
  /**
   * Sparse Cholesky factors P A P^T = L L^T of a symmetric positive definite matrix on one rank, by
   * CHOLMOD (Chen, Davis, Hager & Rajamanickam 2008, doi:10.1145/1391989.1391995), ordered by
   * nested dissection.
   */
  class Cholesky
  {
  public:
    Cholesky();
    ~Cholesky();

    /**
     * Factorises the matrix of @p n unknowns; of @p entries those on and below the diagonal are
     * taken. The last @p n_last unknowns are eliminated last, in their order. Returns whether the
     * matrix is positive definite; if not, there are no factors.
     */
    bool factorize(unsigned int n, const Triplets &entries, unsigned int n_last = 0);

    /** Replaces @p values by the solution. */
    void solve(dealii::Vector<double> &values) const;

    /** Replaces b by L^-1 P b. Of both the last n_last stand at the end. */
    void solve_lower(dealii::Vector<double> &values) const;

    /** Replaces y by P^T L^-T y. */
    void solve_upper(dealii::Vector<double> &values) const;

    /** The last @p n rows and columns of L, at most the n_last of factorize(). */
    dealii::LAPACKFullMatrix<double> extract_last(unsigned int n) const;

    /** Number of entries of the factor. */
    double get_n_entries() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace caudal

#endif
