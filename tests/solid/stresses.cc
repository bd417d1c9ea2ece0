// Every material: P against differences of the energy, the tangent against
// differences of P, its major symmetry, objectivity, and no stress in a rotation.

#include <caudal/solid/stress.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <iostream>

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

std::string ok(const double error, const double tolerance)
{
  return error < tolerance ? "ok" : "bad (" + std::to_string(error) + ")";
}

/** Where J = 1: no stress across the faces, and the material's own stress up to a pressure. */
template <int dim>
void check_traction(const StressModel<dim> &model, const Tensor<2, dim> &F,
                    const unsigned int direction, MaterialParameters parameters)
{
  parameters.thin_direction = "none";
  const Tensor<2, dim> P    = model.first_piola_kirchhoff_stress(F);
  const Tensor<2, dim> full = create_stress_model<dim>(parameters)->first_piola_kirchhoff_stress(F);
  const Tensor<2, dim> stress   = P * transpose(F);
  const Tensor<2, dim> pressure = (full - P) * transpose(F);
  Tensor<1, dim>       normal;
  normal[direction] = 1.;
  normal            = transpose(invert(F)) * normal;
  std::cout << "  traction on the faces " << ok(std::abs(normal * stress * normal), 1e-12)
            << ", a pressure less "
            << ok((pressure - trace(pressure) / dim * unit_symmetric_tensor<dim>()).norm(), 1e-12)
            << std::endl;
}

template <int dim>
void check(const std::string &name, const double kappa, const std::string &thin_direction = "none")
{
  MaterialParameters parameters;
  parameters.material                 = name;
  parameters.youngs_modulus           = 3.;
  parameters.poisson_ratio            = 0.3;
  parameters.volumetric_stabilisation = kappa;
  parameters.thin_direction           = thin_direction;
  const auto model                    = create_stress_model<dim>(parameters);

  Tensor<2, dim> F = unit_symmetric_tensor<dim>();
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int J = 0; J < dim; ++J)
      F[i][J] += 0.3 * std::sin(1. + 3. * i + 2. * J);
  // The tangent of a thin material is exact for the motions of the incompressible fluid.
  Tensor<2, dim> F_of_tangent = F;
  if (thin_direction != "none")
    F_of_tangent *= std::pow(determinant(F), -1. / dim);

  const double         step         = 1e-5;
  const Tensor<2, dim> P            = model->first_piola_kirchhoff_stress(F);
  const Tensor<4, dim> C            = model->tangent(F_of_tangent);
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
          std::abs((model->strain_energy(plus) - model->strain_energy(minus)) / (2. * step) -
                   P[k][L]));
      const auto difference = [&](const double width) {
        Tensor<2, dim> after = F_of_tangent, before = F_of_tangent;
        after[k][L] += width;
        before[k][L] -= width;
        return (model->first_piola_kirchhoff_stress(after) -
                model->first_piola_kirchhoff_stress(before)) /
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
            << ": W = " << model->strain_energy(F) << ", |P| = " << P.norm()
            << ", |C| = " << C.norm() << "\n  stress " << ok(stress_error, 1e-8) << ", tangent "
            << ok(tangent_error, 1e-8) << ", symmetry " << ok(asymmetry, 1e-12) << ", objectivity "
            << ok(std::abs(model->strain_energy(Q * F) - model->strain_energy(F)), 1e-12)
            << ", rotation "
            << ok(model->first_piola_kirchhoff_stress(Q).norm() + std::abs(model->strain_energy(Q)),
                  1e-12)
            << std::endl;
  if (thin_direction != "none")
    check_traction(*model, F_of_tangent, thin_direction[0] - 'x', parameters);
}

template <class Action>
void expect_sentence(const Action &action)
{
  try
  {
    action();
    std::cout << "no complaint" << std::endl;
  }
  catch (const ExceptionBase &exception)
  {
    exception.print_info(std::cout);
  }
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

  MaterialParameters steel;
  steel.material      = "St. Venant-Kirchhoff";
  steel.shear_modulus = 2e6;
  steel.poisson_ratio = 0.4;
  std::cout << "Turek's beam: mu = " << steel.get_shear_modulus()
            << ", lambda = " << steel.get_lame_modulus() << std::endl;

  expect_sentence([&] {
    steel.poisson_ratio = 0.5;
    steel.check("Body beam/Region flag");
  });
  expect_sentence([&] {
    steel.shear_modulus = -1.;
    steel.check("Body beam/Region flag");
  });
  expect_sentence([] {
    Tensor<2, 2> inverted;
    inverted[0][0] = -1.;
    inverted[1][1] = 0.5;
    create_stress_model<2>(MaterialParameters())->strain_energy(inverted);
  });
}
