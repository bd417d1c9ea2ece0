// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/material_tools.h>

#include <cmath>

using namespace caudal;

/** W = mu (1/2 (tr C - dim) - ln J), with a shear modulus mu(x) that is linear along the body. */
template <int dim>
class GradedNeoHookean : public Material<dim>
{
public:
  void add_parameters(ParameterHandler &prm) override
  {
    prm.add_parameter("Modulus at the root", root, "mu at x = 0 in the body's frame [Pa].");
    prm.add_parameter("Modulus at the tip", tip, "mu at x = Length [Pa].");
    prm.add_parameter("Length", length, "Where mu has its value at the tip [m].");
  }

  void check(const std::string &path) const override
  {
    check_positive(path + "/Modulus at the root", root, "Give a positive modulus [Pa].");
    check_positive(path + "/Modulus at the tip", tip, "Give a positive modulus [Pa].");
    check_positive(path + "/Length", length, "Give a positive length [m].");
  }

  double strain_energy(const Tensor<2, dim> &F, const Point<dim> &s) const override
  {
    return mu(s) * (0.5 * (F.norm_square() - dim) - std::log(positive_determinant(F)));
  }

  Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                              const Point<dim>     &s) const override
  {
    return mu(s) * (F - inverse_transpose(F));
  }

  Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &s) const override
  {
    const Tensor<2, dim> G = inverse_transpose(F);
    return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
      return mu(s) * ((i == k && J == L ? 1. : 0.) + G[k][J] * G[i][L]);
    });
  }

private:
  double root = 1e6, tip = 1e6, length = 1;

  double mu(const Point<dim> &s) const
  {
    return root + (tip - root) * s[0] / length;
  }
};

const DimensionalRegistration<Material, GradedNeoHookean>
    registration("graded neo-Hookean", "neo-Hookean with a modulus that is linear along the body");
