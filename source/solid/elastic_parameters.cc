// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/solid/elastic_parameters.h>

namespace caudal
{
  template <int dim>
  ElasticParameters<dim>::ElasticParameters(const ParameterFile *file)
  {
    body_name = file ? file->get("Bodies", "") : "<name>";
    AssertThrow(Utilities::split_string_list(body_name).size() == 1,
                ExcMessage("Bodies: there are none or several in <" + body_name +
                           ">. The elastic model has one body; name it."));
    if (file)
      check_name("Bodies", body_name);
    solid = std::make_unique<SolidParameters<dim>>(
        body_name, Utilities::split_string_list(
                       file ? file->get("Body " + body_name + "/Regions", "body") : "<region>"));
  }

  template <int dim>
  void ElasticParameters<dim>::declare(ParameterHandler &prm)
  {
    prm.add_parameter("Model", model,
                      "The model: elastic, a body without fluid (the others, immersed, "
                      "potential and passage, have other parameters).",
                      Patterns::Selection("elastic"));
    prm.add_parameter("Dimension", dimension, "Space dimension, 2 or 3 [1].",
                      Patterns::Integer(2, 3));
    prm.add_parameter("Bodies", body_name,
                      "The name of the body, which has a section `Body <name>`.",
                      Patterns::Anything());
    declare_libraries(prm);
    prm.add_parameter("Gravity", gravity, "Acceleration of gravity g [m/s^2].");
    prm.enter_subsection("Time");
    prm.add_parameter("Static", is_static,
                      "Look for the equilibrium. The weight grows from step to step, up to the "
                      "whole at the end time.");
    prm.add_parameter("End time", end_time, "Simulated time [s].");
    prm.add_parameter("Step", step, "Size of the time step [s].");
    prm.leave_subsection();
    prm.enter_subsection(solid->get_path());
    prm.declare_entry("Regions", "body", Patterns::Anything(),
                      "Names of the body's regions, separated by commas; each has a section "
                      "`Region <name>`.");
    solid->add_parameters(prm);
    prm.leave_subsection();
    output.add_folder_parameters(prm);
  }

  namespace
  {
    /** What a region can't have without a fluid. */
    template <int dim>
    void check_region(const SolidParameters<dim> &solid, const unsigned int r)
    {
      const RegionParameters<dim>   &region   = *solid.region_parameters[r];
      const std::string              path     = solid.get_region_path(r);
      const MaterialParameters<dim> &material = region.material;
      AssertThrow(material.thin_direction == "none",
                  ExcMessage(path + "/Thin direction: the elastic model has no fluid whose "
                                    "pressure takes the stress that this leaves out. Give none."));
      AssertThrow(!material.material.get().leaves_volume_to_pressure() ||
                      material.volumetric_stabilisation > 0 ||
                      solid.get_cell_volume_stabilisation(r) > 0,
                  ExcMessage(path + "/Material: <" + material.material.get_name() +
                             "> leaves the volume to the fluid's pressure, and there is no fluid. "
                             "Give St. Venant-Kirchhoff, or a Volumetric stabilisation."));
      AssertThrow(!region.place.moves(),
                  ExcMessage(path + "/Translation, Rotation: the elastic model moves no region. "
                                    "Leave them empty; Motion = fixed holds a region."));
      AssertThrow(region.feedback_stiffness == 0 && region.feedback_damping == 0,
                  ExcMessage(path +
                             "/Feedback stiffness, Feedback damping: the elastic model has no "
                             "feedback forces. Leave them at 0; Motion = fixed holds a region."));
    }
  } // namespace

  template <int dim>
  void ElasticParameters<dim>::check() const
  {
    check_positive("Time/End time", end_time, "Give a positive number [s].");
    check_positive("Time/Step", step, "Give a positive number [s].");
    solid->check();
    check_positive(solid->get_path() + "/Density", solid->density,
                   "There is no fluid to take it from: give a positive one [kg/m^3].");
    AssertThrow(solid->surface_spring.empty() && solid->surface_damper.empty(),
                ExcMessage(solid->get_path() +
                           "/Surface spring, Surface damper: the elastic model has no springs. "
                           "Leave them empty; Motion = fixed holds a region."));
    AssertThrow(solid->traction.empty(),
                ExcMessage(solid->get_path() + "/Traction: the elastic model knows no load but "
                                               "Gravity. Leave it empty."));
    for (unsigned int r = 0; r < solid->regions.size(); ++r)
      check_region(*solid, r);
    output.check();
  }

  template struct ElasticParameters<2>;
  template struct ElasticParameters<3>;
} // namespace caudal
