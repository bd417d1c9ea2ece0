// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/kernel.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** The cardinal B-spline of order k, degree k - 1: the k-fold convolution of the unit box. */
    template <unsigned int order>
    class BSplineKernel : public DeltaKernel
    {
    public:
      BSplineKernel()
          : DeltaKernel(0.5 * order, (order + 3) / 2) // for the degree order - 1, times quadratics
      {}

      /**
       * sum_j (-1)^j binomial(k,j) (y-j)_+^(k-1)/(k-1)!, with the distance y from
       * the nearer end of the support: few terms and no cancellation.
       */
      double value(const double r) const override
      {
        const double y           = radius - std::abs(r);
        double       sum         = 0.;
        double       coefficient = 1.;
        for (unsigned int j = 0; j < y; ++j)
        {
          sum += coefficient * power(y - j);
          coefficient *= -static_cast<double>(order - j) / (j + 1);
        }
        return sum;
      }

    private:
      /** x^(k-1)/(k-1)! */
      static double power(const double x)
      {
        double product = 1.;
        for (unsigned int i = 1; i < order; ++i)
          product *= x / i;
        return product;
      }
    };

    /**
     * B_(k+1) along and B_k across the component's direction. Since
     * B_(k+1)'(r) = B_k(r + 1/2) - B_k(r - 1/2), a field whose component i is
     * sampled on a lattice shifted by h/2 in direction i (staggered, MAC) and is
     * discretely divergence free there is interpolated to one that is divergence
     * free at every point (Gruninger and Griffith, J. Comput. Phys. 546, 2025,
     * doi:10.1016/j.jcp.2025.114472). With finite elements they have no such property: the
     * convolution of a divergence-free field is so if the kernel is the same for all components.
     */
    template <unsigned int order_along>
    class CompositeBSplineKernel : public BSplineKernel<order_along>
    {
    public:
      const DeltaKernel &across() const override
      {
        return lower;
      }

    private:
      const BSplineKernel<order_along - 1> lower{};
    };

    const Registration<DeltaKernel, BSplineKernel<2>> hat("hat", "piecewise linear");
    const Registration<DeltaKernel, BSplineKernel<3>> order_3("B-spline 3", "piecewise quadratic");
    const Registration<DeltaKernel, BSplineKernel<4>> order_4("B-spline 4", "piecewise cubic");
    const Registration<DeltaKernel, BSplineKernel<5>> order_5("B-spline 5", "of fourth degree");
    const Registration<DeltaKernel, BSplineKernel<6>> order_6("B-spline 6", "of fifth degree");

    const Registration<DeltaKernel, CompositeBSplineKernel<3>>
        composite_32("composite B-spline 32", "order 3 along the velocity's component, 2 across");
    const Registration<DeltaKernel, CompositeBSplineKernel<4>>
        composite_43("composite B-spline 43", "order 4 along the velocity's component, 3 across");
    const Registration<DeltaKernel, CompositeBSplineKernel<5>>
        composite_54("composite B-spline 54", "order 5 along the velocity's component, 4 across");
  } // namespace
} // namespace caudal
