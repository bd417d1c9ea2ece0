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
    DeformationSummary summary{std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::lowest(), 0, 0};
    double             volume = 0;
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      const auto nodes       = get_cell_nodes<dim>(cell, positions);
      double     cell_volume = 0, reference_volume = 0;
      for (const auto &point : body.get_quadrature_points(cell->active_cell_index()))
      {
        const Tensor<2, dim> F    = compute_deformation_gradient(nodes, point.gradients);
        const double         J    = determinant(F);
        summary.smallest_jacobian = std::min(summary.smallest_jacobian, J);
        summary.largest_jacobian  = std::max(summary.largest_jacobian, J);
        cell_volume += point.weight * J;
        reference_volume += point.weight;
        AssertThrow(J > 0, ExcInvertedElement(J));
        summary.elastic_energy +=
            point.weight * body.get_material(cell->material_id()).strain_energy(F, point.place);
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
  std::vector<std::pair<std::string, Vector<float>>>
  compute_cell_means(const SolidBody<dim> &body, const Vector<double> &positions)
  {
    const unsigned int n_cells = body.get_triangulation().n_active_cells();
    std::vector<std::pair<std::string, Vector<float>>> result;
    result.emplace_back("J", n_cells);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        result.emplace_back(std::string("stress_") + "xyz"[i] + "xyz"[j], n_cells);
    result.emplace_back("region", n_cells);
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      const auto     nodes  = get_cell_nodes<dim>(cell, positions);
      const auto    &points = body.get_quadrature_points(cell->active_cell_index());
      double         J = 0, volume = 0, reference_volume = 0;
      Tensor<2, dim> stress;
      for (const auto &point : points)
      {
        const Tensor<2, dim> F = compute_deformation_gradient(nodes, point.gradients);
        J += determinant(F) / points.size();
        volume += point.weight * determinant(F);
        reference_volume += point.weight;
        stress +=
            body.get_material(cell->material_id()).first_piola_kirchhoff_stress(F, point.place) *
            transpose(F) / determinant(F) / static_cast<double>(points.size());
      }
      const double pressure = -body.get_cell_volume_stabilisation(cell->material_id()) *
                              reference_volume / volume * std::log(volume / reference_volume);
      for (unsigned int d = 0; d < dim; ++d)
        stress[d][d] -= pressure;
      auto       column = result.begin();
      const auto set    = [&](const double value) {
        (column++)->second[cell->active_cell_index()] = value;
      };
      set(J);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          set(stress[i][j]);
      set(cell->material_id());
    }
    return result;
  }

#define INSTANTIATE(dim)                                                                           \
  template DeformationSummary summarise_deformation(const SolidBody<dim> &,                        \
                                                    const Vector<double> &);                       \
  template std::vector<std::pair<std::string, Vector<float>>> compute_cell_means(                  \
      const SolidBody<dim> &, const Vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
