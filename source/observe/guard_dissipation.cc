// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/energies.h>
#include <caudal/observe/guard.h>

namespace caudal
{
  namespace
  {
    /** The part of the fluid's dissipation since the start that is numerical. */
    template <int dim>
    double compute_numerical_share(const Observation<dim>     &observation,
                                   const ObserverContext<dim> &context)
    {
      const EnergyLedger &ledger = context.others.template get<Energies<dim>>().get_ledger();
      // A start at once is damped by the time scheme.
      return observation.step_number < 10 || ledger.dissipation <= 0
                 ? 0
                 : ledger.numerical_dissipation / ledger.dissipation;
    }

    /** How much of the flow's losses is not that of the fluid's viscosity. */
    template <int dim>
    struct NumericalDissipation : public Guard<dim>
    {
      NumericalDissipation()
          : Guard<dim>(
                {"Largest numerical dissipation",
                 "Warn if more than this part of the dissipation in the fluid is numerical "
                 "(stabilisations, time scheme), from the tenth step on; 0: never [1].",
                 "the numerical part", " of the dissipation",
                 "Not viscosity but the grid takes most of the energy: friction and wake "
                 "are those of a thicker fluid. Use finer cells (Domain/Levels), or a larger "
                 "Fluid/Kinematic viscosity."},
                0.5, compute_numerical_share<dim>, 70)
      {}
    };

    const DimensionalRegistration<Guard, NumericalDissipation>
        registration("numerical dissipation", "dissipation by the numerical method");
  } // namespace
} // namespace caudal
