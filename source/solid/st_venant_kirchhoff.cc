// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/material_tools.h>

#include <iomanip>
#include <sstream>

namespace caudal
{
  namespace
  {
    /**
     * P = F S, S = lambda tr(E) I + 2 mu E, with the Green-Lagrange strain E = (F^T F - I)/2.
     *
     * Within the fluid the body keeps its volume, and bends as if the Poisson ratio were 1/2: a
     * plate in plane strain with 4 mu in place of E/(1 - nu^2), which is 2 (1 - nu) times as much;
     * a slender beam in three dimensions with 3 mu in place of E.
     */
    template <int dim>
    class StVenantKirchhoff : public Material<dim>
    {
    public:
      void set_up(const ElasticModuli &moduli, const std::string &path) override
      {
        const double nu = moduli.poisson_ratio;
        mu              = moduli.compute_shear_modulus(nu, path);
        excess          = dim == 2 ? 2. * (1. - nu) : 1.5 / (1. + nu);
        if (keeps_bending_stiffness)
          mu /= excess;
        lambda = 2. * mu * nu / (1. - 2. * nu);
        check_value(nu > -1. && nu < 0.5, path + "/Poisson ratio", nu,
                    "Give a ratio above -1 and below 0.5; for an incompressible body choose the "
                    "neo-Hookean material.");
      }

      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Keep bending stiffness", keeps_bending_stiffness,
                          "Whether mu is chosen so that a body in a fluid, which keeps its volume, "
                          "is bent as Young's modulus and Poisson ratio say: in two dimensions "
                          "E/(4 (1 - nu^2)), in three E/3 (a beam); otherwise E/(2 (1 + nu)).");
      }

      std::string get_immersed_remark() const override
      {
        std::ostringstream text;
        if (!keeps_bending_stiffness && excess > 1.01)
          text << "within a fluid, which keeps its volume, the body resists bending "
               << std::setprecision(3) << excess
               << " times as much as its Young's modulus and Poisson ratio say. Set "
                  "St Venant-Kirchhoff/Keep bending stiffness = true if they are those of a real "
                  "material.";
        return text.str();
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

      bool   keeps_bending_stiffness = false;
      double mu = 0., lambda = 0.;
      double excess = 1.; // bending stiffness in a fluid over that of the moduli
    };

    const DimensionalRegistration<Material, StVenantKirchhoff>
        registration("St. Venant-Kirchhoff", "linear in the Green-Lagrange strain");
  } // namespace
} // namespace caudal
