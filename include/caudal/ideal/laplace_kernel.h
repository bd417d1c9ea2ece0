#ifndef caudal_ideal_laplace_kernel_h
#define caudal_ideal_laplace_kernel_h

#include <deal.II/base/config.h>

#include <cmath>

namespace caudal::ideal
{
  /** The two kernels of potential theory between a point x and an element of surface at y. */
  struct LaplaceKernel
  {
    double single_layer; ///< G(x,y) = 1/(4 pi |y - x|) [1/m]
    double double_layer; ///< dG/dn_y dS = -(y - x).N/(4 pi |y - x|^3), N = n dS [1/m, N in m^2]
  };

  /** @p r = y - x [m], @p N the element's area times its normal; r must not be zero. */
  inline DEAL_II_ALWAYS_INLINE LaplaceKernel
  evaluate_laplace_kernel(const double rx, const double ry, const double rz, const double Nx,
                          const double Ny, const double Nz)
  {
    constexpr double factor  = 0.079577471545947667884; // 1/(4 pi)
    const double     inverse = 1. / (rx * rx + ry * ry + rz * rz);
    const double     G       = factor * __builtin_sqrt(inverse);
    return {G, -(rx * Nx + ry * Ny + rz * Nz) * inverse * G};
  }
} // namespace caudal::ideal

#endif
