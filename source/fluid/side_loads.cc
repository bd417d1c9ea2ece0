// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/side_loads.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    /** The outer normal of the side with this boundary id. */
    template <int dim>
    Tensor<1, dim> get_normal(const unsigned int side)
    {
      return (side % 2 == 0 ? -1. : 1.) * Point<dim>::unit_vector(side / 2);
    }
  } // namespace

  template <int dim>
  SideLoads<dim>::SideLoads(const Conditions &conditions)
      : conditions(conditions)
      , has_tractions(std::any_of(conditions.begin(), conditions.end(), [](const auto &condition) {
        return condition->make_traction(get_normal<dim>(0), 0.) != nullptr;
      }))
  {}

  template <int dim>
  void SideLoads<dim>::update(const DoFHandler<dim> &dofs, const Instant &instant)
  {
    if (are_zero() || this->are_known(instant))
      return;
    std::vector<std::unique_ptr<Function<dim>>> tractions;
    for (unsigned int side = 0; side < conditions.size(); ++side)
      tractions.push_back(conditions[side]->make_traction(get_normal<dim>(side), instant.time));

    const auto          &element = dofs.get_fe();
    const Tensor<1, dim> origin  = restrict_to<dim>(instant.origin);
    FEFaceValues<dim>    values(element, QGauss<dim - 1>(element.degree + 1),
                                update_values | update_quadrature_points | update_JxW_values);
    CellLoads<dim>::update(dofs, instant, [&](const auto &cell, double *load) {
      for (const unsigned int f : cell->face_indices())
      {
        if (!cell->at_boundary(f) || !tractions[cell->face(f)->boundary_id()])
          continue;
        const Function<dim> &traction = *tractions[cell->face(f)->boundary_id()];
        values.reinit(cell, f);
        for (const unsigned int q : values.quadrature_point_indices())
          for (const unsigned int i : values.dof_indices())
            load[i] += traction.value(values.quadrature_point(q) + origin,
                                      element.system_to_component_index(i).first) *
                       values.shape_value(i, q) * values.JxW(q);
      }
    });
  }

  template class SideLoads<2>;
  template class SideLoads<3>;
} // namespace caudal
