// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_laplace_kernel_h
#define caudal_ideal_laplace_kernel_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace caudal::ideal
{
  using namespace dealii;

  /** Kernels of potential theory between a point x and an element of the surface at y. */
  struct LaplaceKernel
  {
    double single_layer; ///< G(x,y) = 1/(4 pi |y - x|) [1/m]
    double double_layer; ///< dG/dn_y dS = -(y - x).N/(4 pi |y - x|^3), N = n dS [1/m, N in m^2]
  };

  /** @p r = y - x [m], which must not be zero; @p N is the element's area times its normal [m^2].
   */
  inline LaplaceKernel evaluate_laplace_kernel(const Tensor<1, 3> &r, const Tensor<1, 3> &N)
  {
    const double inverse = 1. / r.norm_square();
    const double G       = std::sqrt(inverse) / (4. * numbers::PI);
    return {G, -(r * N) * inverse * G};
  }
} // namespace caudal::ideal

#endif
