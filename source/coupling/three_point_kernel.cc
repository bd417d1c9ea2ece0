// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/kernel.h>

#include <cmath>

namespace caudal
{
  namespace
  {
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

    const Registration<DeltaKernel, ThreePointKernel>
        registration("three-point", "that of Roma, Peskin and Berger of 1999");
  } // namespace
} // namespace caudal
