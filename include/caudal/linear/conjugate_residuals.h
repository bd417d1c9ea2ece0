// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_conjugate_residuals_h
#define caudal_linear_conjugate_residuals_h

#include <caudal/linear/inner_products.h>

#include <cmath>
#include <deque>
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
   * Makes the last of @p images, w, orthogonal to the others, which are so to each other and of
   * length 1, and subtracts the same multiples of the other @p directions from the last of them.
   * Returns the length of w, or zero if only round-off is left. By classical Gram-Schmidt, with one
   * reduction for all products; once more where w loses nine tenths of its length, which would
   * leave it oblique by round-off (Daniel, Gragg, Kaufman & Stewart 1976,
   * doi:10.1090/S0025-5718-1976-0431641-8). Collective.
   */
  template <typename VectorType>
  double make_last_orthogonal(std::deque<VectorType> &directions, std::deque<VectorType> &images)
  {
    VectorType &z = directions.back(), &w = images.back();
    double      first_length = 0, length = 0;
    for (unsigned int pass = 0; pass < 2; ++pass)
    {
      const std::vector<double> products   = compute_inner_products(images, w);
      const double              old_length = std::sqrt(products.back());
      if (pass == 0)
        first_length = old_length;
      for (unsigned int k = 0; k + 1 < images.size(); ++k)
      {
        w.add(-products[k], images[k]);
        z.add(-products[k], directions[k]);
      }
      length = w.l2_norm();
      if (length > 0.1 * old_length)
        break;
    }
    return length > 1e-14 * first_length ? length : 0;
  }

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
    // No vector is copied: a copy of a distributed block vector compares layouts over all ranks.
    std::deque<VectorType> directions, images;
    VectorType             residual;
    residual.reinit(b, true);
    residual.equ(1, b);
    IterationResult result;
    x                = 0;
    result.residual  = residual.l2_norm();
    result.converged = result.residual <= tolerance;
    while (!result.converged && result.n_iterations < n_most)
    {
      VectorType &z = directions.emplace_back(), &w = images.emplace_back();
      z.reinit(b, true);
      w.reinit(b, true);
      P.vmult(z, residual);
      A.vmult(w, z);
      const double norm = make_last_orthogonal(directions, images);
      if (norm == 0)
        break; // nothing new: A is singular, or the limit of the arithmetic is reached
      w /= norm;
      z /= norm;
      const double length = residual * w;
      x.add(length, z);
      residual.add(-length, w);
      ++result.n_iterations;
      result.residual  = residual.l2_norm();
      result.converged = result.residual <= tolerance;
    }
    return result;
  }
} // namespace caudal

#endif
