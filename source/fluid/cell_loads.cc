// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/cell_loads.h>

namespace caudal
{
  template <int dim>
  void CellLoads<dim>::clear()
  {
    is_valid = false;
  }

  template <int dim>
  void CellLoads<dim>::update(const DoFHandler<dim> &dofs, const Instant &instant,
                              const std::function<void(const Cell &, double *)> &add)
  {
    is_valid   = false;
    n_per_cell = dofs.get_fe().n_dofs_per_cell();
    loads.assign(dofs.get_triangulation().n_active_cells() * n_per_cell, 0.);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        add(cell, &loads[cell->active_cell_index() * n_per_cell]);
    valid_instant = instant;
    is_valid      = true;
  }

  template class CellLoads<2>;
  template class CellLoads<3>;
} // namespace caudal
