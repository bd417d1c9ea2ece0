// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/material_tools.h>
#include <caudal/solid/volumetric_stabilisation.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  VolumetricallyStabilised<dim>::VolumetricallyStabilised(std::unique_ptr<Material<dim>> material,
                                                          const double                   kappa)
      : material(std::move(material))
      , kappa(kappa)
  {}

  template <int dim>
  double VolumetricallyStabilised<dim>::strain_energy(const Tensor<2, dim> &F,
                                                      const Point<dim>     &s) const
  {
    const double log_J = std::log(positive_determinant(F));
    return material->strain_energy(F, s) + 0.5 * kappa * log_J * log_J;
  }

  template <int dim>
  Tensor<2, dim>
  VolumetricallyStabilised<dim>::first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                              const Point<dim>     &s) const
  {
    return material->first_piola_kirchhoff_stress(F, s) +
           kappa * std::log(positive_determinant(F)) * inverse_transpose(F);
  }

  template <int dim>
  Tensor<4, dim> VolumetricallyStabilised<dim>::tangent(const Tensor<2, dim> &F,
                                                        const Point<dim>     &s) const
  {
    const Tensor<2, dim> G = inverse_transpose(F);
    return material->tangent(F, s) + make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
             return kappa * G[i][J] * G[k][L];
           });
  }

  template class VolumetricallyStabilised<2>;
  template class VolumetricallyStabilised<3>;
} // namespace caudal
