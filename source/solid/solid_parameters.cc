// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/material_tools.h>
#include <caudal/solid/solid_parameters.h>

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
      result                          = make_thin(std::move(result), normal);
    }
    if (volumetric_stabilisation > 0.)
      return make_volumetrically_stabilised(std::move(result), volumetric_stabilisation);
    return result;
  }

  template <int dim>
  double MaterialParameters<dim>::get_wave_modulus(const std::string &path) const
  {
    return create_bare(path)->get_wave_modulus() + volumetric_stabilisation;
  }

  template <int dim>
  void RegionParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    material.add_parameters(prm);
    prm.add_parameter(
        "Cell volume stabilisation", cell_volume_stabilisation,
        "Modulus kappa_v of the energy kappa_v/2 V (ln(v/V))^2 of each cell of the body, v "
        "its volume and V that in the reference configuration. It resists the volume errors "
        "of the interpolated motion and, unlike the pointwise volumetric stabilisation, does "
        "not resist bending [Pa]. automatic: 0, but for a body with a Traction a hundred shear "
        "moduli: then the body itself carries the pressure that a load causes, whose jump at the "
        "body's surface, within the fluid's cells, would make the body creep.",
        Patterns::Anything());
    prm.add_parameter("Feedback stiffness", feedback_stiffness,
                      "Spring constant kappa of the feedback force kappa (X_0 - X) that holds this "
                      "region at its initial place [N/m^4].");
    prm.add_parameter("Feedback damping", feedback_damping,
                      "Coefficient eta of the feedback force -eta U [N s/m^4].");
    prm.add_parameter("Feedback directions", feedback_directions,
                      "The directions in which the feedback force acts: letters of xyz.",
                      Patterns::Selection("x|y|z|xy|xz|yz|xyz"));
    prm.add_parameter("Motion", motion,
                      "free: the region moves with the fluid; fixed: its points stay where they "
                      "are; prescribed: they follow Translation and Rotation. The last two suit "
                      "what is rigid and held by a feedback damping.",
                      Patterns::Selection("free|fixed|prescribed"));
    place.add_parameters(prm);
  }

  template <int dim>
  void RegionParameters<dim>::check(const std::string &path) const
  {
    material.check(path);
    check_not_negative(path + "/Feedback stiffness", feedback_stiffness);
    check_not_negative(path + "/Feedback damping", feedback_damping);
    AssertThrow(dim == 3 || feedback_directions != "z",
                ExcMessage(path + "/Feedback directions: the value is z, which is normal to the "
                                  "plane of this body. Give x, y or xy."));
    AssertThrow(motion != "fixed" || !place.moves(),
                ExcMessage(path + "/Motion: a fixed region has no Translation or Rotation. Set "
                                  "Motion = prescribed, or leave them empty."));
    AssertThrow(motion != "prescribed" || place.moves(),
                ExcMessage(path + "/Motion: it is prescribed, but Translation and Rotation are "
                                  "empty. Give one of them, or set Motion = fixed."));
    AssertThrow(!place.moves() || is_fixed() || feedback_stiffness > 0. || feedback_damping > 0.,
                ExcMessage(path + "/Translation, Rotation: nothing holds this region. Set Motion = "
                                  "prescribed, or give it a Feedback stiffness."));
    AssertThrow(motion != "prescribed" || feedback_damping > 0.,
                ExcMessage(path +
                           "/Feedback damping: it is 0, and the fluid would pass through "
                           "points whose motion is prescribed. Give 1e4 mu/h^2 or more, h the "
                           "fluid's finest cells (--check tells)."));
    place.check(path);
  }

  template <int dim>
  SolidParameters<dim>::SolidParameters(const std::string              &name,
                                        const std::vector<std::string> &regions)
      : name(name)
      , regions(regions)
  {
    for (unsigned int r = 0; r < regions.size(); ++r)
      region_parameters.push_back(std::make_unique<RegionParameters<dim>>());
  }

  template <int dim>
  void SolidParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Polynomial degree", polynomial_degree,
                      "Degree of the body's finite elements [1].", Patterns::Integer(1, 2));
    prm.add_parameter(
        "Surface weight", surface_weight,
        "Weight beta of the body's surface beside its first layer of elements where body and fluid "
        "exchange velocity and force [1]: without it the wall acts too far inside, in proportion "
        "to the height of that layer. automatic: 0.35 for elements of degree 1, 0.15 for degree "
        "2.");
    prm.add_parameter("Density", density, "Density of the body [kg/m^3]; 0: that of the fluid.");
    prm.add_parameter("Monitored points", monitored_points,
                      "Points of the body, in its own frame, whose position and velocity become "
                      "part of the statistics; coordinates separated by ',', points by ';' [m].");
    prm.add_parameter(
        "Traction", traction,
        "Load on the body's surface [Pa]: force per area of the undeformed body, as a "
        "function of the point in the body's own frame and t, components (in the "
        "domain's directions) separated by ';'; empty: none. Its work counts as the muscle's.",
        Patterns::Anything());
    prm.add_parameter("Surface spring", surface_spring,
                      "Stiffness k of springs on the body's surface [Pa/m], as a function of the "
                      "point in the body's own frame: the force k (X_0 - X) per area of the "
                      "undeformed body, X_0 where its region is held. 0 where there are none; "
                      "empty: none anywhere.",
                      Patterns::Anything());
    prm.add_parameter("Surface damper", surface_damper,
                      "Coefficient c of dampers on the body's surface [Pa s/m], likewise: the "
                      "force c (dX_0/dt - U) per area.",
                      Patterns::Anything());
    grid.add_parameters(prm);
    for (unsigned int r = 0; r < regions.size(); ++r)
    {
      prm.enter_subsection("Region " + regions[r]);
      region_parameters[r]->add_parameters(prm);
      prm.leave_subsection();
    }
  }

  template <int dim>
  void SolidParameters<dim>::check() const
  {
    check_not_negative(get_path() + "/Density", density,
                       "Give a positive density [kg/m^3], or 0 for the fluid's.");
    get_surface_weight();
    grid.check(get_path());
    for (unsigned int r = 0; r < regions.size(); ++r)
    {
      region_parameters[r]->check(get_region_path(r));
      get_cell_volume_stabilisation(r);
    }
  }

  template <int dim>
  double SolidParameters<dim>::get_element_size(const double fluid_cell) const
  {
    return (polynomial_degree == 1 ? 1.25 : 2.) * fluid_cell;
  }

  template <int dim>
  double SolidParameters<dim>::get_surface_weight() const
  {
    const std::string path = get_path() + "/Surface weight";
    const auto        value =
        read_unless_automatic(path, surface_weight, "Give automatic or a number, 0.3 for example.");
    if (!value)
      return polynomial_degree == 1 ? 0.35 : 0.15;
    check_between(path, *value, 0., 2., "Give a number from 0 to 2.");
    return *value;
  }

  template <int dim>
  double SolidParameters<dim>::get_cell_volume_stabilisation(const unsigned int region) const
  {
    const std::string            path       = get_region_path(region);
    const RegionParameters<dim> &parameters = *region_parameters[region];
    const auto                   value = read_unless_automatic(path + "/Cell volume stabilisation",
                                                               parameters.cell_volume_stabilisation,
                                                               "Give automatic or a modulus [Pa].");
    // The modulus of the waves is twice the shear modulus of an incompressible material.
    if (!value)
      return traction.empty() ? 0.
                              : 50. * (parameters.material.get_wave_modulus(path) -
                                       parameters.material.volumetric_stabilisation);
    check_not_negative(path + "/Cell volume stabilisation", *value);
    return *value;
  }

  template struct MaterialParameters<2>;
  template struct MaterialParameters<3>;
  template struct RegionParameters<2>;
  template struct RegionParameters<3>;
  template struct SolidParameters<2>;
  template struct SolidParameters<3>;
} // namespace caudal
