#include <caudal/base/factory.h>
#include <caudal/fish/controller.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    class NoController : public Controller
    {
    public:
      MuscleCommand compute_command(const SwimmerState &) const override
      {
        return MuscleCommand();
      }
    };

    class HeadingController : public Controller
    {
    public:
      explicit HeadingController(const ControllerParameters &p)
          : target(p.target_heading)
          , gain(p.heading_gain)
          , rate_gain(p.yaw_rate_gain)
          , limit(p.largest_bias)
      {}

      MuscleCommand compute_command(const SwimmerState &state) const override
      {
        const double error = std::remainder(state.heading - target, 2 * numbers::PI);
        const double bias  = gain * error + rate_gain * state.yaw_rate;
        return {1., std::clamp(bias, -limit, limit)};
      }

    private:
      const double target, gain, rate_gain, limit;
    };

    class SpeedController : public Controller
    {
    public:
      explicit SpeedController(const ControllerParameters &p)
          : target(p.target_speed)
          , gain(p.speed_gain)
          , limit(p.largest_gain)
      {}

      MuscleCommand compute_command(const SwimmerState &state) const override
      {
        return {std::clamp(1. + gain * (target - state.speed), 0., limit), 0.};
      }

    private:
      const double target, gain, limit;
    };

    const Factory<Controller, const ControllerParameters &> &get_factory()
    {
      using Parameters = ControllerParameters;
      static const Factory<Controller, const Parameters &> factory(
          "controller",
          {{"none", [](const Parameters &) { return std::make_unique<NoController>(); }},
           {"heading", [](const Parameters &p) { return std::make_unique<HeadingController>(p); }},
           {"speed", [](const Parameters &p) { return std::make_unique<SpeedController>(p); }}});
      return factory;
    }
  } // namespace

  void ControllerParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Controller");
    prm.add_parameter("Type", type,
                      "'heading' turns the body by a constant share of the muscle's activation; "
                      "'speed' scales the activation; 'none' does neither.",
                      Patterns::Selection(get_factory().get_names()));
    prm.add_parameter("Target heading", target_heading,
                      "Angle [rad] by which the body shall turn from its initial direction, "
                      "anticlockwise.");
    prm.add_parameter("Heading gain", heading_gain,
                      "Bias of the activation per error of the heading [1/rad].");
    prm.add_parameter("Yaw rate gain", yaw_rate_gain,
                      "Bias of the activation per yaw rate [s/rad].");
    prm.add_parameter("Largest bias", largest_bias,
                      "Limit of the bias's modulus [-]; 1 is the muscle's amplitude.");
    prm.add_parameter("Target speed", target_speed, "Forward speed to reach [m/s].");
    prm.add_parameter("Speed gain", speed_gain,
                      "Change of the muscle's gain per error of the speed [s/m].");
    prm.add_parameter("Largest gain", largest_gain, "Upper limit of the muscle's gain [-].");
    prm.leave_subsection();
  }

  void ControllerParameters::check(const std::string &path) const
  {
    const auto bad = [&path](const std::string &entry, const double value) {
      return path + "/Controller/" + entry + ": the value is " + Patterns::Tools::to_string(value) +
             ". ";
    };
    AssertThrow(largest_bias >= 0., ExcMessage(bad("Largest bias", largest_bias) +
                                               "Give a limit that is not negative."));
    AssertThrow(largest_gain >= 1., ExcMessage(bad("Largest gain", largest_gain) +
                                               "Give at least 1, the gain without any error."));
  }

  std::unique_ptr<Controller> create_controller(const ControllerParameters &parameters)
  {
    return get_factory().create(parameters.type, parameters);
  }
} // namespace caudal
