// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/material_tools.h>

namespace caudal
{
  void ElasticModuli::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Young's modulus", youngs_modulus,
                      "Young's modulus E [Pa]; used if the shear modulus is 0.",
                      Patterns::Double());
    prm.add_parameter("Shear modulus", shear_modulus,
                      "Shear modulus mu [Pa]. 0 takes it from Young's modulus: E/3 for the "
                      "neo-Hookean materials, E/(2 (1 + nu)) for St. Venant-Kirchhoff's.",
                      Patterns::Double());
    prm.add_parameter("Poisson ratio", poisson_ratio,
                      "Poisson ratio nu [-] of St. Venant-Kirchhoff's material; the neo-Hookean "
                      "ones are incompressible.",
                      Patterns::Double());
  }

  double ElasticModuli::compute_shear_modulus(const double       poisson_ratio,
                                              const std::string &path) const
  {
    check_not_negative(path + "/Shear modulus", shear_modulus,
                       "Give a positive modulus [Pa], or 0 to take it from Young's.");
    if (shear_modulus > 0.)
      return shear_modulus;
    check_positive(path + "/Young's modulus", youngs_modulus,
                   "Give a positive modulus [Pa], or a positive shear modulus.");
    return youngs_modulus / (2. * (1. + poisson_ratio));
  }

  template <int dim>
  double Material<dim>::get_wave_modulus() const
  {
    return tangent(unit_symmetric_tensor<dim>(), Point<dim>())[0][0][0][0];
  }

  template class Material<2>;
  template class Material<3>;
} // namespace caudal
