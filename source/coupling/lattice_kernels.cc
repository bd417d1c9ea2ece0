// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/kernel.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** (1 + cos(pi r/2))/4: Peskin, J. Comput. Phys. 25, 1977, doi:10.1016/0021-9991(77)90100-0. */
    class CosineKernel : public DeltaKernel
    {
    public:
      CosineKernel()
          : DeltaKernel(2., 8)
      {}

      double value(const double r) const override
      {
        return std::abs(r) < 2. ? 0.25 * (1. + std::cos(0.5 * numbers::PI * r)) : 0.;
      }
    };

    /** Roma, Peskin and Berger, J. Comput. Phys. 153, 1999, doi:10.1006/jcph.1999.6293. */
    class ThreePointKernel : public DeltaKernel
    {
    public:
      ThreePointKernel()
          : DeltaKernel(1.5, 20) // the roots have branch points 0.08 beyond the knots
      {}

      double value(const double r) const override
      {
        const double a = std::abs(r);
        if (a >= 1.5)
          return 0.;
        if (a <= 0.5)
          return (1. + std::sqrt(1. - 3. * a * a)) / 3.;
        return (5. - 3. * a - std::sqrt(1. - 3. * (1. - a) * (1. - a))) / 6.;
      }
    };

    /** Peskin, Acta Numerica 11, 2002, doi:10.1017/S0962492902000077. */
    class FourPointKernel : public DeltaKernel
    {
    public:
      FourPointKernel()
          : DeltaKernel(2., 20) // the roots have branch points 0.2 beyond the knots
      {}

      double value(const double r) const override
      {
        const double a = std::abs(r);
        if (a >= 2.)
          return 0.;
        if (a <= 1.)
          return 0.125 * (3. - 2. * a + std::sqrt(1. + 4. * a - 4. * a * a));
        return 0.125 * (5. - 2. * a - std::sqrt(-7. + 12. * a - 4. * a * a));
      }
    };

    const Registration<DeltaKernel, CosineKernel> cosine("cosine", "(1 + cos(pi r/2))/4");
    const Registration<DeltaKernel, ThreePointKernel>
        three_point("three-point", "that of Roma, Peskin and Berger of 1999");
    const Registration<DeltaKernel, FourPointKernel>
        four_point("four-point", "Peskin's of 2002, four points wide");
  } // namespace
} // namespace caudal
