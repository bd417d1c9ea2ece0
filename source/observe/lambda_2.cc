// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/flow_quantity.h>

#include <deal.II/base/symmetric_tensor.h>

namespace caudal
{
  namespace
  {
    /**
     * The second of the three eigenvalues of S^2 + W^2 in their order [1/s^2], S and W being the
     * symmetric and the skew part of the velocity's gradient. In a vortex it is negative: there the
     * pressure, without what unsteadiness and viscosity do to it, has its smallest value in a plane
     * (Jeong & Hussain 1995, doi:10.1017/S0022112095000462). A plane flow has no gradient in the
     * third direction; there it is -Q.
     */
    template <int dim>
    class Lambda2 : public FlowQuantity<dim>
    {
    public:
      double evaluate(const Tensor<2, dim> &gradient) const override
      {
        SymmetricTensor<2, 3> sum;
        const Tensor<2, dim>  square = gradient * gradient;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            sum[i][j] = 0.5 * (square[i][j] + square[j][i]); // = S^2 + W^2
        return eigenvalues(sum)[1];
      }
    };

    const DimensionalRegistration<FlowQuantity, Lambda2>
        registration("lambda_2",
                     "the second eigenvalue of S^2 + W^2, negative in vortices, in plane "
                     "flow -Q (Jeong and Hussain 1995, doi:10.1017/S0022112095000462) "
                     "[1/s^2]");
  } // namespace
} // namespace caudal
