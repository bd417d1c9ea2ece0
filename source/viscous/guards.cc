#include <caudal/viscous/guards.h>

#include <cmath>

namespace caudal
{
  void GuardParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Guards");
    prm.add_parameter(
        "Largest area change", largest_area_change,
        "Warn if a body's area (volume) has changed by more than this part; 0: never. "
        "The body is incompressible: a change is an error of the coupling [1].");
    prm.add_parameter("Smallest J", smallest_jacobian,
                      "Warn if the volume ratio J falls below this anywhere in a body; 0: never "
                      "[1].");
    prm.add_parameter("Largest J", largest_jacobian,
                      "Warn if J exceeds this anywhere in a body; 0: never [1].");
    prm.add_parameter("Largest tether displacement", largest_tether_displacement,
                      "Warn if feedback springs let a node go further than this from its place, in "
                      "cells of the finest fluid grid; 0: never [1].");
    prm.add_parameter("Largest power identity", largest_power_identity,
                      "Warn if the power of the body forces differs between fluid and body by more "
                      "than this part; 0: never [1].");
    prm.add_parameter("Largest energy residual", largest_energy_residual,
                      "Warn if what the energy ledger leaves unaccounted for exceeds this part of "
                      "its terms' sum, from the tenth step on; 0: never [1].");
    prm.leave_subsection();
  }

  void GuardParameters::check() const
  {
    const auto check_limit = [](const char *entry, const double value) {
      AssertThrow(std::isfinite(value) && value >= 0,
                  ExcMessage(std::string("Guards/") + entry + ": the value is " +
                             std::to_string(value) + ". Give a positive limit, or 0 for none."));
    };
    check_limit("Largest area change", largest_area_change);
    check_limit("Smallest J", smallest_jacobian);
    check_limit("Largest J", largest_jacobian);
    check_limit("Largest tether displacement", largest_tether_displacement);
    check_limit("Largest power identity", largest_power_identity);
    check_limit("Largest energy residual", largest_energy_residual);
  }

  template <int dim>
  Guards<dim>::Guards(const GuardParameters &parameters)
      : parameters(parameters)
  {}

  template <int dim>
  void Guards<dim>::warn(const Limit &limit, const double value, const double allowed,
                         const double time, Log &log)
  {
    if (++counts[limit.what] == 1)
      log << "Warning: at t = " << time << " s " << limit.what << " is " << value << limit.unit
          << " (Guards/" << limit.entry << " = " << allowed << "). " << limit.hint << std::endl;
  }

  template <int dim>
  double Guards<dim>::compute_tether_displacement(const Observation<dim>     &observation,
                                                  const BodyObservation<dim> &body) const
  {
    const SolidBody<dim> &solid   = body.body.get_solid();
    const unsigned int    finest  = observation.lattice.get_finest_level();
    double                largest = 0;
    for (const auto &node : solid.get_nodes())
      for (unsigned int d = 0; d < dim; ++d)
        if (solid.get_feedback_stiffness().diag_element(node[d]) > 0)
          largest = std::max(largest, std::abs(body.state.positions[node[d]] -
                                               solid.get_initial_positions()[node[d]]) /
                                          observation.lattice.get_cell_size(finest)[d]);
    return largest;
  }

  template <int dim>
  void Guards<dim>::check_body(const Observation<dim>     &observation,
                               const BodyObservation<dim> &body, Log &log)
  {
    const double              time        = observation.time;
    const std::string         name        = "of body " + body.body.get_name();
    const DeformationSummary &deformation = body.report.deformation;
    const char *const         volume_hint =
        "Volume errors of the interpolated motion add up: use a finer fluid grid, the kernel "
        "dirac, or Body/Region/Cell volume stabilisation.";
    const auto exceeds = [](const double value, const double allowed) {
      return allowed > 0 && value > allowed;
    };
    if (exceeds(std::abs(deformation.volume_change), parameters.largest_area_change))
      warn({"Largest area change", "the area change " + name, "", volume_hint},
           deformation.volume_change, parameters.largest_area_change, time, log);
    if (deformation.smallest_jacobian < parameters.smallest_jacobian)
      warn({"Smallest J", "the smallest J " + name, "", volume_hint}, deformation.smallest_jacobian,
           parameters.smallest_jacobian, time, log);
    if (exceeds(deformation.largest_jacobian, parameters.largest_jacobian))
      warn({"Largest J", "the largest J " + name, "", volume_hint}, deformation.largest_jacobian,
           parameters.largest_jacobian, time, log);
    const double displacement = compute_tether_displacement(observation, body);
    if (exceeds(displacement, parameters.largest_tether_displacement))
      warn({"Largest tether displacement", "the displacement of the springs " + name, " cells",
            "Where springs are to hold a part in its place, increase Body/Region/Feedback "
            "stiffness."},
           displacement, parameters.largest_tether_displacement, time, log);
    if (exceeds(body.report.power_identity, parameters.largest_power_identity))
      warn({"Largest power identity", "the relative difference of powers " + name, "",
            "Body and fluid do not exchange the same power: an error in the program, please "
            "report it."},
           body.report.power_identity, parameters.largest_power_identity, time, log);
  }

  template <int dim>
  void Guards<dim>::check(const Observation<dim> &observation, const EnergyLedger &ledger,
                          const EnergyLedger &start, Log &log)
  {
    const double time = observation.time;
    for (const auto &body : observation.bodies)
      check_body(observation, body, log);
    const double scale = std::abs(ledger.muscle_work) + std::abs(ledger.feedback_work) +
                         std::abs(ledger.external_work) + start.kinetic_energy +
                         ledger.kinetic_energy + std::abs(ledger.elastic_energy) +
                         ledger.dissipation;
    const double residual = std::abs(ledger.get_residual(start)) / std::max(scale, 1e-300);
    ++n_steps;
    if (parameters.largest_energy_residual > 0 && residual > parameters.largest_energy_residual &&
        n_steps >= n_starting_steps)
      warn({"Largest energy residual", "the energy residual", " of the ledger's sum",
            "Steps or cells are too large for the motion: reduce Time/Step, refine the wake "
            "(Refinement/Vorticity threshold)."},
           residual, parameters.largest_energy_residual, time, log);
  }

  template <int dim>
  void Guards<dim>::print_summary(Log &log) const
  {
    for (const auto &[what, count] : counts)
      log << "Warnings: " << what << " was outside of its limit in " << count
          << (count == 1 ? " step." : " steps.") << std::endl;
  }

  template class Guards<2>;
  template class Guards<3>;
} // namespace caudal
