// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_stroke_model_h
#define caudal_ideal_stroke_model_h

#include <caudal/ideal/swimming_shape.h>

#include <memory>

namespace caudal::ideal
{
  /** How the body and the fluid around it respond to the gait, at any instant. */
  class StrokeModel
  {
  public:
    virtual ~StrokeModel() = default;

    virtual MotionCoefficients compute_motion(double argument) = 0;
    virtual StrokeState        compute_state(double argument)  = 0;

    /** Torques of the modes together with external forces on them [N m]. */
    virtual std::vector<double> compute_torques(double argument, const Drive &drive) = 0;

    /** d(centre of mass)/dpsi in the body's frame [m]. */
    virtual Tensor<1, 3> compute_centre_rate(double argument) = 0;

    /** The potentials of Potentials::values at the surface's nodes. */
    virtual FullMatrix<double> compute_potentials(double argument) = 0;
  };

  /**
   * The model that solves for the fluid around a new surface at each instant. Rates are
   * differences over twice the @p increment of the argument.
   */
  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, double increment);
} // namespace caudal::ideal

#endif
