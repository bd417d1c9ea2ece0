// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/viscous/parameters.h>

#include <set>

namespace caudal
{
  namespace
  {
    /** The names of a comma-separated list; throws on doubles and on what is no name. */
    std::vector<std::string> split_names(const std::string &path, const std::string &text)
    {
      const std::vector<std::string> names = Utilities::split_string_list(text);
      AssertThrow(std::set<std::string>(names.begin(), names.end()).size() == names.size(),
                  ExcMessage(path + ": a name stands twice in <" + text + ">. Give each its own."));
      for (const std::string &name : names)
        check_name(path, name);
      return names;
    }
  } // namespace

  template <int dim>
  RunParameters<dim>::RunParameters(const ParameterFile *file)
  {
    const std::vector<std::string> names =
        file ? split_names("Bodies", file->get("Bodies", "")) : std::vector<std::string>{"<name>"};
    for (const std::string &name : names)
    {
      const std::string              entry   = "Body " + name + "/Regions";
      const std::vector<std::string> regions = file ? split_names(entry, file->get(entry, "body"))
                                                    : std::vector<std::string>{"<region>"};
      AssertThrow(!regions.empty(),
                  ExcMessage(entry + ": the list is empty. Give at least one name."));
      bodies.push_back(std::make_unique<BodyParameters<dim>>(name, regions));
    }
  }

  template <int dim>
  std::vector<RenamedEntry> RunParameters<dim>::get_renamed_entries()
  {
    std::vector<RenamedEntry> entries = BodyGridParameters<dim>::get_renamed_entries();
    entries.push_back({"Body */Gait/Curvature", "Body */Gait/Curvature/Function"});
    for (const std::string entry :
         {"Heading/Target heading", "Heading/Heading gain", "Heading/Yaw rate gain",
          "Heading/Largest bias", "Speed/Target speed", "Speed/Speed gain", "Speed/Largest gain"})
      entries.push_back(
          {"Body */Controller/" + entry.substr(entry.find('/') + 1), "Body */Controller/" + entry});
    return entries;
  }

  template <int dim>
  void RunParameters<dim>::declare(ParameterHandler &prm)
  {
    prm.add_parameter("Model", model,
                      "The model: immersed, the elastic swimmer in a viscous fluid (the others, "
                      "potential, passage and elastic, have other parameters).",
                      Patterns::Selection("immersed"));
    prm.add_parameter("Dimension", dimension, "Space dimension, 2 or 3 [1].",
                      Patterns::Integer(2, 3));
    prm.add_parameter("Bodies", bodies_text,
                      "Names of the bodies, separated by commas; each has a section `Body <name>`. "
                      "None: only the fluid.",
                      Patterns::Anything());
    declare_libraries(prm);
    time.add_parameters(prm);
    domain.add_parameters(prm);
    fluid.add_parameters(prm);
    for (const auto &body : bodies)
    {
      prm.enter_subsection(body->solid.get_path());
      body->add_parameters(prm);
      prm.leave_subsection();
    }
    coupling.add_parameters(prm);
    refinement.add_parameters(prm);
    solver.add_parameters(prm);
    output.add_parameters(prm);
    checkpoint.add_parameters(prm);
    observers.add_parameters(prm);
  }

  template <int dim>
  void RunParameters<dim>::check() const
  {
    time.check();
    domain.check();
    std::vector<std::string> names;
    for (const auto &body : bodies)
      names.push_back(body->solid.name);
    domain.check_frame(names, time.is_explicit());
    fluid.check();
    for (unsigned int side = 0; side < 2 * dim; ++side)
      AssertThrow(!domain.is_periodic(side / 2) ||
                      fluid.sides[side].get_name() == FluidParameters<dim>().sides[side].get_name(),
                  ExcMessage("Fluid/Boundary conditions: the condition on the side " +
                             get_side_names(dim)[side] +
                             " has no meaning, since Domain/Periodic directions makes it one with "
                             "the opposite side. Leave it out."));
    for (const auto &body : bodies)
    {
      // The files of such a body would have the names of the flow's.
      AssertThrow(body->solid.get_path() != "Body fluid",
                  ExcMessage("Bodies: a body can't be called fluid. Give it another name."));
      body->check(time.is_explicit());
    }
    coupling.check();
    refinement.check(domain.levels);
    AssertThrow(refinement.interior_levels == 0 || coupling.kernel.get().radius == 0,
                ExcMessage("Refinement/Interior levels: the kernel " + coupling.kernel.get_name() +
                           " spreads over cells of one size. Choose Coupling/Kernel = dirac, or "
                           "leave this entry out."));
    solver.check();
    output.check();
    checkpoint.check();
    observers.check();
  }

  unsigned int get_dimension(const ParameterFile &file)
  {
    const std::string text = file.get("Dimension", "2");
    AssertThrow(text == "2" || text == "3",
                ExcMessage("Dimension: the value is <" + text + ">. Give 2 or 3."));
    return text == "2" ? 2 : 3;
  }

  template struct RunParameters<2>;
  template struct RunParameters<3>;
} // namespace caudal
