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

    const Registration<DeltaKernel, CosineKernel> registration("cosine", "(1 + cos(pi r/2))/4");
  } // namespace
} // namespace caudal
