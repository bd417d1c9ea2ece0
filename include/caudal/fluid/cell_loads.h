// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_cell_loads_h
#define caudal_fluid_cell_loads_h

#include <caudal/fluid/instant.h>

#include <deal.II/base/array_view.h>
#include <deal.II/dofs/dof_handler.h>

#include <functional>

namespace caudal
{
  using namespace dealii;

  /**
   * Loads on the velocity's shape functions of each cell of this rank, at a time [N, in 2D N/m].
   * They are kept, since a step needs them several times: for the momentum equation, the power,
   * and the control volume.
   */
  template <int dim>
  class CellLoads
  {
  public:
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /** Forgets the loads: the grid has changed. */
    void clear();

    ArrayView<const double> get(const Cell &cell) const
    {
      return {&loads[cell->active_cell_index() * n_per_cell], n_per_cell};
    }

  protected:
    /** Whether the loads are those of this @p instant. */
    bool are_known(const Instant &instant) const
    {
      return is_valid && valid_instant == instant;
    }

    /**
     * Has @p add called with each locally owned cell of @p dofs and its loads, which are zero. What
     * it throws leaves the loads forgotten.
     */
    void update(const DoFHandler<dim> &dofs, const Instant &instant,
                const std::function<void(const Cell &, double *)> &add);

  private:
    bool                is_valid = false;
    Instant             valid_instant;
    std::size_t         n_per_cell;
    std::vector<double> loads; // of one active cell after the other
  };
} // namespace caudal

#endif
