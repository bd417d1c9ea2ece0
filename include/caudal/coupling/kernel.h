// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_coupling_kernel_h
#define caudal_coupling_kernel_h

#include <caudal/base/plugin.h>

namespace caudal
{
  /**
   * A regularised delta function of one variable: phi(r) with r = (x - X)/h, even, of integral
   * one over r, zero for |r| >= radius. The kernel of the coupling is the product
   * h^-d phi((x-X)/h) phi((y-Y)/h) ..., for each component of the velocity.
   *
   * A kernel may have another factor across a component's direction than along it, see across().
   * A kernel of radius 0 is delta itself: the finite element field is evaluated at the body's
   * points.
   */
  class DeltaKernel : public Plugin
  {
  public:
    /**
     * @p radius: half the width of the support, in lattice spacings h, a multiple of 1/2. The
     * kernel is smooth but for knots at -radius, -radius + 1, ..., radius. @p n_quadrature_points:
     * Gauss points that integrate the product with a quadratic function to round-off between two
     * knots.
     */
    DeltaKernel(const double radius, const unsigned int n_quadrature_points)
        : radius(radius)
        , n_quadrature_points(n_quadrature_points)
    {}

    const double       radius;
    const unsigned int n_quadrature_points;

    /** phi(r) [-] */
    virtual double value(double r) const = 0;

    /** The factor in the directions across that of the velocity's component. */
    virtual const DeltaKernel &across() const
    {
      return *this;
    }

    /** Whether the factor is the same in all directions. */
    bool is_isotropic() const
    {
      return &across() == this;
    }
  };
} // namespace caudal

#endif
