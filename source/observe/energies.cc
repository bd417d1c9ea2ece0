// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/energies.h>

#include <caudal/fluid/external_forces.h>

namespace caudal
{
  namespace
  {
    const DimensionalRegistration<Observer, Energies>
        registration("energies", "energies, works and dissipation");

    /** Energy of the mass that the body has in excess of the fluid's [J, in 2D J/m]. */
    template <int dim>
    double compute_excess_kinetic_energy(const SolidBody<dim> &solid,
                                         const Vector<double> &velocity)
    {
      return 0.5 * solid.get_excess_density() *
             solid.get_mass_matrix().matrix_norm_square(velocity);
    }
  } // namespace

  template <int dim>
  void Energies<dim>::start(const Observation<dim> &observation, const ObserverContext<dim> &)
  {
    update(observation);
    initial_ledger = ledger;
  }

  template <int dim>
  void Energies<dim>::observe_step(const Observation<dim> &observation,
                                   const ObserverContext<dim> &)
  {
    update(observation);
  }

  template <int dim>
  void Energies<dim>::update(const Observation<dim> &observation)
  {
    const StepReport<dim> &report = observation.report;
    Powers                 now;
    now.numerical_dissipation =
        report.flow.grad_div_dissipation +
        compute_stabilisation_dissipation(observation.space, observation.fluid.velocity,
                                          report.rate, report.grid_velocity);
    now.dissipation = report.flow.viscous_dissipation + now.numerical_dissipation;
    now.external    = compute_external_power(observation.space, observation.fluid,
                                             observation.get_instant(), report.grid_velocity);
    for (const auto &body : observation.bodies)
      now.external -= body.report.power_on_sides;
    const double half_step = 0.5 * observation.step;
    ledger.dissipation += half_step * (last.dissipation + now.dissipation) + report.damping;
    ledger.numerical_dissipation +=
        half_step * (last.numerical_dissipation + now.numerical_dissipation) + report.damping;
    ledger.external_work += half_step * (last.external + now.external);
    last = now;

    ledger.kinetic_energy = report.flow.kinetic_energy;
    ledger.elastic_energy = ledger.potential_energy = ledger.muscle_work = ledger.feedback_work = 0;
    for (const auto &[body, state, body_report] : observation.bodies)
    {
      ledger.kinetic_energy += compute_excess_kinetic_energy(body.get_solid(), state.velocity);
      ledger.elastic_energy += body_report.deformation.elastic_energy;
      ledger.potential_energy += body.get_potential_energy(state);
      ledger.muscle_work += state.muscle_work;
      ledger.feedback_work += state.feedback_work;
    }
  }

  template <int dim>
  void Energies<dim>::set_body_columns(const Observation<dim> &observation, const unsigned int b,
                                       Statistics &statistics) const
  {
    const auto &[body, state, report] = observation.bodies[b];
    const std::string prefix = body.get_name() + ": ", energy = get_extensive_unit<dim>("J");
    statistics.set(prefix + "muscle power", get_extensive_unit<dim>("W"), report.muscle_power);
    statistics.set(prefix + "muscle work", energy, state.muscle_work);
    statistics.set(prefix + "elastic energy", energy, report.deformation.elastic_energy);
    statistics.set(prefix + "feedback work", energy, state.feedback_work);
    if (observation.space.get_parameters().gravity.norm() > 0.)
      statistics.set(prefix + "potential energy", energy, body.get_potential_energy(state));
  }

  template <int dim>
  void Energies<dim>::set_columns(const Observation<dim> &observation, Statistics &statistics) const
  {
    const std::string energy = get_extensive_unit<dim>("J");
    statistics.set("kinetic energy", energy, ledger.kinetic_energy);
    statistics.set("dissipation", energy, ledger.dissipation);
    statistics.set("numerical dissipation", energy, ledger.numerical_dissipation);
    statistics.set("external work", energy, ledger.external_work);
    statistics.set("energy residual", energy, ledger.get_residual(initial_ledger));
    double identity = 0;
    for (const auto &body : observation.bodies)
      identity = std::max(identity, body.report.power_identity);
    statistics.set("power identity", "", identity);
  }

  template <int dim>
  void Energies<dim>::exchange_state(StateArchive &archive)
  {
    archive &ledger &initial_ledger &last;
  }

  template class Energies<2>;
  template class Energies<3>;
} // namespace caudal
