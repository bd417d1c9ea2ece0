#include <caudal/solid/solid_body.h>

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <sstream>

namespace caudal
{
  template <int dim>
  SolidBody<dim>::SolidBody(const SolidParameters<dim> &parameters, const double fluid_density)
    : parameters(parameters)
    , element(FE_Q<dim>(parameters.polynomial_degree), dim)
    , dof_handler(triangulation)
    , excess_density(parameters.density == 0 ? 0 : parameters.density - fluid_density)
  {
    make_body_grid(triangulation, parameters.grid, parameters.regions.size(), parameters.get_path());
    for (const auto &region : parameters.region_parameters)
      stress_models.push_back(create_stress_model<dim>(region->material));

    dof_handler.distribute_dofs(element);
    DoFRenumbering::Cuthill_McKee(dof_handler);
    initial_positions.reinit(n_dofs());
    set_up_quadrature();
    assemble_matrices();
    set_up_monitored_points();
  }

  template <int dim>
  void SolidBody<dim>::set_up_quadrature()
  {
    const QGauss<dim>  quadrature(element.degree + 1);
    const unsigned int n_scalar = element.n_dofs_per_cell() / dim;
    FEValues<dim>      values(element.base_element(0), quadrature,
                              update_values | update_gradients | update_quadrature_points | update_JxW_values);
    QuadratureData    &data = quadrature_data;
    data.n_q                = quadrature.size();
    data.shape_values.assign(data.n_q, std::vector<double>(n_scalar));
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        values.reinit(cell);
        for (unsigned int q = 0; q < data.n_q; ++q)
          {
            std::vector<Tensor<1, dim>> gradients(n_scalar);
            for (unsigned int a = 0; a < n_scalar; ++a)
              {
                data.shape_values[q][a] = values.shape_value(a, q);
                gradients[a]            = values.shape_grad(a, q);
              }
            data.shape_gradients.push_back(gradients);
            data.points.push_back(values.quadrature_point(q));
            data.weights.push_back(values.JxW(q));
            reference_volume += values.JxW(q);
          }
      }
  }

  template <int dim>
  void SolidBody<dim>::assemble_matrices()
  {
    DynamicSparsityPattern dynamic_pattern(n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, dynamic_pattern);
    pattern.copy_from(dynamic_pattern);
    mass.reinit(pattern);
    feedback_stiffness.reinit(pattern);
    feedback_damping.reinit(pattern);

    const unsigned int                   n = element.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        const RegionParameters &region = *parameters.region_parameters[cell->material_id()];
        for (unsigned int q = 0; q < quadrature_data.n_q; ++q)
          {
            const double weight =
              quadrature_data.weights[cell->active_cell_index() * quadrature_data.n_q + q];
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                {
                  const auto [component_i, a] = element.system_to_component_index(i);
                  const auto [component_j, b] = element.system_to_component_index(j);
                  if (component_i != component_j)
                    continue;
                  const double product = weight * quadrature_data.shape_values[q][a] *
                                         quadrature_data.shape_values[q][b];
                  mass.add(dofs[i], dofs[j], product);
                  if (region.feedback_directions.find("xyz"[component_i]) != std::string::npos)
                    {
                      feedback_stiffness.add(dofs[i], dofs[j], region.feedback_stiffness * product);
                      feedback_damping.add(dofs[i], dofs[j], region.feedback_damping * product);
                    }
                }
          }
      }
    inverse_mass.initialize(mass);

    for (Vector<double> *vector : {&velocity, &old_velocity, &force_density})
      vector->reinit(n_dofs());
    std::vector<std::function<double(const Point<dim> &)>> placement;
    for (unsigned int d = 0; d < dim; ++d)
      placement.push_back([&, d](const Point<dim> &s) { return place_in_domain(parameters.grid, s)[d]; });
    VectorTools::interpolate(dof_handler, FunctionFromFunctionObjects<dim>(placement), initial_positions);
    positions     = initial_positions;
    old_positions = initial_positions;
  }

  template <int dim>
  void SolidBody<dim>::set_up_monitored_points()
  {
    for (const Point<dim> &point : parameters.monitored_points)
      {
        std::ostringstream text;
        text << point;
        const MappingQ1<dim> mapping;
        // Points on the boundary count as inside.
        const double tolerance = 1e-3;
        auto         cell      = dof_handler.end();
        Point<dim>   unit_point;
        for (const auto &candidate : dof_handler.active_cell_iterators())
          if (candidate->bounding_box().point_inside(point, tolerance))
            try
              {
                const Point<dim> p = mapping.transform_real_to_unit_cell(candidate, point);
                if (GeometryInfo<dim>::is_inside_unit_cell(p, 0.05) &&
                    (cell == dof_handler.end() ||
                     GeometryInfo<dim>::distance_to_unit_cell(p) <
                       GeometryInfo<dim>::distance_to_unit_cell(unit_point)))
                  {
                    cell       = candidate;
                    unit_point = p;
                  }
              }
            catch (const typename Mapping<dim>::ExcTransformationFailed &)
              {}
        AssertThrow(cell != dof_handler.end(),
                    ExcMessage(parameters.get_path() + "/Monitored points: the point (" +
                               text.str() + ") is not inside the body. Give points in the body's " +
                               "own frame, as in its reference configuration."));
        PointValue value;
        value.dofs.resize(element.n_dofs_per_cell());
        cell->get_dof_indices(value.dofs);
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          value.shape_values.push_back(element.shape_value(i, unit_point));
        monitored.push_back(value);
      }
  }

  template <int dim>
  void SolidBody<dim>::apply_inverse_mass(Vector<double> &vector) const
  {
    inverse_mass.solve(vector);
  }

  template <int dim>
  Tensor<1, dim> SolidBody<dim>::rotate_to_domain(const Tensor<1, dim> &vector) const
  {
    return place_in_domain(parameters.grid, Point<dim>(vector)) -
           place_in_domain(parameters.grid, Point<dim>());
  }

  template <int dim>
  Tensor<1, dim> SolidBody<dim>::get_initial_axis(const unsigned int d) const
  {
    return rotate_to_domain(Point<dim>::unit_vector(d));
  }

  template <int dim>
  Vector<double> SolidBody<dim>::compute_moments(
    const std::function<Tensor<1, dim>(const Point<dim> &)> &function) const
  {
    Vector<double>                       moments(n_dofs());
    const unsigned int                   n = element.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int q = 0; q < quadrature_data.n_q; ++q)
          {
            const unsigned int   point = cell->active_cell_index() * quadrature_data.n_q + q;
            const Tensor<1, dim> value = function(quadrature_data.points[point]);
            for (unsigned int i = 0; i < n; ++i)
              {
                const auto [component, a] = element.system_to_component_index(i);
                moments[dofs[i]] += quadrature_data.weights[point] *
                                    quadrature_data.shape_values[q][a] * value[component];
              }
          }
      }
    return moments;
  }

  template <int dim>
  Tensor<1, dim> SolidBody<dim>::evaluate(const Vector<double> &field, const unsigned int index) const
  {
    AssertIndexRange(index, monitored.size());
    Tensor<1, dim> result;
    for (unsigned int i = 0; i < monitored[index].dofs.size(); ++i)
      result[element.system_to_component_index(i).first] +=
        monitored[index].shape_values[i] * field[monitored[index].dofs[i]];
    return result;
  }

  template <int dim>
  Tensor<1, dim> SolidBody<dim>::compute_mean(const Vector<double> &field) const
  {
    Vector<double> moments(n_dofs());
    mass.vmult(moments, field);
    Tensor<1, dim>                       mean;
    std::vector<bool>                    counted(n_dofs(), false);
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (!counted[dofs[i]])
            {
              mean[element.system_to_component_index(i).first] += moments[dofs[i]];
              counted[dofs[i]] = true;
            }
      }
    return mean / reference_volume;
  }

  template <int dim>
  std::vector<BoundingBox<dim>> SolidBody<dim>::compute_cell_boxes(const Vector<double> &x) const
  {
    const unsigned int                   n_nodes = element.n_dofs_per_cell() / dim;
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    std::vector<BoundingBox<dim>>        boxes;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        std::vector<Point<dim>> nodes(n_nodes);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [component, a] = element.system_to_component_index(i);
            nodes[a][component]       = x[dofs[i]];
          }
        boxes.emplace_back(nodes);
      }
    return boxes;
  }

  template class SolidBody<2>;
  template class SolidBody<3>;
} // namespace caudal
