// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_conjugate_residuals_h
#define caudal_linear_conjugate_residuals_h

#include <vector>

namespace caudal
{
  /** How an iteration ended. */
  struct IterationResult
  {
    unsigned int n_iterations = 0;
    double       residual     = 0;
    bool         converged    = false;
  };

  /**
   * Solves A x = b from x = 0 by generalised conjugate residuals with the preconditioner P on
   * the right (Eisenstat, Elman & Schultz 1983, doi:10.1137/0720023):
   *   z = P r,  w = A z made orthogonal to all earlier w,  x += (r, w) z,  r -= (r, w) w
   * with |w| = 1, until |r| <= @p tolerance or after @p n_most iterations. The iterates are those
   * of FGMRES; but each iteration costs one preconditioner and knows its residual, where deal.II's
   * SolverFGMRES and SolverRichardson apply P once more before they look at it. That is the most
   * expensive thing here, as two iterations do.
   */
  template <typename VectorType, typename Operator, typename Preconditioner>
  IterationResult solve_by_conjugate_residuals(const Operator &A, VectorType &x,
                                               const VectorType &b, const Preconditioner &P,
                                               const double tolerance, const unsigned int n_most)
  {
    std::vector<VectorType> directions, images;
    VectorType              residual(b);
    IterationResult         result;
    x                = 0;
    result.residual  = residual.l2_norm();
    result.converged = result.residual <= tolerance;
    while (!result.converged && result.n_iterations < n_most)
    {
      VectorType z(b), w(b);
      P.vmult(z, residual);
      A.vmult(w, z);
      const double round_off = 1e-14 * w.l2_norm();
      for (unsigned int k = 0; k < images.size(); ++k)
      {
        const double projection = images[k] * w;
        w.add(-projection, images[k]);
        z.add(-projection, directions[k]);
      }
      const double norm = w.l2_norm();
      if (!(norm > round_off))
        break; // nothing new: A is singular, or the limit of the arithmetic is reached
      w /= norm;
      z /= norm;
      const double length = residual * w;
      x.add(length, z);
      residual.add(-length, w);
      directions.push_back(z);
      images.push_back(w);
      ++result.n_iterations;
      result.residual  = residual.l2_norm();
      result.converged = result.residual <= tolerance;
    }
    return result;
  }
} // namespace caudal

#endif
