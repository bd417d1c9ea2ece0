// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_thin_material_h
#define caudal_solid_thin_material_h

#include <caudal/solid/material.h>

namespace caudal
{
  /**
   * Another material without the stress across a thin part of the body, whose faces have the
   * normal N: W(F*, s) with
   *   F* = F + (1 - J)/|c|^2 c N^T,  c = cof(F) N,  det F* = 1,
   * F stretched along the normal c of the deformed faces to the reference volume.
   *
   * Where J = 1 this changes the material's stress by a pressure, which the fluid's makes up for,
   * and the motion not at all. But the pressure of the fluid then does not jump at the faces by
   * the stress of the bent body, which its elements can't follow inside of a cell and which would
   * load the body with what they miss of it.
   */
  template <int dim>
  class ThinMaterial : public Material<dim>
  {
  public:
    ThinMaterial(std::unique_ptr<Material<dim>> material, const Tensor<1, dim> &normal);

    double strain_energy(const Tensor<2, dim> &F, const Point<dim> &s) const override;

    Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                const Point<dim>     &s) const override;

    /** The second derivative of the energy where J = 1. */
    Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &s) const override;

  private:
    struct Stretch;

    const std::unique_ptr<Material<dim>> material;
    const Tensor<1, dim>                 normal;
  };
} // namespace caudal

#endif
