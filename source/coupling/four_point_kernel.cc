// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/kernel.h>

#include <cmath>

namespace caudal
{
  namespace
  {
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

    const Registration<DeltaKernel, FourPointKernel>
        registration("four-point", "Peskin's of 2002, four points wide");
  } // namespace
} // namespace caudal
