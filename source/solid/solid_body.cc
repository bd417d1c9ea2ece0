// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/expression.h>
#include <caudal/mesh/surface_layer.h>
#include <caudal/solid/solid_body.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace caudal
{
  template <int dim>
  Tensor<1, dim> sum_up(const SolidBody<dim> &body, const Vector<double> &forces)
  {
    Tensor<1, dim> sum;
    for (const auto &node : body.get_nodes())
      sum += get_value(forces, node);
    return sum;
  }

  template <int dim>
  Vector<double> compute_excess_weight(const SolidBody<dim> &body, const Tensor<1, dim> &gravity)
  {
    Vector<double> acceleration(body.n_dofs()), weight(body.n_dofs());
    for (const auto &node : body.get_nodes())
      set_value(acceleration, node, body.get_excess_density() * gravity);
    body.get_mass_matrix().vmult(weight, acceleration);
    return weight;
  }

  template <int dim>
  SolidBody<dim>::SolidBody(const SolidParameters<dim> &parameters, const Surroundings &fluid)
      : parameters(parameters)
      , element(FE_Q<dim>(parameters.polynomial_degree), dim)
      , excess_density(parameters.density == 0 ? 0 : parameters.density - fluid.density)
  {
    AssertThrow(fluid.cell > 0. || !parameters.grid.has_automatic_elements(),
                ExcMessage(parameters.get_path() +
                           "/Shape/Elements: they are automatic, which is by the fluid's cells, "
                           "and this model has no fluid. Give numbers."));
    make_body_grid(triangulation, parameters.grid, parameters.get_element_size(fluid.cell),
                   parameters.regions, parameters.get_path());
    for (unsigned int r = 0; r < parameters.regions.size(); ++r)
    {
      materials.push_back(
          parameters.region_parameters[r]->material.create(parameters.get_region_path(r)));
      cell_volume_stabilisations.push_back(parameters.get_cell_volume_stabilisation(r));
      places.emplace_back(parameters.region_parameters[r]->place, parameters.get_region_path(r));
    }

    dof_handler.reinit(triangulation);
    dof_handler.distribute_dofs(element);
    DoFRenumbering::Cuthill_McKee(dof_handler);
    set_up_nodes();
    set_up_quadrature();
    assemble_matrices();
    for (const Point<dim> &point : parameters.monitored_points)
      add_point(point, parameters.get_path() + "/Monitored points");
  }

  template <int dim>
  void SolidBody<dim>::set_up_nodes()
  {
    reference_points.resize(n_dofs());
    fixed_dofs.assign(n_dofs(), false);
    DoFTools::map_dofs_to_support_points(MappingQ1<dim>(), dof_handler, reference_points);

    // By the unknown of the first component.
    std::map<unsigned int, Node>         all, head;
    std::map<unsigned int, unsigned int> regions;
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      const RegionParameters<dim> &region = *parameters.region_parameters[cell->material_id()];
      if (region.is_fixed())
        for (const auto dof : dofs)
          fixed_dofs[dof] = true;
      for (unsigned int a = 0; a < dofs.size() / dim; ++a)
      {
        Node node;
        for (unsigned int d = 0; d < dim; ++d)
          node[d] = dofs[element.component_to_system_index(d, a)];
        all[node[0]] = node;
        // The region that holds its points best has those that it shares with others.
        const auto [other, is_new] = regions.emplace(node[0], cell->material_id());
        if (!is_new && region.get_hold() > parameters.region_parameters[other->second]->get_hold())
          other->second = cell->material_id();
        if (cell->material_id() == 0)
          head[node[0]] = node;
      }
    }
    for (const auto &entry : all)
    {
      nodes.push_back(entry.second);
      regions_of_nodes.push_back(regions[entry.first]);
    }
    for (const auto &entry : head)
      head_nodes.push_back(entry.second);

    initial_positions.reinit(n_dofs());
    for (const Node &node : nodes)
      set_value(initial_positions, node,
                place_in_domain(parameters.grid, reference_points[node[0]]));
  }

  template <int dim>
  void SolidBody<dim>::clear_fixed_nodes(Vector<double> &force) const
  {
    for (unsigned int i = 0; i < n_dofs(); ++i)
      if (fixed_dofs[i])
        force[i] = 0;
  }

  template <int dim>
  void SolidBody<dim>::clear_fixed_nodes(SparseMatrix<double> &matrix) const
  {
    for (unsigned int i = 0; i < n_dofs(); ++i)
      if (fixed_dofs[i])
        for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
          entry->value() = 0;
  }

  template <int dim>
  bool SolidBody<dim>::has_moving_places() const
  {
    return std::any_of(parameters.region_parameters.begin(), parameters.region_parameters.end(),
                       [](const auto &region) { return region->place.moves(); });
  }

  template <int dim>
  Vector<double> SolidBody<dim>::compute_held_positions(const double time) const
  {
    Vector<double> result(initial_positions);
    if (!has_moving_places())
      return result;
    std::vector<RigidMotion<dim>> motions;
    for (const PrescribedPlace<dim> &place : places)
      motions.push_back(place.compute(time));
    for (unsigned int n = 0; n < nodes.size(); ++n)
      set_value(result, nodes[n],
                motions[regions_of_nodes[n]].apply(get_value(initial_positions, nodes[n])));
    return result;
  }

  template <int dim>
  void SolidBody<dim>::restore_fixed_nodes(Vector<double> &x, const double time) const
  {
    if (std::find(fixed_dofs.begin(), fixed_dofs.end(), true) == fixed_dofs.end())
      return;
    const Vector<double> held = compute_held_positions(time);
    for (unsigned int i = 0; i < n_dofs(); ++i)
      if (fixed_dofs[i])
        x[i] = held[i];
  }

  template <int dim>
  void SolidBody<dim>::set_up_quadrature()
  {
    FEValues<dim> values(element.base_element(0), QGauss<dim>(element.degree + 1),
                         update_values | update_gradients | update_quadrature_points |
                             update_JxW_values);
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      values.reinit(cell);
      quadrature_points.emplace_back();
      for (const unsigned int q : values.quadrature_point_indices())
      {
        QuadraturePoint point{values.quadrature_point(q), values.JxW(q), {}, {}};
        for (const unsigned int a : values.dof_indices())
        {
          point.values.push_back(values.shape_value(a, q));
          point.gradients.push_back(values.shape_grad(a, q));
        }
        quadrature_points.back().push_back(point);
        reference_volume += point.weight;
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
      const RegionParameters<dim> &region = *parameters.region_parameters[cell->material_id()];
      for (const QuadraturePoint &point : quadrature_points[cell->active_cell_index()])
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
          {
            const auto [component_i, a] = element.system_to_component_index(i);
            const auto [component_j, b] = element.system_to_component_index(j);
            if (component_i != component_j)
              continue;
            const double product = point.weight * point.values[a] * point.values[b];
            mass.add(dofs[i], dofs[j], product);
            if (region.feedback_directions.find("xyz"[component_i]) != std::string::npos)
            {
              feedback_stiffness.add(dofs[i], dofs[j], region.feedback_stiffness * product);
              feedback_damping.add(dofs[i], dofs[j], region.feedback_damping * product);
            }
          }
    }
    for (unsigned int i = 0; i < n_dofs(); ++i)
      spring_dofs.push_back(feedback_stiffness.diag_element(i) > 0.);
    add_surface_springs("Surface spring", parameters.surface_spring, feedback_stiffness);
    add_surface_springs("Surface damper", parameters.surface_damper, feedback_damping);
    assemble_coupling_mass();
    Vector<double> ones(n_dofs());
    ones = 1;
    nodal_volumes.reinit(n_dofs());
    mass.vmult(nodal_volumes, ones);
  }

  template <int dim>
  void SolidBody<dim>::add_surface_springs(const std::string &entry, const std::string &coefficient,
                                           SparseMatrix<double> &matrix) const
  {
    if (coefficient.empty())
      return;
    const std::string                    path = parameters.get_path() + "/" + entry;
    const Expression<dim>                function(path, dim == 2 ? "x,y" : "x,y,z", coefficient);
    FEFaceValues<dim>                    values(element, QGauss<dim - 1>(element.degree + 1),
                                                update_values | update_JxW_values | update_quadrature_points);
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
      {
        if (!cell->at_boundary(f))
          continue;
        values.reinit(cell, f);
        cell->get_dof_indices(dofs);
        for (const unsigned int q : values.quadrature_point_indices())
        {
          const double weight = function.value(values.quadrature_point(q));
          check_not_negative(path, weight, "Give a function that is not negative.");
          for (unsigned int i = 0; i < dofs.size(); ++i)
            for (unsigned int j = 0; j < dofs.size(); ++j)
              if (element.system_to_component_index(i).first ==
                  element.system_to_component_index(j).first)
                matrix.add(dofs[i], dofs[j],
                           weight * values.JxW(q) * values.shape_value(i, q) *
                               values.shape_value(j, q));
        }
      }
  }

  template <int dim>
  void SolidBody<dim>::assemble_coupling_mass()
  {
    const double weight = parameters.get_surface_weight();
    coupling_mass.reinit(pattern);
    coupling_mass.copy_from(mass);
    std::array<unsigned int, dim> n_points;
    n_points.fill(element.degree + 1);
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    for (const unsigned int face : GeometryInfo<dim>::face_indices())
    {
      FEValues<dim> values(element, make_surface_quadrature<dim>(face, n_points),
                           update_values | update_JxW_values);
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (!cell->at_boundary(face))
          continue;
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        for (const unsigned int i : values.dof_indices())
          for (const unsigned int j : values.dof_indices())
            if (element.system_to_component_index(i).first ==
                element.system_to_component_index(j).first)
              for (const unsigned int r : values.quadrature_point_indices())
                coupling_mass.add(dofs[i], dofs[j],
                                  weight * values.JxW(r) * values.shape_value(i, r) *
                                      values.shape_value(j, r));
      }
    }
    inverse_coupling_mass.initialize(coupling_mass);
  }

  template <int dim>
  unsigned int SolidBody<dim>::add_point(const Point<dim> &point, const std::string &path)
  {
    // Points on the boundary count as inside, also where round-off moves them out.
    const auto [cell, unit_point] = GridTools::find_active_cell_around_point(
        MappingQ1<dim>(), dof_handler, point, {}, /*tolerance=*/0.05);
    std::ostringstream text;
    text << point;
    AssertThrow(cell != dof_handler.end(),
                ExcMessage(path + ": the point (" + text.str() + ") is not inside the body. Give " +
                           "points in the body's own frame, as in its reference configuration."));
    PointValue value;
    value.dofs.resize(element.n_dofs_per_cell());
    cell->get_dof_indices(value.dofs);
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      value.shape_values.push_back(element.shape_value(i, unit_point));
    points.push_back(value);
    return points.size() - 1;
  }

  template <int dim>
  void SolidBody<dim>::apply_inverse_coupling_mass(Vector<double> &vector) const
  {
    inverse_coupling_mass.solve(vector);
  }

  template <int dim>
  void SolidBody<dim>::apply_inverse_mass(Vector<double> &vector) const
  {
    SparseDirectUMFPACK inverse;
    inverse.initialize(mass);
    inverse.solve(vector);
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
  Tensor<1, dim> SolidBody<dim>::evaluate(const Vector<double> &field,
                                          const unsigned int    index) const
  {
    AssertIndexRange(index, points.size());
    Tensor<1, dim> result;
    for (unsigned int i = 0; i < points[index].dofs.size(); ++i)
      result[element.system_to_component_index(i).first] +=
          points[index].shape_values[i] * field[points[index].dofs[i]];
    return result;
  }

  template <int dim>
  Tensor<1, dim> SolidBody<dim>::compute_mean(const Vector<double> &field) const
  {
    Tensor<1, dim> mean;
    for (const Node &node : nodes)
      for (unsigned int d = 0; d < dim; ++d)
        mean[d] += nodal_volumes[node[d]] * field[node[d]];
    return mean / reference_volume;
  }

  template <int dim>
  bool SolidBody<dim>::contains_at_start(const Point<dim> &point) const
  {
    // Back to the body's own frame: the initial placement is a rigid motion.
    const Tensor<1, dim> moved = point - place_in_domain(parameters.grid, Point<dim>());
    Point<dim>           reference;
    for (unsigned int d = 0; d < dim; ++d)
      reference[d] = moved * get_initial_axis(d);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->bounding_box().point_inside(reference) && cell->point_inside(reference))
        return true;
    return false;
  }

  template <int dim>
  std::vector<Point<dim>> get_cell_nodes(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                         const Vector<double>                                 &x)
  {
    const FiniteElement<dim>            &element = cell->get_fe();
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    std::vector<Point<dim>>              nodes(dofs.size() / dim);
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      const auto [component, a] = element.system_to_component_index(i);
      nodes[a][component]       = x[dofs[i]];
    }
    return nodes;
  }

  template <int dim>
  std::vector<BoundingBox<dim>> SolidBody<dim>::compute_cell_boxes(const Vector<double> &x) const
  {
    std::vector<BoundingBox<dim>> boxes;
    for (const auto &cell : dof_handler.active_cell_iterators())
      boxes.emplace_back(get_cell_nodes<dim>(cell, x));
    return boxes;
  }

  template class SolidBody<2>;
  template class SolidBody<3>;
  template Tensor<1, 2>          sum_up(const SolidBody<2> &, const Vector<double> &);
  template Tensor<1, 3>          sum_up(const SolidBody<3> &, const Vector<double> &);
  template Vector<double>        compute_excess_weight(const SolidBody<2> &, const Tensor<1, 2> &);
  template Vector<double>        compute_excess_weight(const SolidBody<3> &, const Tensor<1, 3> &);
  template std::vector<Point<2>> get_cell_nodes<2>(const DoFHandler<2>::active_cell_iterator &,
                                                   const Vector<double> &);
  template std::vector<Point<3>> get_cell_nodes<3>(const DoFHandler<3>::active_cell_iterator &,
                                                   const Vector<double> &);
} // namespace caudal
