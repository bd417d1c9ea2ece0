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
  void BodyForceLoads<dim>::update(const DoFHandler<dim> &dofs, const Instant &instant)
  {
    if (are_zero() || this->are_known(instant))
      return;
    const auto     &element = dofs.get_fe();
    Expression<dim> function("Fluid/Body force", parameters.body_force, dim);
    function.set_time(instant.time);
    const Tensor<1, dim> origin = restrict_to<dim>(instant.origin);
    FEValues<dim>        values(element, QGauss<dim>(element.degree + 1),
                                update_values | update_quadrature_points | update_JxW_values);
    Vector<double>       force(dim);
    CellLoads<dim>::update(dofs, instant, [&](const auto &cell, double *load) {
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        if (parameters.has_body_force_function())
          function.vector_value(values.quadrature_point(q) + origin, force);
        for (const unsigned int i : values.dof_indices())
        {
          const unsigned int d = element.system_to_component_index(i).first;
          load[i] += (force[d] + parameters.density * parameters.gravity[d]) *
                     values.shape_value(i, q) * values.JxW(q);
        }
      }
    });
  }

  template class BodyForceLoads<2>;
  template class BodyForceLoads<3>;
} // namespace caudal
