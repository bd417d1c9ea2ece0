// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_material_tools_h
#define caudal_solid_material_tools_h

#include <caudal/solid/material.h>

#include <deal.II/base/symmetric_tensor.h>

namespace caudal
{
  /** The tangent whose entries are @p entry(i, J, k, L). */
  template <int dim, typename Entry>
  Tensor<4, dim> make_tangent(const Entry &entry)
  {
    Tensor<4, dim> tangent;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            tangent[i][J][k][L] = entry(i, J, k, L);
    return tangent;
  }

  /** det F; throws ExcInvertedElement unless it is positive. */
  template <int dim>
  double positive_determinant(const Tensor<2, dim> &F)
  {
    const double J = determinant(F);
    AssertThrow(J > 0., ExcInvertedElement(J));
    return J;
  }

  /** F^-T, the derivative of ln J. */
  template <int dim>
  Tensor<2, dim> inverse_transpose(const Tensor<2, dim> &F)
  {
    return transpose(invert(F));
  }
} // namespace caudal

#endif
