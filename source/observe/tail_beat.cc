// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/tail_beat.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const double steady_change = 2; // [%]

    /** The samples of a cycle, with interpolated ones at its ends. */
    std::vector<SwimSample> cut(const std::vector<SwimSample> &samples, const TailCycle &cycle)
    {
      const auto interpolate = [&](const double time) {
        const auto after =
            std::upper_bound(samples.begin() + 1, samples.end() - 1, time,
                             [](const double t, const SwimSample &s) { return t < s.time; });
        const SwimSample &a = *(after - 1), &b = *after;
        const double      weight = (time - a.time) / (b.time - a.time);
        const auto        mix    = [&](const double x, const double y) {
          return (1 - weight) * x + weight * y;
        };
        SwimSample result;
        result.time = time;
        for (const auto member :
             {&SwimSample::tail_position, &SwimSample::forward_position, &SwimSample::muscle_work,
              &SwimSample::forward_momentum, &SwimSample::body_impulse, &SwimSample::fluid_impulse})
          result.*member = mix(a.*member, b.*member);
        for (const auto member : {&SwimSample::tail, &SwimSample::centre})
          result.*member = (1 - weight) * (a.*member) + weight * (b.*member);
        for (const auto member : {&EnergyLedger::kinetic_energy, &EnergyLedger::elastic_energy,
                                  &EnergyLedger::potential_energy, &EnergyLedger::dissipation,
                                  &EnergyLedger::numerical_dissipation, &EnergyLedger::muscle_work,
                                  &EnergyLedger::feedback_work, &EnergyLedger::external_work})
          result.ledger.*member = mix(a.ledger.*member, b.ledger.*member);
        return result;
      };
      std::vector<SwimSample> inside{interpolate(cycle.start)};
      // An end that falls on a sample would give an interval of no length.
      const double margin = 1e-9 * (cycle.end - cycle.start);
      for (const SwimSample &sample : samples)
        if (sample.time > cycle.start + margin && sample.time < cycle.end - margin)
          inside.push_back(sample);
      inside.push_back(interpolate(cycle.end));
      return inside;
    }

    /**
     * Half of the peak-to-peak excursion of the tail from the path of swimming, the line on which
     * the centre of mass moves in the beat; that of the body's axis if it does not come forward.
     */
    double compute_amplitude(const SwimmerConstants        &swimmer,
                             const std::vector<SwimSample> &samples)
    {
      const SwimSample  &first = samples.front(), &last = samples.back();
      const Tensor<1, 2> way    = last.centre - first.centre;
      const bool         goes   = way.norm() > 0.01 * swimmer.length;
      const Tensor<1, 2> path   = goes ? way / way.norm() : Point<2>::unit_vector(0);
      double             lowest = 0, highest = 0;
      for (const SwimSample &sample : samples)
      {
        const Tensor<1, 2> on_path =
            first.centre + (sample.time - first.time) / (last.time - first.time) * way;
        const Tensor<1, 2> distance  = sample.tail - on_path;
        const double       excursion = path[0] * distance[1] - path[1] * distance[0];
        lowest                       = &sample == &first ? excursion : std::min(lowest, excursion);
        highest                      = &sample == &first ? excursion : std::max(highest, excursion);
      }
      return 0.5 * (highest - lowest);
    }

    /** Thrust and drag are the positive and the negative part of the fluid's forward force. */
    void set_forces(const std::vector<SwimSample> &samples, TailBeat &beat)
    {
      const SwimSample &first = samples.front(), &last = samples.back();
      beat.momentum_rate = (last.forward_momentum - first.forward_momentum) / beat.period;
      beat.body_force    = (last.body_impulse - first.body_impulse) / beat.period;
      beat.fluid_force   = (last.fluid_impulse - first.fluid_impulse) / beat.period;
      for (std::size_t i = 1; i < samples.size(); ++i)
      {
        const SwimSample &a = samples[i - 1], &b = samples[i];
        const double      fluid_impulse =
            b.forward_momentum - a.forward_momentum - (b.body_impulse - a.body_impulse);
        (fluid_impulse > 0 ? beat.thrust : beat.drag) += std::abs(fluid_impulse) / beat.period;
        beat.peak_power =
            i == 1 ? (b.muscle_work - a.muscle_work) / (b.time - a.time)
                   : std::max(beat.peak_power, (b.muscle_work - a.muscle_work) / (b.time - a.time));
      }
    }

    void set_ledger(const EnergyLedger &start, const EnergyLedger &end, TailBeat &beat)
    {
      beat.muscle_work           = end.muscle_work - start.muscle_work;
      beat.kinetic_energy        = end.kinetic_energy - start.kinetic_energy;
      beat.elastic_energy        = end.elastic_energy - start.elastic_energy;
      beat.dissipation           = end.dissipation - start.dissipation;
      beat.numerical_dissipation = end.numerical_dissipation - start.numerical_dissipation;
      beat.feedback              = -(end.feedback_work - start.feedback_work);
      beat.external_work         = end.external_work - start.external_work;
      beat.residual              = end.get_residual(start);
    }

    /** What follows from period, amplitude, speed, power and thrust. */
    void set_dependent(const SwimmerConstants &swimmer, TailBeat &beat)
    {
      const double speed = std::abs(beat.speed);
      beat.frequency     = 1 / beat.period;
      beat.lengths_per_s = beat.speed / swimmer.length;
      beat.strouhal      = 2 * beat.frequency * beat.amplitude / speed;
      beat.reynolds      = speed * swimmer.length / swimmer.viscosity;
      beat.swimming =
          2 * M_PI * beat.frequency * beat.amplitude * swimmer.length / swimmer.viscosity;
      beat.energy_per_metre  = beat.power / speed;
      beat.cost_of_transport = beat.energy_per_metre / swimmer.mass;
      beat.froude_efficiency = beat.thrust * beat.speed / beat.power;
      const double friction  = 1.328 / std::sqrt(beat.reynolds);
      beat.towing_power = speed > 0 ? 0.5 * swimmer.fluid_density * swimmer.wetted_area * friction *
                                          speed * speed * speed
                                    : 0.;
      beat.quasi_propulsive = beat.towing_power / beat.power;
      beat.numerical_share =
          beat.dissipation != 0 ? beat.numerical_dissipation / beat.dissipation : 0.;
    }
  } // namespace

  const std::vector<TailBeatQuantity> &get_tail_beat_quantities()
  {
    static const std::vector<TailBeatQuantity> quantities = {
        {&TailBeat::start, "start", "start", "s", false, "the tail rises through its mean", 4, true,
         false},
        {&TailBeat::period, "period", "T", "s", false, "period, to the next rise", 4, true, true},
        {&TailBeat::frequency, "frequency", "f", "Hz", false, "frequency 1/T", 4, true, false},
        {&TailBeat::amplitude, "amplitude", "A", "m", false,
         "amplitude: half of peak to trough of the monitored point's excursion from the path of "
         "swimming, the line on which the centre of mass moves in the beat (domain's frame)",
         4, true, true},
        {&TailBeat::speed, "speed", "U", "m/s", false, "mean forward speed of the centre of mass",
         4, true, true},
        {&TailBeat::lengths_per_s, "speed in lengths", "U/L", "1/s", false,
         "the same in body lengths L a second", 4, true, false},
        {&TailBeat::strouhal, "Strouhal number", "St", "", false, "Strouhal number 2 f A / |U|", 4,
         true, false},
        {&TailBeat::reynolds, "Reynolds number", "Re", "", false, "Reynolds number |U| L / nu", 0,
         true, false},
        {&TailBeat::swimming, "swimming number", "Sw", "", false,
         "swimming number 2 pi f A L / nu (Gazzola et al. 2014, doi:10.1038/nphys3078)", 0, false,
         false},
        {&TailBeat::power, "power", "P", "W", true, "mean power of the muscle", 4, true, true},
        {&TailBeat::peak_power, "peak power", "Pmax", "W", true,
         "the muscle's largest power in a step", 4, true, false},
        {&TailBeat::energy_per_metre, "energy per metre", "P/U", "J/m", true,
         "muscle energy per metre of way, P / |U|", 4, false, false},
        {&TailBeat::cost_of_transport, "cost of transport", "CoT", "J/(kg m)", false,
         "P / (m |U|), m the body's mass", 5, true, false},
        {&TailBeat::momentum_rate, "momentum rate", "dmv/dt", "N", true,
         "mean net force forward, from the change of the body's momentum", 4, false, true},
        {&TailBeat::body_force, "body force", "Fbody", "N", true,
         "mean forward force of muscle and springs from outside; the fluid's is dmv/dt - Fbody", 4,
         false, true},
        {&TailBeat::fluid_force, "force by control volume", "Fvol", "N", true,
         "mean forward force of the fluid once more, by the momentum balance of Fluid/Control "
         "volume (nan once the fish has left it); dmv/dt - Fbody is to be the same",
         4, true, true},
        {&TailBeat::thrust, "thrust", "thrust", "N", true,
         "mean of the positive part of the fluid's forward force d(mv)/dt - Fbody of the steps, as "
         "Borazjani & Sotiropoulos 2008 (doi:10.1242/jeb.015644) do for pressure and friction",
         4, true, true},
        {&TailBeat::drag, "drag", "drag", "N", true,
         "mean of its negative part; thrust - drag = dmv/dt - Fbody, 0 in steady free swimming", 4,
         false, true},
        {&TailBeat::froude_efficiency, "Froude efficiency", "etaF", "", false, "thrust U / P", 4,
         false, false},
        {&TailBeat::towing_power, "towing power", "Ptow", "W", true,
         "power to tow the straight body at U, friction of a laminar flat plate only: rho/2 S "
         "1.328 Re^(-1/2) |U|^3, S the area of both sides (Blasius 1908)",
         4, false, false},
        {&TailBeat::quasi_propulsive, "quasi-propulsive efficiency", "etaQP", "", false,
         "Ptow / P (Maertens, Triantafyllou & Yue 2015, doi:10.48550/arXiv.1409.7263); a lower "
         "bound, as Ptow leaves out form drag",
         5, false, false},
        {&TailBeat::muscle_work, "muscle work", "Wmuscle", "J", true,
         "work of all muscles in the beat = dEkin + dEel + diss + feedback - external + residual",
         4, false, true},
        {&TailBeat::kinetic_energy, "kinetic energy", "dEkin", "J", true,
         "change of kinetic energy of fluid and bodies", 4, false, true},
        {&TailBeat::elastic_energy, "elastic energy", "dEel", "J", true,
         "change of elastic energy of the bodies", 4, false, true},
        {&TailBeat::dissipation, "dissipation", "diss", "J", true, "dissipated in the fluid", 4,
         false, true},
        {&TailBeat::numerical_dissipation, "numerical dissipation", "numerical", "J", true,
         "the part of diss by stabilisations (grad-div, local projection) and the time scheme", 4,
         false, true},
        {&TailBeat::numerical_share, "numerical share", "num/diss", "", false,
         "numerical dissipation / dissipation: near 1 it is not viscosity that takes the energy", 4,
         true, false},
        {&TailBeat::feedback, "feedback", "feedback", "J", true,
         "taken up by feedback springs and dampers", 4, false, true},
        {&TailBeat::external_work, "external work", "external", "J", true,
         "work on the fluid through the sides of the domain and by the body force", 4, false, true},
        {&TailBeat::residual, "residual", "residual", "J", true, "what is unaccounted for", 4,
         false, true},
        {&TailBeat::change, "change", "dU", "%", false,
         "drift: change of U since the beat before, relative to U", 2, true, false},
        {&TailBeat::steady, "steady", "steady", "", false, "1: this change is less than 2 %", 0,
         true, false}};
    return quantities;
  }

  TailBeat compute_beat(const SwimmerConstants &swimmer, const std::vector<SwimSample> &samples,
                        const TailCycle &cycle, const double previous_speed)
  {
    Assert(samples.size() > 1 && samples.front().time <= cycle.start &&
               cycle.end <= samples.back().time,
           ExcInternalError());
    const std::vector<SwimSample> inside = cut(samples, cycle);
    const SwimSample             &first = inside.front(), &last = inside.back();

    TailBeat beat;
    beat.start     = cycle.start;
    beat.period    = cycle.end - cycle.start;
    beat.amplitude = compute_amplitude(swimmer, inside);
    beat.speed     = (last.forward_position - first.forward_position) / beat.period;
    beat.power     = (last.muscle_work - first.muscle_work) / beat.period;
    set_forces(inside, beat);
    set_ledger(first.ledger, last.ledger, beat);
    set_dependent(swimmer, beat);
    beat.change = 100 * ((beat.speed - previous_speed) / std::abs(beat.speed));
    beat.steady = std::abs(beat.change) < steady_change;
    return beat;
  }

  TailBeat compute_mean(const SwimmerConstants &swimmer, const std::vector<TailBeat> &beats)
  {
    Assert(!beats.empty(), ExcInternalError());
    if (beats.size() == 1)
      return beats.front();
    TailBeat mean;
    for (const TailBeatQuantity &quantity : get_tail_beat_quantities())
      for (const TailBeat &beat : beats)
        if (quantity.is_averaged)
          mean.*quantity.value += beat.*quantity.value / beats.size();
    mean.peak_power =
        std::max_element(beats.begin(), beats.end(), [](const auto &a, const auto &b) {
          return a.peak_power < b.peak_power;
        })->peak_power;
    mean.start = beats.front().start;
    set_dependent(swimmer, mean);
    mean.change = 100 * ((beats.back().speed - beats.front().speed) / std::abs(mean.speed));
    mean.steady =
        std::all_of(beats.begin(), beats.end(), [](const TailBeat &b) { return b.steady > 0; });
    return mean;
  }
} // namespace caudal
