// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/material_tools.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * The incompressible neo-Hookean material: W = mu/2 (tr C - dim) - mu ln J,
     * P = mu (F - F^-T), C = F^T F. The fluid's pressure keeps J = 1.
     */
    template <int dim>
    class NeoHookean : public Material<dim>
    {
    public:
      void set_up(const ElasticModuli &moduli, const std::string &path) override
      {
        mu = moduli.compute_shear_modulus(/*poisson_ratio=*/0.5, path);
      }

      double strain_energy(const Tensor<2, dim> &F, const Point<dim> &) const override
      {
        return mu * (0.5 * (F.norm_square() - dim) - std::log(positive_determinant(F)));
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                  const Point<dim> &) const override
      {
        return mu * (F - inverse_transpose(F));
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &) const override
      {
        const Tensor<2, dim> G = inverse_transpose(F);
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return mu * ((i == k && J == L ? 1. : 0.) + G[k][J] * G[i][L]);
        });
      }

      bool leaves_volume_to_pressure() const override
      {
        return true;
      }

    private:
      double mu = 0.;
    };

    const DimensionalRegistration<Material, NeoHookean>
        registration("neo-Hookean", "incompressible, P = mu (F - F^-T)");
  } // namespace
} // namespace caudal
