// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/kernel.h>

#include <limits>

namespace caudal
{
  namespace
  {
    /** The variational limit of the other kernels. */
    class DiracKernel : public DeltaKernel
    {
    public:
      DiracKernel()
          : DeltaKernel(0., 0)
      {}

      double value(const double r) const override
      {
        return r == 0. ? std::numeric_limits<double>::infinity() : 0.;
      }
    };

    const Registration<DeltaKernel, DiracKernel>
        registration("dirac", "the variational limit, the finite element field at the body's "
                              "points");
  } // namespace
} // namespace caudal
