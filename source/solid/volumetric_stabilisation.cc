// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/material_tools.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    template <int dim>
    class VolumetricallyStabilised : public Material<dim>
    {
    public:
      VolumetricallyStabilised(std::unique_ptr<Material<dim>> material, const double kappa)
          : material(std::move(material))
          , kappa(kappa)
      {}

      double strain_energy(const Tensor<2, dim> &F, const Point<dim> &s) const override
      {
        const double log_J = std::log(positive_determinant(F));
        return material->strain_energy(F, s) + 0.5 * kappa * log_J * log_J;
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                  const Point<dim>     &s) const override
      {
        return material->first_piola_kirchhoff_stress(F, s) +
               kappa * std::log(positive_determinant(F)) * inverse_transpose(F);
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &s) const override
      {
        const Tensor<2, dim> G = inverse_transpose(F);
        return material->tangent(F, s) + make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
                 return kappa * G[i][J] * G[k][L];
               });
      }

    private:
      const std::unique_ptr<Material<dim>> material;
      const double                         kappa;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Material<dim>>
  make_volumetrically_stabilised(std::unique_ptr<Material<dim>> material, const double kappa)
  {
    return std::make_unique<VolumetricallyStabilised<dim>>(std::move(material), kappa);
  }

  template std::unique_ptr<Material<2>> make_volumetrically_stabilised(std::unique_ptr<Material<2>>,
                                                                       double);
  template std::unique_ptr<Material<3>> make_volumetrically_stabilised(std::unique_ptr<Material<3>>,
                                                                       double);
} // namespace caudal
