// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_energy_ledger_h
#define caudal_observe_energy_ledger_h

namespace caudal
{
  /**
   * Energies of the fluid and of all bodies [J; per metre of span in 2D, J/m]:
   * energies at a time, works and dissipation since the start. They obey
   *   muscle work + external work = change of kinetic, elastic and potential energy
   *                 + dissipation - feedback work + residual,
   * the power balance that follows from testing the equations of fluid and
   * bodies with the velocity (Griffith & Luo 2017, doi:10.1002/cnm.2888,
   * section 2), integrated over time.
   */
  struct EnergyLedger
  {
    double kinetic_energy        = 0; // of the fluid and of the bodies' excess mass
    double elastic_energy        = 0;
    double potential_energy      = 0; // of the bodies' excess weight
    double dissipation           = 0; // by viscosity and numerically
    double numerical_dissipation = 0; // of it: by stabilisations and by the time scheme
    double muscle_work           = 0; // done on the bodies
    double feedback_work         = 0; // of springs and dampers on the bodies
    double external_work         = 0; // compute_external_power()

    /** What is unaccounted for from @p start on: changes of the grid, errors of the time scheme. */
    double get_residual(const EnergyLedger &start) const
    {
      return muscle_work - start.muscle_work + external_work - start.external_work + feedback_work -
             start.feedback_work -
             (kinetic_energy - start.kinetic_energy + elastic_energy - start.elastic_energy +
              potential_energy - start.potential_energy + dissipation - start.dissipation);
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &kinetic_energy &elastic_energy &potential_energy;
      archive &dissipation                    &numerical_dissipation;
      archive &muscle_work &feedback_work     &external_work;
    }
  };
} // namespace caudal

#endif
