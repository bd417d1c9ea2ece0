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

  /**
   * Another @p material without the stress across a thin part of the body, whose faces have the
   * @p normal N: W(F*, s) with
   *   F* = F + (1 - J)/|c|^2 c N^T,  c = cof(F) N,  det F* = 1,
   * F stretched along the normal c of the deformed faces to the reference volume.
   *
   * Where J = 1 this changes the material's stress by a pressure, which the fluid's makes up for,
   * and the motion not at all. But the pressure of the fluid then does not jump at the faces by
   * the stress of the bent body, which its elements can't follow inside of a cell and which would
   * load the body with what they miss of it.
   */
  template <int dim>
  std::unique_ptr<Material<dim>> make_thin(std::unique_ptr<Material<dim>> material,
                                           const Tensor<1, dim>          &normal);

  /**
   * Another @p material plus the energy kappa/2 (ln J)^2, which penalises the volume errors that
   * interpolation of the velocity leaves in the body (Vadala-Roth et al., Comput. Methods Appl.
   * Mech. Engrg. 365, 2020, doi:10.1016/j.cma.2020.112978). The tangent is that of the linearised
   * ln J, kappa F^-T F^-T: what it leaves out is indefinite and inverted cells in which ln J had
   * become large.
   */
  template <int dim>
  std::unique_ptr<Material<dim>>
  make_volumetrically_stabilised(std::unique_ptr<Material<dim>> material, double kappa);
} // namespace caudal

#endif
