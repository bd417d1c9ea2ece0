// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_body_state_h
#define caudal_solid_body_state_h

#include <caudal/fish/muscle.h>

#include <deal.II/lac/vector.h>

#include <boost/serialization/vector.hpp>

namespace caudal
{
  /**
   * All of a body that outlives a step: nodal values at t^n and t^{n-1}, and what its muscle
   * remembers. Works and forces are per metre of span in 2D.
   */
  struct BodyState
  {
    /** X(s, t^n) and X(s, t^{n-1}) [m], in the domain's frame. */
    Vector<double> positions, old_positions;
    /** U(s, t^n) and U(s, t^{n-1}) [m/s]. */
    Vector<double> velocity, old_velocity;
    /** Phi = M_s^-1 b at t^n: all forces on the fluid per reference volume [N/m^dim]. */
    Vector<double> force_density;
    /** The muscle's decision for the step that led to t^n; the next one goes on from its memory. */
    Contraction contraction;
    /** Work of the muscle and of the feedback forces on the body since the start [J, in 2D J/m]. */
    double muscle_work = 0, feedback_work = 0;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &positions &old_positions &velocity &old_velocity &force_density;
      archive &contraction &muscle_work                         &feedback_work;
    }
  };
} // namespace caudal

#endif
