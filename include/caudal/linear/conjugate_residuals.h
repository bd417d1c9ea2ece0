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

  /** What is left of a new image w when the earlier ones are subtracted. */
  struct NewImage
  {
    double norm             = 0; // zero if only round-off is left
    double residual_product = 0; // (r, w)
  };

  /**
   * Makes the last of @p images, w, orthogonal to the others, which are so to each other and of
   * length 1, and subtracts the same multiples of the other @p directions from the last of them.
   * The residual r has no part in the other images. By classical Gram-Schmidt, with one reduction
   * for all products; once more where w loses nine tenths of its length, which would leave it
   * oblique by round-off (Daniel, Gragg, Kaufman & Stewart 1976,
   * doi:10.1090/S0025-5718-1976-0431641-8). Collective.
   */
  template <typename VectorType>
  NewImage make_last_orthogonal(std::deque<VectorType> &directions, std::deque<VectorType> &images,
                                const VectorType &residual)
  {
    const unsigned int              n_earlier = images.size() - 1;
    std::vector<const VectorType *> factors{&residual};
    for (const VectorType &image : images)
      factors.push_back(&image);
    VectorType &z = directions.back(), &w = images.back();
    for (unsigned int pass = 0; pass < 2; ++pass)
    {
      const std::vector<double> products = compute_inner_products(factors, w);
      double                    square   = products.back();
      for (unsigned int k = 0; k < n_earlier; ++k)
      {
        const double projection = products[k + 1];
        w.add(-projection, images[k]);
        z.add(-projection, directions[k]);
        square -= projection * projection;
      }
      if (square > 0.01 * products.back())
        return {std::sqrt(square), products.front()};
    }
    return {};
  }

  /**
   * Solves A x = b from x = 0 by generalised conjugate residuals with the preconditioner P on
   * the right (Eisenstat, Elman & Schultz 1983, doi:10.1137/0720023):
   *   z = P r,  w = A z made orthogonal to all earlier w,  x += (r, w) z,  r -= (r, w) w
   * with |w| = 1, until |r| <= @p tolerance or after @p n_most iterations. The iterates are those
   * of FGMRES; but each iteration costs one preconditioner, two reductions over the ranks, and
   * knows its residual, where deal.II's SolverFGMRES and SolverRichardson apply P once more before
   * they look at it. That is the most expensive thing here, as two iterations do.
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
      const NewImage image = make_last_orthogonal(directions, images, residual);
      if (image.norm == 0)
        break; // nothing new: A is singular, or the limit of the arithmetic is reached
      w /= image.norm;
      z /= image.norm;
      const double length = image.residual_product / image.norm;
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
