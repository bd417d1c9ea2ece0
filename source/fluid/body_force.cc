// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/fluid/body_force.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace caudal
{
  template <int dim>
  BodyForceLoads<dim>::BodyForceLoads(const FluidParameters<dim> &parameters)
      : parameters(parameters)
  {}

  template <int dim>
  void BodyForceLoads<dim>::clear()
  {
    is_valid = false;
  }

  template <int dim>
  void BodyForceLoads<dim>::update(const DoFHandler<dim> &dofs, const double new_time)
  {
    if (are_zero() || (is_valid && time == new_time))
      return;
    is_valid            = false;
    const auto &element = dofs.get_fe();
    n_per_cell          = element.n_dofs_per_cell();
    loads.assign(dofs.get_triangulation().n_active_cells() * n_per_cell, 0.);

    Expression<dim> function("Fluid/Body force", parameters.body_force, dim);
    function.set_time(new_time);
    FEValues<dim>  values(element, QGauss<dim>(element.degree + 1),
                          update_values | update_quadrature_points | update_JxW_values);
    Vector<double> force(dim);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        double *load = &loads[cell->active_cell_index() * n_per_cell];
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
        {
          function.vector_value(values.quadrature_point(q), force);
          for (unsigned int i = 0; i < n_per_cell; ++i)
            load[i] += force[element.system_to_component_index(i).first] *
                       values.shape_value(i, q) * values.JxW(q);
        }
      }
    time     = new_time;
    is_valid = true;
  }

  template class BodyForceLoads<2>;
  template class BodyForceLoads<3>;
} // namespace caudal
