// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/flow_quantity.h>

#include <deal.II/base/symmetric_tensor.h>

namespace caudal
{
  namespace
  {
    /**
     * The second invariant of the velocity's gradient in an incompressible flow,
     *   Q = 1/2 (|W|^2 - |S|^2) [1/s^2],
     * S and W being its symmetric and its skew part (Hunt, Wray & Moin 1988, Eddies, streams, and
     * convergence zones in turbulent flows, Center for Turbulence Research, Report CTR-S88). In a
     * vortex it is positive: rotation outweighs strain. In two dimensions it is det(grad u).
     */
    template <int dim>
    class QCriterion : public FlowQuantity<dim>
    {
    public:
      double evaluate(const Tensor<2, dim> &gradient) const override
      {
        const Tensor<2, dim> strain = symmetrize(gradient), spin = gradient - strain;
        return 0.5 * (spin.norm_square() - strain.norm_square());
      }
    };

    const DimensionalRegistration<FlowQuantity, QCriterion>
        registration("Q",
                     "half the excess of rotation over strain, (|W|^2 - |S|^2)/2 with the skew "
                     "and the symmetric part of grad u, positive in vortices (Hunt, Wray and "
                     "Moin 1988) [1/s^2]");
  } // namespace
} // namespace caudal
