#include <caudal/solid/solid_parameters.h>

#include <cmath>

namespace caudal
{
  void RegionParameters::add_parameters(ParameterHandler &prm)
  {
    material.add_parameters(prm);
    prm.add_parameter(
        "Cell volume stabilisation", cell_volume_stabilisation,
        "Modulus kappa_v of the energy kappa_v/2 V (ln(v/V))^2 of each cell of the body, v "
        "its volume and V that in the reference configuration. It resists the volume errors "
        "of the interpolated motion and, unlike the pointwise volumetric stabilisation, does "
        "not resist bending [Pa].");
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
                      "are. This suits what is rigid and held by a feedback damping.",
                      Patterns::Selection("free|fixed"));
  }

  void RegionParameters::check(const std::string &path) const
  {
    material.check(path);
    AssertThrow(std::isfinite(cell_volume_stabilisation) && cell_volume_stabilisation >= 0,
                ExcMessage(path + "/Cell volume stabilisation: the value is " +
                           std::to_string(cell_volume_stabilisation) +
                           ". Give 0 or a positive number."));
    AssertThrow(std::isfinite(feedback_stiffness) && feedback_stiffness >= 0,
                ExcMessage(path + "/Feedback stiffness: the value is " +
                           std::to_string(feedback_stiffness) + ". Give 0 or a positive number."));
    AssertThrow(std::isfinite(feedback_damping) && feedback_damping >= 0,
                ExcMessage(path + "/Feedback damping: the value is " +
                           std::to_string(feedback_damping) + ". Give 0 or a positive number."));
  }

  template <int dim>
  SolidParameters<dim>::SolidParameters(const std::string              &name,
                                        const std::vector<std::string> &regions)
      : name(name)
      , regions(regions)
  {
    for (unsigned int r = 0; r < regions.size(); ++r)
      region_parameters.push_back(std::make_unique<RegionParameters>());
  }

  template <int dim>
  void SolidParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Polynomial degree", polynomial_degree,
                      "Degree of the body's finite elements [1].", Patterns::Integer(1, 2));
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
    AssertThrow(std::isfinite(density) && density >= 0,
                ExcMessage(get_path() + "/Density: the value is " + std::to_string(density) +
                           " kg/m^3. Give a positive number, or 0 for the fluid's density."));
    grid.check(get_path());
    for (unsigned int r = 0; r < regions.size(); ++r)
    {
      const std::string path = get_path() + "/Region " + regions[r];
      region_parameters[r]->check(path);
      AssertThrow(dim == 3 || region_parameters[r]->material.thin_direction != "z",
                  ExcMessage(path + "/Thin direction: the value is z, which is normal to the "
                                    "plane of this body. Give none, x or y."));
      AssertThrow(dim == 3 || region_parameters[r]->feedback_directions != "z",
                  ExcMessage(path + "/Feedback directions: the value is z, which is normal to the "
                                    "plane of this body. Give x, y or xy."));
    }
  }

  template struct SolidParameters<2>;
  template struct SolidParameters<3>;
} // namespace caudal
