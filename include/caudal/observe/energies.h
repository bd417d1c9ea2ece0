// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_energies_h
#define caudal_observe_energies_h

#include <caudal/observe/energy_ledger.h>
#include <caudal/observe/observer.h>

namespace caudal
{
  /**
   * Columns with energies, works and powers, the ledger that sums them up, and how far the powers
   * that bodies and fluid exchange are the same. Powers of the fluid
   * are integrated by the trapezoidal rule; the works of bodies come with their states.
   */
  template <int dim>
  class Energies : public Observer<dim>
  {
  public:
    Energies()
        : Observer<dim>(60)
    {}

    void start(const Observation<dim> &, const ObserverContext<dim> &) override;
    void observe_step(const Observation<dim> &, const ObserverContext<dim> &) override;
    void set_body_columns(const Observation<dim> &, unsigned int body, Statistics &) const override;
    void set_columns(const Observation<dim> &, Statistics &) const override;
    void exchange_state(StateArchive &archive) override;

    const EnergyLedger &get_ledger() const
    {
      return ledger;
    }
    /** The ledger at the start. */
    const EnergyLedger &get_initial_ledger() const
    {
      return initial_ledger;
    }

  private:
    /** Powers at a time [W, in 2D W/m]. */
    struct Powers
    {
      double dissipation = 0, numerical_dissipation = 0, external = 0;

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &dissipation &numerical_dissipation &external;
      }
    };

    EnergyLedger ledger, initial_ledger;
    Powers       last; // at the end of the last step

    void update(const Observation<dim> &observation);
  };
} // namespace caudal

#endif
