// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/elasticity.h>

#include <cmath>
#include <limits>

namespace caudal
{
  template <int dim>
  DeformationSummary summarise_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions)
  {
    const auto        &data = body.get_quadrature_data();
    DeformationSummary summary{std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::lowest(), 0, 0};
    double             volume = 0;
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      const auto nodes       = get_cell_nodes<dim>(cell, positions);
      double     cell_volume = 0, reference_volume = 0;
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point = cell->active_cell_index() * data.n_q + q;
        const Tensor<2, dim> F = compute_deformation_gradient(nodes, data.shape_gradients[point]);
        const double         J = determinant(F);
        summary.smallest_jacobian = std::min(summary.smallest_jacobian, J);
        summary.largest_jacobian  = std::max(summary.largest_jacobian, J);
        cell_volume += data.weights[point] * J;
        reference_volume += data.weights[point];
        AssertThrow(J > 0, ExcInvertedElement(J));
        summary.elastic_energy +=
            data.weights[point] *
            body.get_material(cell->material_id()).strain_energy(F, data.points[point]);
      }
      volume += cell_volume;
      const double log_J = std::log(cell_volume / reference_volume);
      summary.elastic_energy += 0.5 * body.get_cell_volume_stabilisation(cell->material_id()) *
                                reference_volume * log_J * log_J;
    }
    summary.volume_change = volume / body.get_reference_volume() - 1;
    return summary;
  }

  template <int dim>
  CellDeformation compute_cell_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions)
  {
    const auto        &data    = body.get_quadrature_data();
    const unsigned int n_cells = body.get_triangulation().n_active_cells();
    CellDeformation    result;
    result.jacobian.reinit(n_cells);
    result.region.reinit(n_cells);
    const std::string axes = "xyz";
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      const auto     nodes = get_cell_nodes<dim>(cell, positions);
      double         J = 0, volume = 0, reference_volume = 0;
      Tensor<2, dim> stress;
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point = cell->active_cell_index() * data.n_q + q;
        const Tensor<2, dim> F = compute_deformation_gradient(nodes, data.shape_gradients[point]);
        J += determinant(F) / data.n_q;
        volume += data.weights[point] * determinant(F);
        reference_volume += data.weights[point];
        stress += body.get_material(cell->material_id())
                      .first_piola_kirchhoff_stress(F, data.points[point]) *
                  transpose(F) / determinant(F) / data.n_q;
      }
      const double pressure = -body.get_cell_volume_stabilisation(cell->material_id()) *
                              reference_volume / volume * std::log(volume / reference_volume);
      for (unsigned int d = 0; d < dim; ++d)
        stress[d][d] -= pressure;
      result.jacobian[cell->active_cell_index()] = J;
      result.region[cell->active_cell_index()]   = cell->material_id();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
        {
          Vector<float> &component =
              result.cauchy_stress[std::string("stress_") + axes[i] + axes[j]];
          if (component.size() == 0)
            component.reinit(n_cells);
          component[cell->active_cell_index()] = stress[i][j];
        }
    }
    return result;
  }

#define INSTANTIATE(dim)                                                                           \
  template DeformationSummary summarise_deformation(const SolidBody<dim> &,                        \
                                                    const Vector<double> &);                       \
  template CellDeformation compute_cell_deformation(const SolidBody<dim> &, const Vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
