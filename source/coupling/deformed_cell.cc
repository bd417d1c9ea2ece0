// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/deformed_cell.h>
#include <caudal/mesh/surface_layer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace caudal
{
  namespace
  {
    /** The part of a cell that is no face. */
    template <int dim>
    constexpr unsigned int volume = GeometryInfo<dim>::faces_per_cell;
  } // namespace

  template <int dim>
  DeformedCell<dim>::DeformedCell(const DoFHandler<dim> &dofs, const Vector<double> &positions,
                                  const double largest_spacing, const double surface_weight)
      : element(dofs.get_fe())
      , positions(positions)
      , largest_spacing(largest_spacing)
      , surface_weight(surface_weight)
      , indices(element.n_dofs_per_cell())
      , nodes(indices.size() / dim)
  {}

  template <int dim>
  void DeformedCell<dim>::reinit(const typename DoFHandler<dim>::active_cell_iterator &new_cell)
  {
    cell = new_cell;
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      const auto [component, a] = element.system_to_component_index(i);
      nodes[a][component]       = positions[indices[i]];
    }
    for (unsigned int d = 0; d < dim; ++d)
    {
      double longest = 0;
      for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
        if ((v >> d) % 2 == 0)
          longest = std::max(longest, nodes[v].distance(nodes[v + (1 << d)]));
      n[d] = std::clamp<double>(std::ceil(longest / largest_spacing), element.degree + 1, 32);
    }
    parts = {volume<dim>};
    if (surface_weight > 0)
      for (const unsigned int face : cell->face_indices())
        if (cell->at_boundary(face))
          parts.push_back(face);
  }

  template <int dim>
  unsigned int DeformedCell<dim>::n_points() const
  {
    const unsigned int in_volume =
        std::accumulate(n.begin(), n.end(), 1u, std::multiplies<unsigned int>());
    unsigned int result = 0;
    for (const unsigned int part : parts)
      result += part == volume<dim> ? in_volume
                                    : in_volume / n[GeometryInfo<dim>::unit_normal_direction[part]];
    return result;
  }

  template <int dim>
  BoundingBox<dim> DeformedCell<dim>::get_box() const
  {
    BoundingBox<dim> box(nodes);
    double           largest_side = 0;
    for (unsigned int d = 0; d < dim; ++d)
      largest_side = std::max(largest_side, box.side_length(d));
    if (element.degree > 1)
      box.extend(0.5 * largest_side); // quadratic edges reach 0.28 sides beyond in 2D, 0.48 in 3D
    return box;
  }

  template <int dim>
  FEValues<dim> &DeformedCell<dim>::get_values(const unsigned int part)
  {
    std::unique_ptr<FEValues<dim>> &values = values_by_rule[{n, part}];
    if (!values)
      values = std::make_unique<FEValues<dim>>(element,
                                               part == volume<dim>
                                                   ? make_volume_quadrature<dim>(n)
                                                   : make_surface_quadrature<dim>(part, n),
                                               update_values | update_JxW_values);
    values->reinit(cell);
    return *values;
  }

  template <int dim>
  void DeformedCell<dim>::for_each_point(
      const std::function<void(const Point<dim> &, double, const std::vector<double> &)> &operation)
  {
    std::vector<double> shape(nodes.size());
    for (const unsigned int part : parts)
    {
      const FEValues<dim> &values = get_values(part);
      const double         factor = part == volume<dim> ? 1. : surface_weight;
      for (const unsigned int r : values.quadrature_point_indices())
      {
        Point<dim> point;
        for (unsigned int a = 0; a < shape.size(); ++a)
        {
          shape[a] = values.shape_value(element.component_to_system_index(0, a), r);
          point += shape[a] * nodes[a];
        }
        operation(point, factor * values.JxW(r), shape);
      }
    }
  }

  template class DeformedCell<2>;
  template class DeformedCell<3>;
} // namespace caudal
