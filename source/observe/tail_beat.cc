#include <caudal/observe/tail_beat.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const double steady_change = 0.02;

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
        result.time             = time;
        result.tail_position    = mix(a.tail_position, b.tail_position);
        result.forward_position = mix(a.forward_position, b.forward_position);
        result.muscle_work      = mix(a.muscle_work, b.muscle_work);
        result.forward_momentum = mix(a.forward_momentum, b.forward_momentum);
        result.body_impulse     = mix(a.body_impulse, b.body_impulse);
        result.fluid_impulse    = mix(a.fluid_impulse, b.fluid_impulse);
        for (const auto member : {&EnergyLedger::kinetic_energy, &EnergyLedger::elastic_energy,
                                  &EnergyLedger::dissipation, &EnergyLedger::numerical_dissipation,
                                  &EnergyLedger::muscle_work, &EnergyLedger::feedback_work,
                                  &EnergyLedger::external_work})
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
    }
  } // namespace

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
    beat.amplitude = cycle.amplitude;
    beat.speed     = (last.forward_position - first.forward_position) / beat.period;
    beat.power     = (last.muscle_work - first.muscle_work) / beat.period;
    set_forces(inside, beat);
    set_ledger(first.ledger, last.ledger, beat);
    set_dependent(swimmer, beat);
    beat.change    = (beat.speed - previous_speed) / std::abs(beat.speed);
    beat.is_steady = std::abs(beat.change) < steady_change;
    return beat;
  }

  TailBeat compute_mean(const SwimmerConstants &swimmer, const std::vector<TailBeat> &beats)
  {
    Assert(!beats.empty(), ExcInternalError());
    if (beats.size() == 1)
      return beats.front();
    TailBeat mean;
    for (const auto member :
         {&TailBeat::period, &TailBeat::amplitude, &TailBeat::speed, &TailBeat::power,
          &TailBeat::momentum_rate, &TailBeat::body_force, &TailBeat::fluid_force,
          &TailBeat::thrust, &TailBeat::drag, &TailBeat::muscle_work, &TailBeat::kinetic_energy,
          &TailBeat::elastic_energy, &TailBeat::dissipation, &TailBeat::numerical_dissipation,
          &TailBeat::feedback, &TailBeat::external_work, &TailBeat::residual})
      for (const TailBeat &beat : beats)
        mean.*member += beat.*member / beats.size();
    mean.peak_power =
        std::max_element(beats.begin(), beats.end(), [](const auto &a, const auto &b) {
          return a.peak_power < b.peak_power;
        })->peak_power;
    mean.start = beats.front().start;
    set_dependent(swimmer, mean);
    mean.change = (beats.back().speed - beats.front().speed) / std::abs(mean.speed);
    mean.is_steady =
        std::all_of(beats.begin(), beats.end(), [](const TailBeat &b) { return b.is_steady; });
    return mean;
  }
} // namespace caudal
