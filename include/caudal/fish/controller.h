// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_controller_h
#define caudal_fish_controller_h

#include <caudal/base/plugin.h>

namespace caudal
{
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

  /**
   * Decides the muscle's command at the beginning of each step. It has no memory: a rejected step
   * asks again. This base class leaves the muscle alone.
   */
  class Controller : public Plugin
  {
  public:
    virtual MuscleCommand compute_command(const SwimmerState & /*state*/) const
    {
      return MuscleCommand();
    }

    /** Whether it needs a muscle that can pull harder on one side than on the other. */
    virtual bool steers() const
    {
      return false;
    }
  };

  /** Section `Controller` of a body. */
  struct ControllerParameters
  {
    Choice<Controller> type{"Type", "none", "What commands the muscle"};

    /** Declares the section in the one that @p prm is in. */
    void add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Controller");
      type.add_parameters(prm);
      prm.leave_subsection();
    }

    /** Throws a sentence about the first bad entry; @p path is the body's section. */
    void check(const std::string &path) const
    {
      type.check(path + "/Controller");
    }
  };
} // namespace caudal

#endif
