// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/material_tools.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * The neo-Hookean material of the isochoric part of F, C = F^T F:
     * W = mu/2 (J^(-2/dim) tr C - dim), P = mu J^(-2/dim) (F - tr C/dim F^-T).
     */
    template <int dim>
    class ModifiedNeoHookean : public Material<dim>
    {
    public:
      void set_up(const ElasticModuli &moduli, const std::string &path) override
      {
        mu = moduli.compute_shear_modulus(/*poisson_ratio=*/0.5, path);
      }

      double strain_energy(const Tensor<2, dim> &F, const Point<dim> &) const override
      {
        return 0.5 * (scaled_modulus(F) * F.norm_square() - mu * dim);
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                  const Point<dim> &) const override
      {
        return scaled_modulus(F) * (F - F.norm_square() / dim * inverse_transpose(F));
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &) const override
      {
        const Tensor<2, dim> G         = inverse_transpose(F);
        const double         a         = scaled_modulus(F);
        const double         mean      = F.norm_square() / dim;
        const Tensor<2, dim> deviation = F - mean * G;
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return a * ((i == k && J == L ? 1. : 0.) + mean * G[k][J] * G[i][L] -
                      2. / dim * (G[i][J] * F[k][L] + deviation[i][J] * G[k][L]));
        });
      }

      bool leaves_volume_to_pressure() const override
      {
        return true;
      }

      /** The neo-Hookean material's modulus: the two differ by a pressure. */
      double get_wave_modulus() const override
      {
        return 2. * mu;
      }

    private:
      /** mu J^(-2/dim) */
      double scaled_modulus(const Tensor<2, dim> &F) const
      {
        return mu * std::pow(positive_determinant(F), -2. / dim);
      }

      double mu = 0.;
    };

    const DimensionalRegistration<Material, ModifiedNeoHookean>
        registration("modified neo-Hookean",
                     "with the isochoric energy mu/2 (J^(-2/dim) tr(F^T F) - dim)");
  } // namespace
} // namespace caudal
