// SPDX-License-Identifier: LGPL-2.1-or-later
// Every material: P against differences of the energy, the tangent against
// differences of P, its major symmetry, objectivity, and no stress in a rotation.

#include <caudal/base/collective.h>
#include <caudal/solid/solid_parameters.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <iostream>

#include "../round_off.h"

using namespace caudal;

template <int dim>
Tensor<2, dim> rotation()
{
  Tensor<2, dim> Q = unit_symmetric_tensor<dim>();
  Q[0][0] = Q[1][1] = std::cos(0.7);
  Q[0][1]           = -std::sin(0.7);
  Q[1][0]           = std::sin(0.7);
  if (dim == 3)
  {
    Tensor<2, dim> R    = unit_symmetric_tensor<dim>();
    R[dim - 1][dim - 1] = R[1][1] = std::cos(0.4);
    R[1][dim - 1]                 = -std::sin(0.4);
    R[dim - 1][1]                 = std::sin(0.4);
    Q                             = Q * R;
  }
  return Q;
}

/** Where J = 1: no stress across the faces, and the material's own stress up to a pressure. */
template <int dim>
void check_traction(const Material<dim> &model, const Material<dim> &full_model,
                    const Tensor<2, dim> &F, const unsigned int direction)
{
  const Point<dim>     s;
  const Tensor<2, dim> P        = model.first_piola_kirchhoff_stress(F, s);
  const Tensor<2, dim> full     = full_model.first_piola_kirchhoff_stress(F, s);
  const Tensor<2, dim> stress   = P * transpose(F);
  const Tensor<2, dim> pressure = (full - P) * transpose(F);
  Tensor<1, dim>       normal;
  normal[direction] = 1.;
  normal            = transpose(invert(F)) * normal;
  std::cout << "  traction on the faces " << in_units(1e-12, std::abs(normal * stress * normal))
            << ", a pressure less "
            << in_units(1e-12,
                        (pressure - trace(pressure) / dim * unit_symmetric_tensor<dim>()).norm())
            << std::endl;
}

template <int dim>
void check(const std::string &name, const double kappa, const std::string &thin_direction = "none")
{
  MaterialParameters<dim> parameters;
  parameters.material.set_name(name);
  parameters.moduli.youngs_modulus    = 3.;
  parameters.moduli.poisson_ratio     = 0.3;
  parameters.volumetric_stabilisation = kappa;
  const auto full_model               = parameters.create("Body/Region");
  parameters.thin_direction           = thin_direction;
  const auto       model              = parameters.create("Body/Region");
  const Point<dim> s;

  Tensor<2, dim> F = unit_symmetric_tensor<dim>();
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int J = 0; J < dim; ++J)
      F[i][J] += 0.3 * std::sin(1. + 3. * i + 2. * J);
  // The tangent of a thin material is exact for the motions of the incompressible fluid.
  Tensor<2, dim> F_of_tangent = F;
  if (thin_direction != "none")
    F_of_tangent *= std::pow(determinant(F), -1. / dim);

  const double         step         = 1e-5;
  const Tensor<2, dim> P            = model->first_piola_kirchhoff_stress(F, s);
  const Tensor<4, dim> C            = model->tangent(F_of_tangent, s);
  const Tensor<2, dim> G            = transpose(invert(F_of_tangent));
  const double         log_J        = std::log(determinant(F_of_tangent));
  double               stress_error = 0., tangent_error = 0., asymmetry = 0.;
  for (unsigned int k = 0; k < dim; ++k)
    for (unsigned int L = 0; L < dim; ++L)
    {
      Tensor<2, dim> plus = F, minus = F;
      plus[k][L] += step;
      minus[k][L] -= step;
      stress_error = std::max(
          stress_error,
          std::abs((model->strain_energy(plus, s) - model->strain_energy(minus, s)) / (2. * step) -
                   P[k][L]));
      const auto difference = [&](const double width) {
        Tensor<2, dim> after = F_of_tangent, before = F_of_tangent;
        after[k][L] += width;
        before[k][L] -= width;
        return (model->first_piola_kirchhoff_stress(after, s) -
                model->first_piola_kirchhoff_stress(before, s)) /
               (2. * width);
      };
      const Tensor<2, dim> slope = (4. * difference(step) - difference(2. * step)) / 3.;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
        {
          // The stabilisation's tangent lacks the derivative of F^-T.
          const double left_out = -kappa * log_J * G[k][J] * G[i][L];
          tangent_error = std::max(tangent_error, std::abs(slope[i][J] - C[i][J][k][L] - left_out));
          asymmetry     = std::max(asymmetry, std::abs(C[i][J][k][L] - C[k][L][i][J]));
        }
    }

  const Tensor<2, dim> Q = rotation<dim>();
  std::cout << dim << "D " << name << (kappa > 0. ? ", stabilised" : "")
            << (thin_direction == "none" ? "" : ", thin in " + thin_direction)
            << ": W = " << model->strain_energy(F, s) << ", |P| = " << P.norm()
            << ", |C| = " << C.norm() << "\n  stress " << in_units(1e-8, stress_error)
            << ", tangent " << in_units(1e-8, tangent_error) << ", symmetry "
            << in_units(1e-12, asymmetry) << ", objectivity "
            << in_units(1e-12,
                        std::abs(model->strain_energy(Q * F, s) - model->strain_energy(F, s)))
            << ", rotation "
            << in_units(1e-12, model->first_piola_kirchhoff_stress(Q, s).norm() +
                                   std::abs(model->strain_energy(Q, s)))
            << std::endl;
  if (thin_direction != "none")
    check_traction(*model, *full_model, F_of_tangent, thin_direction[0] - 'x');
}

/** The sentence about what is wrong with a region's entries. */
std::string complain(const std::string &material, const double shear_modulus,
                     const double poisson_ratio)
{
  MaterialParameters<2> parameters;
  parameters.material.set_name(material);
  parameters.moduli.shear_modulus = shear_modulus;
  parameters.moduli.poisson_ratio = poisson_ratio;
  const std::string error         = catch_error([&] { parameters.check("Body beam/Region flag"); });
  return error.empty() ? "no complaint" : error;
}

int main()
{
  for (const std::string name :
       {"none", "neo-Hookean", "modified neo-Hookean", "St. Venant-Kirchhoff"})
    for (const double kappa : {0., 2.})
    {
      check<2>(name, kappa);
      check<3>(name, kappa);
      check<2>(name, kappa, "y");
      check<3>(name, kappa, "x");
    }

  // The beam of Turek & Hron (2006): mu = 2e6 Pa, lambda = 8e6 Pa
  MaterialParameters<2> steel;
  steel.material.set_name("St. Venant-Kirchhoff");
  steel.moduli.shear_modulus = 2e6;
  steel.moduli.poisson_ratio = 0.4;
  std::cout << "2 mu + lambda = " << steel.get_wave_modulus("Region") << std::endl;

  std::cout << complain("St. Venant-Kirchhoff", 2e6, 0.5) << '\n'
            << complain("neo-Hookean", 2e6, 0.5) << '\n'
            << complain("St. Venant-Kirchhoff", -1., 0.4) << '\n'
            << complain("none", -1., 0.4) << '\n'
            << complain("rubber", 2e6, 0.4) << std::endl;
  Tensor<2, 2> inverted;
  inverted[0][0] = -1.;
  inverted[1][1] = 0.5;
  std::cout << catch_error([&] {
    MaterialParameters<2>().create("Region")->strain_energy(inverted, Point<2>());
  }) << std::endl;
}
