// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/controller.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** Steers to a heading: bias = K (heading - target) + D yaw rate, limited. */
    class HeadingController : public Controller
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Target heading", target,
                          "Angle [rad] by which the body shall turn from its initial direction, "
                          "anticlockwise.");
        prm.add_parameter("Heading gain", gain,
                          "Bias of the activation per error of the heading [1/rad].");
        prm.add_parameter("Yaw rate gain", rate_gain,
                          "Bias of the activation per yaw rate [s/rad].");
        prm.add_parameter("Largest bias", limit,
                          "Limit of the bias's modulus [-]; 1 is the muscle's amplitude.");
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Largest bias", limit, "Give a limit that is not negative.");
      }

      MuscleCommand compute_command(const SwimmerState &state) const override
      {
        const double error = std::remainder(state.heading - target, 2. * numbers::PI);
        const double bias  = gain * error + rate_gain * state.yaw_rate;
        return {1., std::clamp(bias, -limit, limit)};
      }

      bool steers() const override
      {
        return true;
      }

    private:
      double target = 0., gain = 1., rate_gain = 0., limit = 0.5;
    };

    const Registration<Controller, HeadingController>
        registration("heading", "turns the body by a constant share of the muscle's activation");
  } // namespace
} // namespace caudal
