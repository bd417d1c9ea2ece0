// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/material_parameters.h>
#include <caudal/solid/thin_material.h>
#include <caudal/solid/volumetric_stabilisation.h>

namespace caudal
{
  template <int dim>
  void MaterialParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    material.add_parameters(prm);
    moduli.add_parameters(prm);
    prm.add_parameter(
        "Thin direction", thin_direction,
        "For a thin part of the body, the direction across it in the body's frame: the "
        "stress across it is left to the fluid's pressure. This does not change an "
        "incompressible material, but the pressure then does not jump at its faces by "
        "the stress of the bent body, and loads on it become more exact.",
        Patterns::Selection("none|x|y|z"));
    prm.add_parameter("Volumetric stabilisation", volumetric_stabilisation,
                      "Modulus kappa [Pa] of the energy kappa/2 (ln J)^2 that is added to any "
                      "material against volume errors of the interpolated motion.",
                      Patterns::Double());
  }

  template <int dim>
  void MaterialParameters<dim>::check(const std::string &path) const
  {
    check_not_negative(path + "/Volumetric stabilisation", volumetric_stabilisation,
                       "Give a modulus that is not negative [Pa].");
    AssertThrow(dim == 3 || thin_direction != "z",
                ExcMessage(path + "/Thin direction: the value is z, which is normal to the plane "
                                  "of this body. Give none, x or y."));
    material.check(path);
    create_bare(path);
  }

  template <int dim>
  std::unique_ptr<Material<dim>> MaterialParameters<dim>::create_bare(const std::string &path) const
  {
    auto bare = material.create();
    bare->set_up(moduli, path);
    return bare;
  }

  template <int dim>
  std::unique_ptr<Material<dim>> MaterialParameters<dim>::create(const std::string &path) const
  {
    auto result = create_bare(path);
    if (thin_direction != "none")
    {
      Tensor<1, dim> normal;
      normal[thin_direction[0] - 'x'] = 1.;
      result = std::make_unique<ThinMaterial<dim>>(std::move(result), normal);
    }
    if (volumetric_stabilisation > 0.)
      return std::make_unique<VolumetricallyStabilised<dim>>(std::move(result),
                                                             volumetric_stabilisation);
    return result;
  }

  template <int dim>
  double MaterialParameters<dim>::get_wave_modulus(const std::string &path) const
  {
    return create_bare(path)->get_wave_modulus() + volumetric_stabilisation;
  }

  template struct MaterialParameters<2>;
  template struct MaterialParameters<3>;
} // namespace caudal
