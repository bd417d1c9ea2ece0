// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/endurance_curve.h>

#include <algorithm>
#include <cmath>

namespace caudal::passage
{
  double EnduranceBranch::compute_endurance(const double speed) const
  {
    return std::exp(intercept + slope * (is_exponential ? speed : std::log(speed)));
  }

  double EnduranceBranch::compute_speed(const double duration) const
  {
    // A branch on which the endurance is the same at all speeds goes up to its end.
    if (slope == 0.)
      return std::log(duration) <= intercept ? highest : 0.;
    const double f     = (std::log(duration) - intercept) / slope;
    const double speed = is_exponential ? f : std::exp(f);
    return speed < lowest ? 0. : std::min(speed, highest);
  }

  std::optional<double> EnduranceBranch::compute_best_speed(const double velocity,
                                                            const double slowest) const
  {
    double best = highest;
    if (is_exponential)
      best = velocity - 1. / slope;
    else if (slope < -1.)
      best = velocity * slope / (slope + 1.);
    best = std::min(std::max({best, lowest, slowest}), highest);
    return best > velocity ? std::optional<double>(best) : std::nullopt;
  }

  EnduranceCurve::EnduranceCurve(std::vector<EnduranceBranch> branches_,
                                 const double shortest_duration, const double longest_duration)
      : branches(std::move(branches_))
      , shortest_duration(shortest_duration)
      , longest_duration(longest_duration)
      , fastest(compute_speed(shortest_duration))
      , slowest(compute_speed(longest_duration))
  {}

  double EnduranceCurve::compute_endurance(const double speed) const
  {
    double longest = 0.;
    for (const EnduranceBranch &branch : branches)
      if (branch.lowest <= speed && speed <= branch.highest)
        longest = std::max(longest, branch.compute_endurance(speed));
    return longest;
  }

  double EnduranceCurve::compute_speed(const double duration) const
  {
    double largest = 0.;
    for (const EnduranceBranch &branch : branches)
      largest = std::max(largest, branch.compute_speed(duration));
    return largest;
  }

  std::optional<Effort> EnduranceCurve::compute_best_effort(const double velocity) const
  {
    std::optional<Effort> best;
    double                largest_distance = 0.;
    for (const EnduranceBranch &branch : branches)
      if (const auto speed = branch.compute_best_speed(velocity, slowest))
      {
        const double endurance = branch.compute_endurance(*speed);
        const double distance  = (*speed - velocity) * endurance;
        if (distance > largest_distance)
        {
          largest_distance = distance;
          best             = {*speed, endurance};
        }
      }
    return best;
  }

  double EnduranceCurve::compute_distance(const double velocity) const
  {
    const auto best = velocity < fastest ? compute_best_effort(velocity) : std::nullopt;
    return best ? (best->speed - velocity) * best->endurance : 0.;
  }
} // namespace caudal::passage
