// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_body_force_h
#define caudal_fluid_body_force_h

#include <caudal/fluid/cell_loads.h>
#include <caudal/fluid/fluid_parameters.h>

namespace caudal
{
  /**
   * The loads int (f + rho g).N_i of the force f(x, t) on the fluid that `Fluid/Body force` gives,
   * and of the fluid's weight.
   */
  template <int dim>
  class BodyForceLoads : public CellLoads<dim>
  {
  public:
    explicit BodyForceLoads(const FluidParameters<dim> &parameters);

    /**
     * Computes the loads of the locally owned cells of @p dofs at this @p instant, unless that has
     * been done. Throws if the force is not finite, which can happen on one rank only.
     */
    void update(const DoFHandler<dim> &dofs, const Instant &instant);

    /** Whether there is no force anywhere, and are no loads. */
    bool are_zero() const
    {
      return !parameters.has_body_force();
    }

  private:
    const FluidParameters<dim> &parameters;
  };
} // namespace caudal

#endif
