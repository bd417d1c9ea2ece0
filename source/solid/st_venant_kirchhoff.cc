// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/material_tools.h>

namespace caudal
{
  namespace
  {
    /** P = F S, S = lambda tr(E) I + 2 mu E, with the Green-Lagrange strain E = (F^T F - I)/2. */
    template <int dim>
    class StVenantKirchhoff : public Material<dim>
    {
    public:
      void set_up(const ElasticModuli &moduli, const std::string &path) override
      {
        const double nu = moduli.poisson_ratio;
        mu              = moduli.compute_shear_modulus(nu, path);
        lambda          = 2. * mu * nu / (1. - 2. * nu);
        check_value(nu > -1. && nu < 0.5, path + "/Poisson ratio", nu,
                    "Give a ratio above -1 and below 0.5; for an incompressible body choose the "
                    "neo-Hookean material.");
      }

      double strain_energy(const Tensor<2, dim> &F, const Point<dim> &) const override
      {
        const Tensor<2, dim> E = strain(F);
        return 0.5 * lambda * trace(E) * trace(E) + mu * E.norm_square();
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                  const Point<dim> &) const override
      {
        return F * second_piola_kirchhoff_stress(F);
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &) const override
      {
        const Tensor<2, dim> S = second_piola_kirchhoff_stress(F);
        const Tensor<2, dim> B = F * transpose(F);
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return (i == k ? S[L][J] : 0.) + lambda * F[i][J] * F[k][L] +
                 mu * (F[i][L] * F[k][J] + (J == L ? B[i][k] : 0.));
        });
      }

    private:
      static Tensor<2, dim> strain(const Tensor<2, dim> &F)
      {
        return 0.5 * (transpose(F) * F - unit_symmetric_tensor<dim>());
      }

      Tensor<2, dim> second_piola_kirchhoff_stress(const Tensor<2, dim> &F) const
      {
        const Tensor<2, dim> E = strain(F);
        return lambda * trace(E) * unit_symmetric_tensor<dim>() + 2. * mu * E;
      }

      double mu = 0., lambda = 0.;
    };

    const DimensionalRegistration<Material, StVenantKirchhoff>
        registration("St. Venant-Kirchhoff", "linear in the Green-Lagrange strain");
  } // namespace
} // namespace caudal
