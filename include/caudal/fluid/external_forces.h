// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_external_forces_h
#define caudal_fluid_external_forces_h

#include <caudal/fluid/fluid_state.h>

#include <deal.II/base/bounding_box.h>

namespace caudal
{
  /**
   * The power that the fluid receives from outside, through its sides and by the body force,
   *   closed int ((-p n + mu du/dn + rho gamma (div u) n).u - rho/2 |u|^2 (u.n)) + int f.u
   * [W; per metre of span in 2D: W/m]. As in the discrete equations, outflow sides exert no
   * stress, and with `Backflow stabilisation` what flows back through them brings no energy.
   * In u.n there is u - w, @p grid_velocity w being that of the sides. Collective.
   */
  template <int dim>
  double compute_external_power(const FluidSpace<dim> &space, const FluidState<dim> &state,
                                const Instant &instant, const Tensor<1, dim> &grid_velocity);

  /** What the momentum balance of a control volume is made of (per metre of span in 2D). */
  template <int dim>
  struct MomentumBalance
  {
    /** rho int_V u [kg m/s per m] */
    Tensor<1, dim> momentum;
    /**
     * The forces on the fluid in V but for that of immersed bodies,
     *   closed int (-p n + mu du/dn + rho gamma (div u) n - rho u (u.n)) + int_V f [N/m],
     * the momentum that flows in among them.
     */
    Tensor<1, dim> force;
  };

  /**
   * The balance for the control volume V of all coarse cells whose centre is in @p box.
   * On its surface pressure and gradients are the means from both sides.
   * Immersed bodies in V exert the force d(momentum)/dt - force on the fluid. V moves with the
   * grid, so that there is u - w in u.n, with @p grid_velocity w.
   * Collective.
   */
  template <int dim>
  MomentumBalance<dim> compute_momentum_balance(const FluidSpace<dim>  &space,
                                                const FluidState<dim>  &state,
                                                const BoundingBox<dim> &box, const Instant &instant,
                                                const Tensor<1, dim> &grid_velocity);
} // namespace caudal

#endif
