// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/ideal/ideal_parameters.h>

namespace caudal
{
  void OutputSchedule::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("End time", end_time, "Simulated time [s].");
    prm.add_parameter("Step", step,
                      "Time between two rows of output [s]. The motion itself is integrated as "
                      "finely as Integration/Tolerance asks.");
    prm.add_parameter("First step", first_step, "Time between two rows in the first part [s].");
    prm.add_parameter("First part", first_part,
                      "How long the first part is [s]; 1 s with steps of 0.001 s is the dynamic "
                      "start of Yao et al.");
    prm.leave_subsection();
  }

  void OutputSchedule::check() const
  {
    check_positive("Time/End time", end_time, "Give a positive time [s].");
    check_positive("Time/Step", step, "Give a positive time [s].");
    check_positive("Time/First step", first_step, "Give a positive time [s].");
    check_not_negative("Time/First part", first_part, "Give a time, or 0 for none [s].");
    const double n_rows = std::min(first_part, end_time) / first_step + end_time / step;
    AssertThrow(n_rows < 1e7,
                ExcMessage("Time/Step: there would be " + Patterns::Tools::to_string(n_rows) +
                           " rows of output. Give longer steps."));
  }

  std::vector<double> OutputSchedule::get_times() const
  {
    std::vector<double> times{0.};
    const auto          add = [&](const double end, const double largest_step) {
      const double start = times.back();
      const int    n     = std::ceil((end - start) / largest_step - 1e-9);
      for (int k = 1; k <= n; ++k)
        times.push_back(start + (end - start) * k / n);
    };
    if (first_part > 0.)
      add(std::min(first_part, end_time), first_step);
    if (end_time > first_part)
      add(end_time, step);
    return times;
  }

  void IdealBodyParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Shape");
    shape.add_entries(prm);
    prm.leave_subsection();
    gait.add_parameters(prm);
    prm.add_parameter("Density", density, "Uniform density [kg/m^3]; 0: that of the fluid.");
    prm.add_parameter("Linear impulse", linear_impulse,
                      "Of body and fluid at the start, along x, y, z [kg m/s]; the motion of a "
                      "body at rest has none.",
                      Patterns::List(Patterns::Double(), 3, 3));
    prm.add_parameter("Angular impulse", angular_impulse,
                      "Of body and fluid at the start, about the nose [kg m^2/s].",
                      Patterns::List(Patterns::Double(), 3, 3));
  }

  void IdealBodyParameters::check(const std::string &path) const
  {
    shape.check(path + "/Shape");
    gait.check(path);
    AssertThrow(!gait.type.get().shifts_sections(),
                ExcMessage(path + "/Gait/Type: the gait <" + gait.type.get_name() +
                           "> shifts sections at fixed x, and in an ideal fluid they turn with the "
                           "spine. Give another gait, or a viscous fluid (Model)."));
    check_not_negative(path + "/Density", density,
                       "Give a positive density [kg/m^3], or 0 for that of the fluid.");
    for (const double component : linear_impulse)
      check_finite(path + "/Linear impulse", component, "Give finite numbers.");
    for (const double component : angular_impulse)
      check_finite(path + "/Angular impulse", component, "Give finite numbers.");
  }

  bool IdealBodyParameters::is_from_rest() const
  {
    const std::vector<double> zero(3, 0.);
    return linear_impulse == zero && angular_impulse == zero;
  }

  ideal::Screw IdealBodyParameters::get_impulse() const
  {
    const std::vector<double> &L = angular_impulse, &P = linear_impulse;
    return ideal::Screw({L[0], L[1], L[2], P[0], P[1], P[2]});
  }

  void IntegrationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Integration");
    prm.add_parameter("Method", method,
                      "'table': the fluid is solved for at some phases of one stroke, with "
                      "trigonometric interpolation between them, for all frequencies; 'brute "
                      "force': a new surface at each time, in steps of the output.",
                      Patterns::Selection("table|brute force"));
    prm.add_parameter("Phases", n_phases,
                      "Phases in the table [1]; of an even number only half is computed if the "
                      "stroke is symmetric.",
                      Patterns::Integer(4, 1024));
    prm.add_parameter("Tolerance", tolerance,
                      "Relative and absolute tolerance of a step of the integration of the "
                      "motion (lengths relative to the body's) [1].");
    prm.add_parameter("Torques", torques,
                      "Whether torques and powers of the joints are computed. From rest they cost "
                      "half as much as all the rest, with an impulse at the start or with "
                      "resistance several times as much.");
    prm.leave_subsection();
  }

  void IntegrationParameters::check() const
  {
    check_between("Integration/Tolerance", tolerance, 1e-14, 1e-2,
                  "Give a number from 1e-14 to 1e-2.");
  }

  IdealParameters::IdealParameters(const ParameterFile *file)
      : body_name(file ? file->get("Bodies", "fish") : "<name>")
  {
    AssertThrow(!body_name.empty() && body_name.find(',') == std::string::npos,
                ExcMessage("Bodies: the value is <" + body_name +
                           ">. Give one name: the ideal fluid has one body."));
    if (file)
      check_name("Bodies", body_name);
  }

  std::vector<RenamedEntry> IdealParameters::get_renamed_entries()
  {
    // Before bodies had names, there was one, which is called by default as its fields are.
    const std::string shape = "Body fish/Shape/", gait = "Body fish/Gait/";
    return {{"Shape/Stations", shape + "Stations/Table"},
            {"Shape/Stations file", shape + "Stations/File"},
            {"Shape/Interpolation", shape + "Stations/Interpolation"},
            {"Shape/Axes", shape + "Ellipsoid/Axes"},
            {"Surface/File", shape + "File/Name"},
            {"Gait/Type", gait + "Type", "curvature", "curvature wave"},
            {"Gait/Amplitude", gait + "Sine/Amplitude"},
            {"Gait/Curvature", gait + "Curvature wave/Amplitude"},
            {"Resistance/Drag coefficient", "Resistance/Cross-flow coefficient"},
            {"Shape", "Body fish/Shape"},
            {"Gait", "Body fish/Gait"},
            {"Body", "Body fish"}};
  }

  void IdealParameters::declare(ParameterHandler &prm)
  {
    prm.add_parameter("Model", model,
                      "The model: potential, a body of prescribed deformation in an ideal fluid "
                      "(the other one, immersed, has other parameters).",
                      Patterns::Selection("potential"));
    declare_libraries(prm);
    time.add_parameters(prm);
    prm.add_parameter("Bodies", body_name, "Name of the body, which has a section `Body <name>`.",
                      Patterns::Anything());
    prm.enter_subsection(get_body_path());
    body.add_parameters(prm);
    prm.leave_subsection();
    surface.add_parameters(prm);
    prm.enter_subsection("Fluid");
    prm.add_parameter("Density", fluid_density, "Density of the fluid [kg/m^3].");
    prm.leave_subsection();
    integration.add_parameters(prm);
    resistance.add_parameters(prm);
    output.add_parameters(prm);
    checkpoint.add_parameters(prm);
  }

  void IdealParameters::check() const
  {
    time.check();
    surface.check();
    check_positive("Fluid/Density", fluid_density, "Give a positive density [kg/m^3].");
    body.check(get_body_path());
    integration.check();
    resistance.check();
    output.check();
    checkpoint.check();
  }

  ideal::Densities IdealParameters::get_densities() const
  {
    return {fluid_density, body.density > 0. ? body.density : fluid_density};
  }
} // namespace caudal
