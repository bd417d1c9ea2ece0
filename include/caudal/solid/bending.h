// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_bending_h
#define caudal_solid_bending_h

#include <caudal/solid/body.h>

namespace caudal
{
  /** What it takes to bend a body as its gait prescribes, and how it follows. */
  struct Bending
  {
    /** Root mean square of the distances of the nodes from where the gait has them, over L [1]. */
    double distance = 0;
    /** The torques M(s), see compute_bending(), at s/L = 0.1, 0.2, ..., 0.9 [N m, in 2D N]. */
    std::vector<double> torques;
    /** int M dkappa/dt ds [W, in 2D W/m]: the power of a spine that bends. */
    double power = 0;
  };

  /**
   * The torque with which the gait turns the part of the body behind the section s against the part
   * before it, M(s) = sum ((X - m(s)) x F).e, over the nodes behind it: F are the forces of the
   * constraint, m is the spine, e the normal of the plane in which the body bends. By the principle
   * of virtual power the forces of a constraint that has no resultant do the work of these torques,
   * sum F.U = int M dkappa/dt ds, where sections stay as they are. A gait that shifts sections has
   * no such spine, and no torques. @p step [s] led to @p time [s].
   */
  template <int dim>
  Bending compute_bending(const Body<dim> &body, const BodyState &state, double time, double step);
} // namespace caudal

#endif
