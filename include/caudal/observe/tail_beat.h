// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_tail_beat_h
#define caudal_observe_tail_beat_h

#include <caudal/observe/energy_ledger.h>
#include <caudal/observe/tail_cycle.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** What does not change while the fish swims; per metre of span in 2D. */
  struct SwimmerConstants
  {
    std::string name;                       // of the body
    double      length;                     // L [m]
    double      mass;                       // m [kg/m]
    double      viscosity;                  // kinematic, nu [m^2/s]
    double      fluid_density      = 1000;  // rho [kg/m^3]
    double      wetted_area        = 0;     // of both sides, S; 2 L [m] in 2D [m^2/m]
    bool        is_per_span        = true;  // two dimensions
    double      minimum_amplitude  = 0.005; // of a tail beat, in L
    bool        has_control_volume = false; // that gives the fluid's force once more
  };

  /** The state of the fish after a step; forces, energies and masses per metre of span in 2D. */
  struct SwimSample
  {
    double       time;                 // [s]
    double       tail_position;        // lateral, of the monitored point as the muscle sees it [m]
    double       forward_position;     // of the centre of mass, along the swimming direction [m]
    double       muscle_work;          // since the start [J/m]
    double       forward_momentum = 0; // m v [kg m/s per m]
    double       body_impulse     = 0; // of muscle and feedback on the body, forward [N s/m]
    double       fluid_impulse    = 0; // of the fluid, by the control volume, forward [N s/m]
    EnergyLedger ledger           = {};
    Tensor<1, 2> tail, centre; // of the monitored point and of mass: forward, lateral [m]

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &time &tail_position &forward_position                       &muscle_work;
      archive &forward_momentum &body_impulse &fluid_impulse &ledger &tail &centre;
    }
  };

  struct TailBeat;

  /** A quantity of a tail beat: all that the table on the screen and the files say about it. */
  struct TailBeatQuantity
  {
    double TailBeat::*value;
    std::string       name, symbol, unit;
    bool              is_per_span; // in two dimensions
    std::string       definition;
    int               precision; // digits after the point
    bool              is_on_screen;
    /** Whether several beats have the mean of it; what else there is follows from these means. */
    bool is_averaged;
  };

  /** All quantities of a tail beat, in the order of their columns. */
  const std::vector<TailBeatQuantity> &get_tail_beat_quantities();

  /** The numbers of one tail beat; get_tail_beat_quantities() defines them. */
  struct TailBeat
  {
    double start = 0, period = 0, frequency = 0, amplitude = 0;
    double speed = 0, lengths_per_s = 0, strouhal = 0, reynolds = 0, swimming = 0;
    double power = 0, peak_power = 0, energy_per_metre = 0, cost_of_transport = 0;
    double momentum_rate = 0, body_force = 0, fluid_force = 0, thrust = 0, drag = 0;
    double froude_efficiency = 0, towing_power = 0, quasi_propulsive = 0;
    double muscle_work = 0, kinetic_energy = 0, elastic_energy = 0, dissipation = 0;
    double numerical_dissipation = 0, numerical_share = 0, feedback = 0, external_work = 0,
           residual = 0;
    double change   = 0; // [%]
    double steady   = 0; // 1 or 0

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      for (const TailBeatQuantity &quantity : get_tail_beat_quantities())
        archive &(this->*quantity.value);
    }
  };

  /**
   * The numbers of the cycle @p cycle from @p samples that cover it: mean values are
   * differences of position, momentum and work between its interpolated ends.
   * @p previous_speed is that of the beat before [m/s].
   */
  TailBeat compute_beat(const SwimmerConstants &swimmer, const std::vector<SwimSample> &samples,
                        const TailCycle &cycle, double previous_speed);

  /**
   * One beat for several: means over them of period, amplitude, speed, powers, forces and
   * energies, from which the rest follows; the largest power of a step is that of all of
   * them, the change that from the first to the last one, relative to the mean.
   */
  TailBeat compute_mean(const SwimmerConstants &swimmer, const std::vector<TailBeat> &beats);
} // namespace caudal

#endif
