// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/energies.h>
#include <caudal/observe/guard.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** The residual of the energy ledger relative to the sum of its terms. */
    template <int dim>
    double compute_residual(const Observation<dim>     &observation,
                            const ObserverContext<dim> &context)
    {
      // A start at once is damped by the time scheme, and there is little other energy yet.
      if (observation.step_number < 10)
        return 0;
      const auto         &energies = context.others.template get<Energies<dim>>();
      const EnergyLedger &ledger = energies.get_ledger(), &start = energies.get_initial_ledger();
      const double        sum = std::abs(ledger.muscle_work) + std::abs(ledger.feedback_work) +
                         std::abs(ledger.external_work) + start.kinetic_energy +
                         ledger.kinetic_energy + std::abs(ledger.elastic_energy) +
                         std::abs(ledger.potential_energy) + ledger.dissipation;
      return std::abs(ledger.get_residual(start)) / std::max(sum, 1e-300);
    }

    /** Difference of the powers that body and fluid exchange, relative to them. */
    template <int dim>
    struct PowerDifference : public Guard<dim>
    {
      PowerDifference()
          : Guard<dim>(
                {"Largest power identity",
                 "Warn if the power of the body forces differs between fluid and body by "
                 "more than this part; 0: never [1].",
                 "the relative difference of powers", "",
                 "Body and fluid do not exchange the same power: an error in the program, "
                 "please report it."},
                1e-6,
                [](const Observation<dim> &, const BodyObservation<dim> &body) {
                  return body.report.power_identity;
                },
                50)
      {}
    };

    /** What the energy ledger leaves unaccounted for. */
    template <int dim>
    struct EnergyResidual : public Guard<dim>
    {
      EnergyResidual()
          : Guard<dim>({"Largest energy residual",
                        "Warn if what the energy ledger leaves unaccounted for exceeds this part "
                        "of its terms' sum, from the tenth step on; 0: never [1].",
                        "the energy residual", " of the ledger's sum",
                        "Steps or cells are too large for the motion: reduce Time/Step, refine the "
                        "wake (Refinement/Vorticity threshold)."},
                       0.1, compute_residual<dim>, 60)
      {}
    };

    const DimensionalRegistration<Guard, PowerDifference>
        power_difference("power identity", "difference of the exchanged powers");
    const DimensionalRegistration<Guard, EnergyResidual> energy_residual("energy residual",
                                                                         "unaccounted energy");
  } // namespace
} // namespace caudal
