// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/controller.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    /** Keeps a speed: gain = 1 + K (target - speed), between 0 and its limit. */
    class SpeedController : public Controller
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Target speed", target, "Forward speed to reach [m/s].");
        prm.add_parameter("Speed gain", gain,
                          "Change of the muscle's gain per error of the speed [s/m].");
        prm.add_parameter("Largest gain", limit, "Upper limit of the muscle's gain [-].");
      }

      void check(const std::string &path) const override
      {
        check_value(limit >= 1., path + "/Largest gain", limit,
                    "Give at least 1, the gain without any error.");
      }

      MuscleCommand compute_command(const SwimmerState &state) const override
      {
        return {std::clamp(1. + gain * (target - state.speed), 0., limit), 0.};
      }

    private:
      double target = 0., gain = 1., limit = 2.;
    };

    const Registration<Controller, SpeedController> registration("speed",
                                                                 "scales the muscle's activation");
  } // namespace
} // namespace caudal
