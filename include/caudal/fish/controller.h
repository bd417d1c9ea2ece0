#ifndef caudal_fish_controller_h
#define caudal_fish_controller_h

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

namespace caudal
{
  using namespace dealii;

  /** What muscles and controllers know of the swimmer at the beginning of a step. */
  struct SwimmerState
  {
    /** t^n [s] */
    double time = 0.;
    /** Length of the coming step [s]. */
    double step = 0.;
    /** Position [m] and velocity [m/s] of the monitored point along the body
        frame's y axis, relative to the place of that point in the reference shape. */
    double lateral_position = 0.;
    double lateral_velocity = 0.;
    /** Angle [rad] by which the body has turned anticlockwise since the start, and its rate. */
    double heading  = 0.;
    double yaw_rate = 0.;
    /** Forward speed of the centre of mass [m/s]. */
    double speed = 0.;
  };

  /**
   * A muscle's activation a becomes gain a + bias. A positive bias bends the
   * tail towards +y and so turns the nose towards +y: clockwise, since the
   * body frame's x axis points from nose to tail.
   */
  struct MuscleCommand
  {
    double gain = 1.;
    double bias = 0.;
  };

  /** Decides the muscle's command at the beginning of each step. */
  class Controller
  {
  public:
    virtual ~Controller() = default;

    /** Without memory: a rejected step asks again. */
    virtual MuscleCommand compute_command(const SwimmerState &state) const = 0;
  };

  /**
   * Section `Controller` of a body.
   *
   * `none`: gain 1, bias 0.
   * `heading`: bias = K (heading - target) + D yaw rate, limited.
   * `speed`: gain = 1 + K (target - speed), between 0 and its limit.
   */
  struct ControllerParameters
  {
    std::string type = "none";

    double target_heading = 0.;
    double heading_gain   = 1.;
    double yaw_rate_gain  = 0.;
    double largest_bias   = 0.5;

    double target_speed = 0.;
    double speed_gain   = 1.;
    double largest_gain = 2.;

    /** Declares the section in the one that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the body's section. */
    void check(const std::string &path) const;
  };

  /** The controller that @p parameters describe. */
  std::unique_ptr<Controller> create_controller(const ControllerParameters &parameters);
} // namespace caudal

#endif
