// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_frame_h
#define caudal_viscous_frame_h

#include <caudal/fluid/instant.h>
#include <caudal/solid/solid_body.h>

namespace caudal
{
  template <int dim>
  class Operators;
  template <int dim>
  struct State;

  /**
   * Where the grid is at t^n, t^{n-1} and t^{n-2} [m], in the laboratory's frame, and with which
   * velocity it has come to t^n [m/s]. Fields hold absolute velocities; the fluid is carried
   * through the grid by what they have in excess of the grid's.
   */
  struct Frame
  {
    DomainVector origin, old_origin, older_origin, velocity;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &origin &old_origin &older_origin &velocity;
    }
  };

  /**
   * The frame at the end of a step of length @p dt [s] from @p state, see `Domain/Frame`. It
   * follows a body by dW/dt = 2 (U - W)/T + (c - c_0 - o)/T^2,  do/dt = W, U and c being the
   * velocity and place of the body's centre, which begins at c_0: a critically damped oscillator
   * that filters the beat and at a constant speed has the body where it began.
   */
  template <int dim>
  Frame move_frame(const Operators<dim> &operators, const State<dim> &state, double dt);

  /**
   * The velocity of the grid in the momentum equation of that step [m/s]: the time derivative of
   * its origin at the end, by the formula that the fluid's velocity has.
   */
  template <int dim>
  Tensor<1, dim> compute_grid_velocity(const State<dim> &state, const Frame &next, double dt);

  /** Nodal positions of a body in the grid that has this @p origin. */
  template <int dim>
  Vector<double> place_on_grid(const SolidBody<dim> &solid, const Vector<double> &positions,
                               const DomainVector &origin);
} // namespace caudal

#endif
