// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/joint_gait.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  unsigned int JointGait::n_coordinates() const
  {
    return n_joints;
  }

  double JointGait::get_joint(const unsigned int i)
  {
    return (i + 1.) / (n_joints + 1.);
  }

  double JointGait::mode(const unsigned int i, const double s) const
  {
    const double half_width = length / (n_joints + 1);
    const double x          = std::clamp((s - length * get_joint(i)) / half_width, -1., 1.);
    return 0.5 + x - 0.5 * x * std::abs(x);
  }

  GaitState JointWave::evaluate_stroke(const double psi) const
  {
    GaitState state;
    for (unsigned int i = 0; i < n_joints; ++i)
    {
      const double s             = get_joint(i);
      const auto [angle, by_psi] = get_angle(s, psi - 2. * numbers::PI * shared.wave_number * s);
      state.c.push_back(angle + shared.bias * numbers::PI / 180.);
      state.rates.push_back(by_psi);
    }
    return state;
  }
} // namespace caudal
