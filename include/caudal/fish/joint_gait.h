// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_joint_gait_h
#define caudal_fish_joint_gait_h

#include <caudal/fish/gait.h>

namespace caudal
{
  /**
   * Six joints between seven sections of equal length: c_i is the angle of the joint at
   * s_i = i L/7, i = 1..6 [rad], spread over the half-width L/7 by a hat function, so that the
   * spine is twice differentiable.
   */
  class JointGait : public ModalGait
  {
  public:
    static constexpr unsigned int n_joints = 6;

    unsigned int n_coordinates() const override;

    std::string get_coordinate_name() const override
    {
      return "joint";
    }

  protected:
    /** s_i/L for the coordinate number @p i from 0 on. */
    static double get_joint(unsigned int i);

    double mode(unsigned int i, double s) const override;
  };

  /** A wave of joint angles: c_i = a_i(u_i) + gamma, u_i = psi - 2 pi k s_i/L, gamma the bias. */
  class JointWave : public JointGait
  {
  protected:
    GaitState evaluate_stroke(double psi) const override;

    /** a of the joint at s/L, and its derivative by u. */
    virtual std::pair<double, double> get_angle(double s, double u) const = 0;
  };
} // namespace caudal

#endif
