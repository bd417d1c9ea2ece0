#ifndef caudal_observe_tail_beat_h
#define caudal_observe_tail_beat_h

#include <caudal/observe/energy_ledger.h>

#include <string>
#include <vector>

namespace caudal
{
  /** One full cycle of the tail, from an up-crossing to the next. */
  struct TailCycle
  {
    double start     = 0; // [s]
    double end       = 0; // [s]
    double amplitude = 0; // half the distance from peak to trough [m]
  };

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
    double       tail_position;        // lateral, of the monitored point [m]
    double       forward_position;     // of the centre of mass, along the swimming direction [m]
    double       muscle_work;          // since the start [J/m]
    double       forward_momentum = 0; // m v [kg m/s per m]
    double       body_impulse     = 0; // of muscle and feedback on the body, forward [N s/m]
    double       fluid_impulse    = 0; // of the fluid, by the control volume, forward [N s/m]
    EnergyLedger ledger           = {};

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &time &tail_position &forward_position         &muscle_work;
      archive &forward_momentum &body_impulse &fluid_impulse &ledger;
    }
  };

  /** The numbers of one tail beat; swim_table.cc has their definitions, units and sources. */
  struct TailBeat
  {
    double start                 = 0;
    double period                = 0;
    double frequency             = 0;
    double amplitude             = 0;
    double speed                 = 0;
    double lengths_per_s         = 0;
    double strouhal              = 0;
    double reynolds              = 0;
    double swimming              = 0;
    double power                 = 0;
    double peak_power            = 0;
    double energy_per_metre      = 0;
    double cost_of_transport     = 0;
    double momentum_rate         = 0;
    double body_force            = 0;
    double fluid_force           = 0; // if there is a control volume
    double thrust                = 0;
    double drag                  = 0;
    double froude_efficiency     = 0;
    double towing_power          = 0;
    double quasi_propulsive      = 0;
    double muscle_work           = 0;
    double kinetic_energy        = 0;
    double elastic_energy        = 0;
    double dissipation           = 0;
    double numerical_dissipation = 0;
    double feedback              = 0;
    double external_work         = 0;
    double residual              = 0;
    double change                = 0; // of U since the beat before, relative
    bool   is_steady             = false;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &start &period &frequency &amplitude &speed &lengths_per_s &strouhal &reynolds;
      archive &swimming &power &peak_power &energy_per_metre &cost_of_transport    &momentum_rate;
      archive &body_force &fluid_force &thrust &drag &froude_efficiency &towing_power
                                                                        &quasi_propulsive;
      archive &muscle_work &kinetic_energy &elastic_energy &dissipation &numerical_dissipation;
      archive &feedback &external_work &residual &change                &is_steady;
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
