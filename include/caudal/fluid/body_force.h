// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_body_force_h
#define caudal_fluid_body_force_h

#include <caudal/fluid/fluid_parameters.h>

#include <deal.II/base/array_view.h>
#include <deal.II/dofs/dof_handler.h>

namespace caudal
{
  /**
   * The loads b_i = int f.N_i [N, in 2D N/m] of the force f(x, t) on the fluid that `Fluid/Body
   * force` gives, N_i the velocity's shape functions of a cell. They are kept, since a step needs
   * them several times: for the momentum equation, the power, and the control volume.
   */
  template <int dim>
  class BodyForceLoads
  {
  public:
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    explicit BodyForceLoads(const FluidParameters<dim> &parameters);

    /** Forgets the loads: the grid has changed. */
    void clear();

    /**
     * Computes the loads of the locally owned cells of @p dofs at @p time, unless that has been
     * done. Throws if the force is not finite, which can happen on one rank only.
     */
    void update(const DoFHandler<dim> &dofs, double time);

    /** Whether there is no force anywhere, and are no loads. */
    bool are_zero() const
    {
      return !parameters.has_body_force();
    }

    ArrayView<const double> get(const Cell &cell) const
    {
      return {&loads[cell->active_cell_index() * n_per_cell], n_per_cell};
    }

  private:
    const FluidParameters<dim> &parameters;
    bool                        is_valid = false;
    double                      time     = 0;
    std::size_t                 n_per_cell;
    std::vector<double>         loads; // of one active cell after the other
  };
} // namespace caudal

#endif
