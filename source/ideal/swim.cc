// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/swim.h>

#include <algorithm>
#include <map>

namespace caudal
{
  using namespace ideal;

  namespace
  {
    const double tolerance = 1e-9; // relative to the end: times that differ by rounding are one
  }

  Instants::Instants(const std::vector<double> &output_times, const double period)
  {
    std::map<double, std::pair<bool, bool>> all;
    for (const double time : output_times)
      all[time].first = true;
    const double end = output_times.back(), rounding = tolerance * end;
    for (unsigned int k = 0; period > 0. && k * period < end + rounding; ++k)
    {
      auto near = all.lower_bound(k * period - rounding);
      if (near == all.end() || near->first > k * period + rounding)
        near = all.insert({k * period, {false, false}}).first;
      near->second.second = true;
    }
    for (const auto &[time, flags] : all)
    {
      times.push_back(time);
      is_output.push_back(flags.first);
      ends_stroke.push_back(flags.second);
    }
  }

  Swim::Swim(const MotionProblem &problem, const Instants &instants, const bool has_torques,
             const OutputParameters &output, MotionTable &table, SurfaceOutput &surface,
             SwimState &state)
      : problem(problem)
      , instants(instants)
      , has_torques(has_torques)
      , output(output)
      , table(table)
      , surface(surface)
      , state(state)
  {
    const auto &times = instants.times;
    if (state.has_begun())
      next =
          std::upper_bound(times.begin(), times.end(), state.last.time + tolerance * times.back()) -
          times.begin();
  }

  void Swim::start(const Screw &impulse)
  {
    BodyState body;
    body.impulse = impulse;
    take(body);
  }

  BodyState Swim::integrate() const
  {
    return advance_motion(problem, state.last.body, state.last.time, instants.times[next]);
  }

  void Swim::take(const BodyState &body)
  {
    const MotionSample sample = compute_sample(problem, body, instants.times[next], has_torques);
    if (next == 0)
      state.first_centre = sample.centre;
    else
    {
      const double duration = sample.time - state.last.time;
      state.energy.add(state.last, 0.5 * duration);
      state.energy.add(sample, 0.5 * duration);
    }
    state.last = sample;
    if (instants.is_output[next])
      write(sample);
    if (instants.ends_stroke[next])
    {
      const Tensor<1, 3> direction = body.rotate(Tensor<1, 3>({1., 0., 0.}));
      state.stroke_ends.push_back({sample.centre, std::atan2(direction[1], direction[0])});
    }
    ++next;
  }

  void Swim::write(const MotionSample &sample)
  {
    if (state.n_output_times % output.statistics_interval == 0)
      table.write_row(sample, state.get_distance());
    ++state.n_output_times;
    const double end    = instants.times.back();
    const auto has_come = [&](const double time) { return sample.time >= time - tolerance * end; };
    const bool are_due  = has_come(state.next_fields);
    if (are_due || has_come(end))
      surface.write(sample, problem, state.n_fields++);
    if (are_due)
      state.next_fields += output.field_interval;
  }
} // namespace caudal
