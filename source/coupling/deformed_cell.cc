// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/coupling/deformed_cell.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace caudal
{
  namespace
  {
    /** Quadrature with the given number of Gauss points in each direction. */
    template <int dim>
    Quadrature<dim> make_quadrature(const std::array<unsigned int, dim> &n)
    {
      if constexpr (dim == 2)
        return QAnisotropic<2>(QGauss<1>(n[0]), QGauss<1>(n[1]));
      else
        return QAnisotropic<3>(QGauss<1>(n[0]), QGauss<1>(n[1]), QGauss<1>(n[2]));
    }
  } // namespace

  template <int dim>
  DeformedCell<dim>::DeformedCell(const DoFHandler<dim> &dofs, const Vector<double> &positions,
                                  const double largest_spacing)
      : element(dofs.get_fe())
      , positions(positions)
      , largest_spacing(largest_spacing)
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
  }

  template <int dim>
  unsigned int DeformedCell<dim>::n_points() const
  {
    return std::accumulate(n.begin(), n.end(), 1u, std::multiplies<unsigned int>());
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
  void DeformedCell<dim>::for_each_point(
      const std::function<void(const Point<dim> &, double, const std::vector<double> &)> &operation)
  {
    std::unique_ptr<FEValues<dim>> &values = values_by_n[n];
    if (!values)
      values = std::make_unique<FEValues<dim>>(element, make_quadrature<dim>(n),
                                               update_values | update_JxW_values);
    values->reinit(cell);
    std::vector<double> shape(nodes.size());
    for (const unsigned int r : values->quadrature_point_indices())
    {
      Point<dim> point;
      for (unsigned int a = 0; a < shape.size(); ++a)
      {
        shape[a] = values->shape_value(element.component_to_system_index(0, a), r);
        point += shape[a] * nodes[a];
      }
      operation(point, values->JxW(r), shape);
    }
  }

  template class DeformedCell<2>;
  template class DeformedCell<3>;
} // namespace caudal
