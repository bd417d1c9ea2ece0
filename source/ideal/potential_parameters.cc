#include <caudal/ideal/potential_parameters.h>

namespace caudal
{
  namespace
  {
    /** Throws a sentence unless the value is finite and @p ok. */
    void check_value(const std::string &entry, const double value, const bool ok,
                     const std::string &remedy)
    {
      AssertThrow(std::isfinite(value) && ok,
                  ExcMessage(entry + ": the value is " + Patterns::Tools::to_string(value) +
                             ". Give " + remedy + "."));
    }
  } // namespace

  void OutputSchedule::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("End time", end_time, "Simulated time [s].");
    prm.add_parameter("Step", step,
                      "Time between two rows of output [s]. The motion itself is integrated as "
                      "finely as Integration/Tolerance asks.");
    prm.add_parameter("First step", first_step, "The same in the first part [s].");
    prm.add_parameter("First part", first_part,
                      "How long the first part is [s]; 1 s with steps of 0.001 s is the paper's "
                      "dynamic start.");
    prm.leave_subsection();
  }

  void OutputSchedule::check() const
  {
    check_value("Time/End time", end_time, end_time > 0., "a positive time [s]");
    check_value("Time/Step", step, step > 0., "a positive time [s]");
    check_value("Time/First step", first_step, first_step > 0., "a positive time [s]");
    check_value("Time/First part", first_part, first_part >= 0., "a time, or 0 for none [s]");
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

  void PotentialBodyParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Body");
    prm.add_parameter("Density", density, "Uniform density [kg/m^3]; 0: that of the fluid.");
    prm.add_parameter("Linear impulse", linear_impulse,
                      "Of body and fluid at the start, along x, y, z [kg m/s]; the motion of a "
                      "body at rest has none.",
                      Patterns::List(Patterns::Double(), 3, 3));
    prm.add_parameter("Angular impulse", angular_impulse, "The same about the nose [kg m^2/s].",
                      Patterns::List(Patterns::Double(), 3, 3));
    prm.leave_subsection();
  }

  void PotentialBodyParameters::check() const
  {
    check_value("Body/Density", density, density >= 0.,
                "a positive density [kg/m^3], or 0 for that of the fluid");
    for (const double component : linear_impulse)
      check_value("Body/Linear impulse", component, true, "finite numbers");
    for (const double component : angular_impulse)
      check_value("Body/Angular impulse", component, true, "finite numbers");
  }

  bool PotentialBodyParameters::is_from_rest() const
  {
    const std::vector<double> zero(3, 0.);
    return linear_impulse == zero && angular_impulse == zero;
  }

  ideal::Screw PotentialBodyParameters::get_impulse() const
  {
    ideal::Screw impulse;
    for (unsigned int d = 0; d < 3; ++d)
    {
      impulse[d]     = angular_impulse[d];
      impulse[3 + d] = linear_impulse[d];
    }
    return impulse;
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
    check_value("Integration/Tolerance", tolerance, tolerance >= 1e-14 && tolerance <= 1e-2,
                "a number from 1e-14 to 1e-2");
  }

  void PotentialParameters::declare(ParameterHandler &prm)
  {
    prm.add_parameter("Model", model,
                      "The model: potential, a body of prescribed deformation in an ideal fluid "
                      "(the other one, immersed, has other parameters).",
                      Patterns::Selection("potential"));
    declare_libraries(prm);
    time.add_parameters(prm);
    shape.add_parameters(prm);
    surface.add_parameters(prm);
    gait.add_parameters(prm);
    prm.enter_subsection("Fluid");
    prm.add_parameter("Density", fluid_density, "Density of the fluid [kg/m^3].");
    prm.leave_subsection();
    body.add_parameters(prm);
    integration.add_parameters(prm);
    resistance.add_parameters(prm);
    output.add_parameters(prm);
    checkpoint.add_parameters(prm);
  }

  void PotentialParameters::check() const
  {
    time.check();
    shape.check();
    surface.check();
    gait.check();
    check_value("Fluid/Density", fluid_density, fluid_density > 0., "a positive density [kg/m^3]");
    body.check();
    integration.check();
    resistance.check();
    output.check();
    checkpoint.check();
  }

  ideal::Densities PotentialParameters::get_densities() const
  {
    return {fluid_density, body.density > 0. ? body.density : fluid_density};
  }
} // namespace caudal
