// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_flow_scales_h
#define caudal_viscous_flow_scales_h

#include <caudal/viscous/parameters.h>

namespace caudal
{
  /** How fast and how large a flow is, as far as its parameters tell. */
  struct FlowScales
  {
    double speed  = 0; ///< [m/s]; 0: not known
    double length = 0; ///< of the longest body, without bodies the domain's shortest side [m]

    /** Whether the speed is that of a swimmer whose beat, and so its speed, is a result. */
    bool is_guess = false;

    /**
     * The coefficient of the grad-div term, U L/10 [m^2/s], or 1 m^2/s if U is not known. More
     * stiffens the cells that the body's faces cut (prm/benchmarks/README.md); for bodies that
     * are resolved by the grid gamma = O(U L) is sound (Olshanskii et al. 2009,
     * doi:10.1016/j.cma.2009.09.005).
     */
    double get_grad_div() const
    {
      return speed > 0 ? 0.1 * speed * length : 1;
    }
  };

  template <int dim>
  using Bodies = std::vector<std::unique_ptr<const Body<dim>>>;

  /** A speed at which the body is likely to swim [m/s]: a length a second if its beat is a result.
   */
  template <int dim>
  double estimate_swimming_speed(const Body<dim> &body);

  /**
   * The speed is the largest of those of inflow sides, of the initial velocity and of the bodies
   * that swim.
   */
  template <int dim>
  FlowScales estimate_scales(const RunParameters<dim> &parameters, const Bodies<dim> &bodies);
} // namespace caudal

#endif
