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

    void write_row(Statistics &table, const SwimState &swim, const std::string &coordinate)
    {
      const auto set_vector = [&table](const std::string &quantity, const std::string &unit,
                                       const Tensor<1, 3> &vector) {
        for (unsigned int d = 0; d < 3; ++d)
          table.set(std::string(1, "xyz"[d]) + " of " + quantity, unit, vector[d]);
      };
      const auto set_all = [&](const std::string &quantity, const std::string &unit,
                               const std::vector<double> &values) {
        for (std::size_t i = 0; i < values.size(); ++i)
          table.set(quantity + " of " + coordinate + " " + std::to_string(i + 1), unit, values[i]);
      };
      const MotionSample &sample = swim.last;
      table.set("time", "s", sample.time);
      set_vector("nose", "m", sample.body.position);
      for (unsigned int i = 0; i < 4; ++i)
        table.set("quaternion " + std::to_string(i), "1", sample.body.quaternion[i]);
      set_vector("centre of mass", "m", sample.centre);
      table.set("distance", "m", swim.get_distance());
      set_vector("velocity of centre of mass", "m/s", sample.centre_velocity);
      table.set("speed", "m/s", sample.centre_velocity.norm());
      set_vector("angular velocity in body frame", "rad/s", get_angular(sample.velocity));
      set_vector("velocity of nose in body frame", "m/s", get_linear(sample.velocity));
      set_vector("angular impulse in body frame", "kg m^2/s", get_angular(sample.body.impulse));
      set_vector("linear impulse in body frame", "kg m/s", get_linear(sample.body.impulse));
      table.set("kinetic energy", "J", sample.energy);
      set_all("coordinate", "rad", sample.coordinates);
      set_all("torque", "N m", sample.torques);
      set_all("power", "W", sample.powers);
      if (!sample.powers.empty())
        table.set("power", "W", sample.get_power());
      table.write_row();
    }
  } // namespace

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

  Swim::Swim(const MotionProblem &problem, const Instants &instants, const Gait &gait,
             const bool has_torques, const OutputParameters &output, Statistics &table,
             SurfaceOutput &surface, SwimState &state)
      : problem(problem)
      , instants(instants)
      , gait(gait)
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
      write();
    if (instants.ends_stroke[next])
    {
      const Tensor<1, 3> direction = body.rotate(Tensor<1, 3>({1., 0., 0.}));
      state.stroke_ends.push_back({sample.centre, std::atan2(direction[1], direction[0])});
    }
    ++next;
  }

  void Swim::write()
  {
    if (state.n_output_times % output.statistics_interval == 0)
      write_row(table, state, gait.get_coordinate_name());
    ++state.n_output_times;
    const double end      = instants.times.back();
    const auto   has_come = [&](const double time) {
      return state.last.time >= time - tolerance * end;
    };
    const bool are_due = has_come(state.next_fields);
    if (are_due || has_come(end))
      surface.write(state.last, problem, state.n_fields++);
    if (are_due)
      state.next_fields += output.field_interval;
  }
} // namespace caudal
