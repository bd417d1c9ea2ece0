// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_adaptation_h
#define caudal_viscous_adaptation_h

#include <caudal/viscous/operators.h>

namespace caudal
{
  // The fluid's grid is kept fine around the bodies and their wake. Fields are interpolated to a
  // new grid, and the velocities then projected to discretely divergence-free ones.

  /**
   * The state at t = 0, bodies moving with the initial flow, on a grid that is refined where bodies
   * and initial velocity need it. Collective.
   */
  template <int dim>
  State<dim> make_initial_state(Operators<dim> &operators);

  /** Whether the bodies, soon to be at their extrapolated places, come near coarser cells. */
  template <int dim>
  bool adaptation_is_needed(const Operators<dim> &operators, const State<dim> &state);

  /** Results of an adaptation of the grid. */
  struct AdaptationReport
  {
    bool         changed = false;
    unsigned int n_cells = 0;
    /** Kinetic energy and (relative to rho U volume) momentum: after minus before [J, in 2D J/m],
     * [1]. */
    double kinetic_energy_change = 0;
    double momentum_change       = 0;
  };

  /** Adapts the grid to the @p state, and brings its fields to the new grid. Collective. */
  template <int dim>
  AdaptationReport adapt(Operators<dim> &operators, State<dim> &state);
} // namespace caudal

#endif
