// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/joint_gait.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** c_i = arctan(sin u_i) + gamma, u_i = psi - 2 pi k s_i/L: the motion of the salmon's paper.
     */
    class ArctangentGait : public JointWave
    {
    protected:
      std::pair<double, double> get_angle(const double, const double u) const override
      {
        return {std::atan(std::sin(u)), std::cos(u) / (1. + std::sin(u) * std::sin(u))};
      }
    };

    const Registration<Gait, ArctangentGait>
        registration("arctangent", "a wave of joint angles, the arctangent of a sine");
  } // namespace
} // namespace caudal
