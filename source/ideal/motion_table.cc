// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/motion_table.h>

namespace caudal::ideal
{
  MotionTable::MotionTable(const std::string &file_name, const double kept_time)
      : statistics(file_name, kept_time)
  {}

  void MotionTable::set_vector(const std::string &quantity, const std::string &unit,
                               const Tensor<1, 3> &vector)
  {
    for (unsigned int d = 0; d < 3; ++d)
      statistics.set(std::string(1, "xyz"[d]) + " of " + quantity, unit, vector[d]);
  }

  void MotionTable::set_modes(const std::string &quantity, const std::string &unit,
                              const std::vector<double> &values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      statistics.set(quantity + " of mode " + std::to_string(i + 1), unit, values[i]);
  }

  void MotionTable::write_row(const MotionSample &sample, const double distance)
  {
    statistics.set("time", "s", sample.time);
    set_vector("nose", "m", sample.body.position);
    for (unsigned int i = 0; i < 4; ++i)
      statistics.set("quaternion " + std::to_string(i), "1", sample.body.quaternion[i]);
    set_vector("centre of mass", "m", sample.centre);
    statistics.set("distance", "m", distance);
    set_vector("velocity of centre of mass", "m/s", sample.centre_velocity);
    statistics.set("speed", "m/s", sample.centre_velocity.norm());
    set_vector("angular velocity in body frame", "rad/s", get_angular(sample.velocity));
    set_vector("velocity of nose in body frame", "m/s", get_linear(sample.velocity));
    set_vector("angular impulse in body frame", "kg m^2/s", get_angular(sample.body.impulse));
    set_vector("linear impulse in body frame", "kg m/s", get_linear(sample.body.impulse));
    statistics.set("kinetic energy", "J", sample.energy);
    set_modes("coordinate", "rad", sample.coordinates);
    set_modes("torque", "N m", sample.torques);
    set_modes("power", "W", sample.powers);
    if (!sample.powers.empty())
      statistics.set("power", "W", sample.get_power());
    statistics.write_row();
  }
} // namespace caudal::ideal
