// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_external_power_h
#define caudal_fluid_external_power_h

#include <caudal/fluid/fluid_state.h>

namespace caudal
{
  /**
   * The power that the fluid receives from outside, through its sides and by the body force,
   *   closed int ((-p n + mu du/dn + rho gamma (div u) n).u - rho/2 |u|^2 (u.n)) + int f.u
   * [W; per metre of span in 2D: W/m]. As in the discrete equations, outflow sides exert no
   * stress, and with `Backflow stabilisation` what flows back through them brings no energy.
   * Collective.
   */
  template <int dim>
  double compute_external_power(const FluidSpace<dim> &space, const FluidState<dim> &state,
                                double time);
} // namespace caudal

#endif
