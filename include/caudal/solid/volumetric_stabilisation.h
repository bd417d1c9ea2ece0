// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_volumetric_stabilisation_h
#define caudal_solid_volumetric_stabilisation_h

#include <caudal/solid/material.h>

namespace caudal
{
  /**
   * Another material plus the energy kappa/2 (ln J)^2, which penalises the volume errors that
   * interpolation of the velocity leaves in the body (Vadala-Roth et al., Comput. Methods Appl.
   * Mech. Engrg. 365, 2020, doi:10.1016/j.cma.2020.112978). The tangent is that of the linearised
   * ln J, kappa F^-T F^-T: what it leaves out is indefinite and inverted cells in which ln J had
   * become large.
   */
  template <int dim>
  class VolumetricallyStabilised : public Material<dim>
  {
  public:
    VolumetricallyStabilised(std::unique_ptr<Material<dim>> material, double kappa);

    double strain_energy(const Tensor<2, dim> &F, const Point<dim> &s) const override;

    Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                const Point<dim>     &s) const override;

    Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &s) const override;

  private:
    const std::unique_ptr<Material<dim>> material;
    const double                         kappa;
  };
} // namespace caudal

#endif
