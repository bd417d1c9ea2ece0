// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_cholesky_h
#define caudal_linear_cholesky_h

#include <caudal/linear/multifrontal.h>

#include <deal.II/lac/vector.h>

#include <memory>

namespace caudal
{
  /**
   * Sparse Cholesky factors of a symmetric positive definite matrix on one rank, by CHOLMOD (Chen,
   * Davis, Hager & Rajamanickam 2008, doi:10.1145/1391989.1391995), ordered by nested dissection.
   */
  class Cholesky
  {
  public:
    Cholesky();
    ~Cholesky();

    /**
     * Factorises the matrix of @p n unknowns; of @p entries those on and below the diagonal are
     * taken. Returns whether it is positive definite; if not, there are no factors.
     */
    bool factorize(unsigned int n, const Triplets &entries);

    /** Replaces @p values by the solution. */
    void solve(dealii::Vector<double> &values) const;

    /** Number of entries of the factor. */
    double get_n_entries() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace caudal

#endif
