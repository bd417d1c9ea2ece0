// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/motion_sample.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace caudal::ideal
{
  double MotionSample::get_power() const
  {
    return std::accumulate(powers.begin(), powers.end(), 0.);
  }

  MotionSample compute_sample(const MotionProblem &problem, const BodyState &body,
                              const double time, const bool has_torques)
  {
    StrokeModel      &model = *problem.model;
    const double      rate = problem.rate, argument = rate * time;
    const StrokeState state      = model.compute_state(argument);
    const StrokeState state_rate = model.compute_state_rate(argument);
    MotionSample      sample;
    sample.time        = time;
    sample.body        = body;
    sample.coordinates = state.c;
    sample.velocity    = state.motion.compute_velocity(body.impulse, rate);

    const Screw &q         = sample.velocity;
    sample.centre          = body.position + body.rotate(state.centre);
    sample.centre_velocity = body.rotate(
        get_linear(q) + cross_product_3d(get_angular(q), state.centre) + rate * state_rate.centre);
    sample.energy = 0.5 * (q * (state.motion.mass * q)) + rate * (q * state.motion.momentum) +
                    rate * rate * state.deformation_energy;
    if (has_torques)
    {
      const Load load = problem.force({argument, rate, q});
      sample.torques =
          compute_torques(state, state_rate,
                          {rate, body.impulse, compute_impulse_rate(body.impulse, q, load.screw)});
      for (std::size_t i = 0; i < sample.torques.size(); ++i)
      {
        if (!load.on_modes.empty())
          sample.torques[i] -= load.on_modes[i];
        sample.powers.push_back(sample.torques[i] * rate * state.rates[i]);
      }
    }
    return sample;
  }

  void EnergyAverages::add(const MotionSample &sample, const double weight)
  {
    duration += weight;
    energy += weight * sample.energy;
    largest_energy = std::max(largest_energy, sample.energy);
    positive_work += weight * std::max(sample.get_power(), 0.);
    for (const double power : sample.powers)
      gross_work += weight * std::abs(power);
    largest_torques.resize(sample.torques.size(), 0.);
    for (std::size_t i = 0; i < sample.torques.size(); ++i)
      largest_torques[i] = std::max(largest_torques[i], std::abs(sample.torques[i]));
  }

  EnergyAverages EnergyAverages::at_rate(const double rate) const
  {
    EnergyAverages result = *this;
    const double   square = rate * rate;
    result.energy *= square;
    result.largest_energy *= square;
    result.positive_work *= square * rate;
    result.gross_work *= square * rate;
    for (double &torque : result.largest_torques)
      torque *= square;
    return result;
  }

  EnergyAverages average_stroke(StrokeModel &model, const unsigned int n_phases,
                                const bool has_torques)
  {
    EnergyAverages averages;
    MotionProblem  problem;
    problem.model = &model;
    for (unsigned int k = 0; k < n_phases; ++k)
      averages.add(
          compute_sample(problem, BodyState(), 2. * numbers::PI * k / n_phases, has_torques),
          1. / n_phases);
    return averages;
  }
} // namespace caudal::ideal
