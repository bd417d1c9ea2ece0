// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/joint_gait.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** c_i = A ((1 - g) + g s_i/L) sin u_i + gamma, u_i = psi - 2 pi k s_i/L. */
    class SineGait : public JointWave
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Amplitude", amplitude, "A, the amplitude of the joints [degrees].");
      }

      void check(const std::string &path) const override
      {
        check_finite(path + "/Amplitude", amplitude);
      }

    protected:
      std::pair<double, double> get_angle(const double s, const double u) const override
      {
        const double A = amplitude * numbers::PI / 180. * (1. - shared.growth + shared.growth * s);
        return {A * std::sin(u), A * std::cos(u)};
      }

    private:
      double amplitude = 30.;
    };

    const Registration<Gait, SineGait> registration("sine", "a sine wave of joint angles");
  } // namespace
} // namespace caudal
