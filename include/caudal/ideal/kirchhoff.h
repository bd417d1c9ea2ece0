// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_kirchhoff_h
#define caudal_ideal_kirchhoff_h

#include <caudal/ideal/stroke_model.h>

#include <boost/serialization/array.hpp>

#include <array>
#include <functional>

namespace caudal::ideal
{
  /**
   * The body in space: the impulses in its own frame, and where the frame is, x = r + R X with
   * R the rotation by the unit quaternion.
   */
  struct BodyState
  {
    Screw                 impulse; ///< (Lambda [kg m^2/s], Pi [kg m/s])
    std::array<double, 4> quaternion = {{1., 0., 0., 0.}};
    Tensor<1, 3>          position; ///< r, of the nose [m]

    /** R V */
    Tensor<1, 3> rotate(const Tensor<1, 3> &V) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &impulse &quaternion &position;
    }
  };

  /** The instant for which external forces are asked. */
  struct MotionInstant
  {
    double argument; ///< of the gait
    double rate;     ///< its rate [rad/s], or 1
    Screw  velocity; ///< (omega, v) in the body's frame
  };

  /** External forces. */
  struct Load
  {
    Screw               screw;    ///< torque about the nose and force, in the body's frame
    std::vector<double> on_modes; ///< int df.dX/dc_i; none if there are no forces [N m]
  };

  /** The external forces at an instant. */
  using ExternalForce = std::function<Load(const MotionInstant &)>;

  /** Methods to integrate the equations. */
  enum class Integrator
  {
    /**
     * Dormand and Prince's Runge-Kutta pair of order 5(4) with error control. (That of Fehlberg
     * of order 7(8) would not do: from rest, place is a mere integral over time, of which its
     * error estimate vanishes.)
     */
    adaptive,
    given_steps ///< one classical Runge-Kutta step from each instant to the next
  };

  /** See advance_motion(). */
  struct MotionProblem
  {
    StrokeModel  *model      = nullptr;
    double        rate       = 1.; ///< of the gait's argument: 2 pi f [rad/s], or 1
    double        length     = 1.; ///< a typical one, for the tolerance [m]
    double        tolerance  = 1e-9;
    Integrator    integrator = Integrator::adaptive;
    ExternalForce force      = [](const MotionInstant &) { return Load(); };
  };

  /** d(Lambda, Pi)/dt by Kirchhoff's equations, see advance_motion(). */
  Screw compute_impulse_rate(const Screw &impulse, const Screw &velocity, const Screw &external);

  /**
   * Kirchhoff's equations of a deforming body in a fluid at rest (H. Lamb, Hydrodynamics, 6th
   * ed. 1932, chapter VI; for deforming bodies e.g. E. Kanso et al., J. Nonlinear Sci. 15, 2005,
   * doi:10.1007/s00332-004-0650-9), in the body's frame:
   *
   *   Lambda' = Lambda x omega + Pi x v + tau,  Pi' = Pi x omega + f,
   *   (omega, v) = M^-1 ((Lambda, Pi) - P),  R' = R omega^,  r' = R v.
   *
   * From @p body at @p time to the state at @p end [s], with a size of steps that is chosen anew:
   * the result depends on nothing else, so that a motion can be taken up wherever it was left.
   */
  BodyState advance_motion(const MotionProblem &problem, const BodyState &body, double time,
                           double end);
} // namespace caudal::ideal

#endif
