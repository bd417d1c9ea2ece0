// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/cell_matrices.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>

namespace caudal
{
  template <int dim>
  CellMatrices<dim>::CellMatrices(const FESystem<dim>  &velocity_element,
                                  const FE_DGP<dim>    &pressure_element,
                                  const Tensor<1, dim> &cell_size)
      : velocity_element(velocity_element)
      , cell_size(cell_size)
  {
    Triangulation<dim> cell;
    GridGenerator::hyper_rectangle(cell, Point<dim>(), Point<dim>(cell_size));

    const FiniteElement<dim> &scalar_element = velocity_element.base_element(0);
    const QGauss<dim>         quadrature(velocity_element.degree + 1);
    const UpdateFlags         flags = update_values | update_gradients | update_JxW_values;
    FEValues<dim>             velocity(velocity_element, quadrature, flags);
    FEValues<dim>             scalar(scalar_element, quadrature, flags);
    FEValues<dim>             pressure(pressure_element, quadrature, flags);
    velocity.reinit(cell.begin_active());
    scalar.reinit(cell.begin_active());
    pressure.reinit(cell.begin_active());

    const unsigned int n_u = velocity_element.n_dofs_per_cell();
    const unsigned int n_s = scalar_element.n_dofs_per_cell();
    const unsigned int n_p = pressure_element.n_dofs_per_cell();
    mass.reinit(n_s, n_s);
    stiffness.reinit(n_s, n_s);
    grad_div.reinit(n_u, n_u);
    augmentation.reinit(n_u, n_u);
    divergence.reinit(n_p, n_u);
    inverse_pressure_mass.reinit(n_p, n_p);
    values.reinit(quadrature.size(), n_s);
    gradients.assign(quadrature.size(), std::vector<Tensor<1, dim>>(n_s));
    AssertIndexRange(quadrature.size(), 64 + 1);

    FullMatrix<double>               pressure_mass(n_p, n_p);
    const FEValuesExtractors::Vector velocities(0);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const double weight = velocity.JxW(q);
      point_weight[q]     = weight;
      for (unsigned int i = 0; i < n_s; ++i)
      {
        values(q, i)    = scalar.shape_value(i, q);
        gradients[q][i] = scalar.shape_grad(i, q);
        for (unsigned int j = 0; j < n_s; ++j)
        {
          mass(i, j) += weight * scalar.shape_value(i, q) * scalar.shape_value(j, q);
          stiffness(i, j) += weight * (scalar.shape_grad(i, q) * scalar.shape_grad(j, q));
        }
      }
      for (unsigned int i = 0; i < n_u; ++i)
        for (unsigned int j = 0; j < n_u; ++j)
          grad_div(i, j) += weight * velocity[velocities].divergence(i, q) *
                            velocity[velocities].divergence(j, q);
      for (unsigned int k = 0; k < n_p; ++k)
      {
        for (unsigned int i = 0; i < n_u; ++i)
          divergence(k, i) +=
              weight * pressure.shape_value(k, q) * velocity[velocities].divergence(i, q);
        for (unsigned int l = 0; l < n_p; ++l)
          pressure_mass(k, l) += weight * pressure.shape_value(k, q) * pressure.shape_value(l, q);
      }
    }
    inverse_pressure_mass.invert(pressure_mass);
    augmentation.triple_product(inverse_pressure_mass, divergence, divergence, true, false);

    // 1, x, y, (z) about the cell's centre are orthogonal; normalise them.
    linear_values.reinit(quadrature.size(), dim + 1);
    double volume = 1;
    for (unsigned int d = 0; d < dim; ++d)
      volume *= cell_size[d];
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      linear_values(q, 0) = 1 / std::sqrt(volume);
      for (unsigned int d = 0; d < dim; ++d)
        linear_values(q, d + 1) = (quadrature.point(q)[d] - 0.5) * std::sqrt(12. / volume);
    }
  }

  template <int dim>
  void CellMatrices<dim>::get_momentum_matrix(const MomentumWeights &weights,
                                              FullMatrix<double>    &matrix) const
  {
    matrix = 0;
    if (weights.grad_div != 0)
      matrix.add(weights.grad_div, grad_div);
    if (weights.augmentation != 0)
      matrix.add(weights.augmentation, augmentation);
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < matrix.n(); ++j)
      {
        const auto [component_i, scalar_i] = velocity_element.system_to_component_index(i);
        const auto [component_j, scalar_j] = velocity_element.system_to_component_index(j);
        if (component_i == component_j)
          matrix(i, j) += weights.inertia * mass(scalar_i, scalar_j) +
                          weights.viscosity * stiffness(scalar_i, scalar_j);
      }
  }

  template <int dim>
  typename CellMatrices<dim>::NodalVectors
  CellMatrices<dim>::get_nodal_vectors(const Vector<double> &dof_values) const
  {
    NodalVectors vectors;
    for (unsigned int i = 0; i < dof_values.size(); ++i)
    {
      const auto [component, scalar] = velocity_element.system_to_component_index(i);
      vectors[scalar][component]     = dof_values[i];
    }
    return vectors;
  }

  template <int dim>
  double CellMatrices<dim>::compute_stabilisation_weight(const NodalVectors &transport,
                                                         const double        density,
                                                         const double        stabilisation,
                                                         const double        rate) const
  {
    double largest_speed = 0;
    for (const Tensor<1, dim> &w : transport)
      largest_speed = std::max(largest_speed, w.norm());
    const double h = cell_size.norm() / std::sqrt(dim);
    return density * stabilisation / std::max({largest_speed / h, rate, 1e-300});
  }

  template <int dim>
  void CellMatrices<dim>::get_convection_matrix(const Vector<double> &transport,
                                                const double density, const double stabilisation,
                                                const double rate, FullMatrix<double> &matrix) const
  {
    const unsigned int n_s = values.n(), n_q = values.m();
    const NodalVectors nodal_transport = get_nodal_vectors(transport);

    // Streamline derivatives of the shape functions and their linear moments.
    FullMatrix<double> derivatives(n_q, n_s);
    double             moments[dim + 1][27] = {};
    for (unsigned int q = 0; q < n_q; ++q)
    {
      Tensor<1, dim> w;
      for (unsigned int i = 0; i < n_s; ++i)
        w += values(q, i) * nodal_transport[i];
      for (unsigned int i = 0; i < n_s; ++i)
      {
        derivatives(q, i) = w * gradients[q][i];
        for (unsigned int k = 0; k <= dim; ++k)
          moments[k][i] += point_weight[q] * linear_values(q, k) * derivatives(q, i);
      }
    }

    const double tau = compute_stabilisation_weight(nodal_transport, density, stabilisation, rate);
    FullMatrix<double> weighted_values(n_q, n_s), weighted_derivatives(n_q, n_s);
    for (unsigned int q = 0; q < n_q; ++q)
      for (unsigned int i = 0; i < n_s; ++i)
      {
        weighted_values(q, i)      = 0.5 * density * point_weight[q] * values(q, i);
        weighted_derivatives(q, i) = tau * point_weight[q] * derivatives(q, i);
      }
    FullMatrix<double> advection(n_s, n_s);
    weighted_values.Tmmult(advection, derivatives);
    weighted_derivatives.Tmmult(matrix, derivatives);
    for (unsigned int i = 0; i < n_s; ++i)
      for (unsigned int j = 0; j < n_s; ++j)
      {
        matrix(i, j) += advection(i, j) - advection(j, i);
        for (unsigned int k = 0; k <= dim; ++k)
          matrix(i, j) -= tau * moments[k][i] * moments[k][j];
      }
  }

  template <int dim>
  double CellMatrices<dim>::compute_stabilisation_dissipation(
      const Vector<double> &velocity, const double density, const double stabilisation,
      const double rate, const Tensor<1, dim> &grid_velocity) const
  {
    const unsigned int n_s = values.n(), n_q = values.m();
    const NodalVectors u         = get_nodal_vectors(velocity);
    NodalVectors       transport = u; // through the grid
    for (unsigned int i = 0; i < n_s; ++i)
      transport[i] -= grid_velocity;
    double         squares = 0;
    Tensor<1, dim> moments[dim + 1];
    for (unsigned int q = 0; q < n_q; ++q)
    {
      Tensor<1, dim> w, derivative; // transport w and w.grad u at the point
      for (unsigned int i = 0; i < n_s; ++i)
        w += values(q, i) * transport[i];
      for (unsigned int i = 0; i < n_s; ++i)
        derivative += (w * gradients[q][i]) * u[i];
      squares += point_weight[q] * derivative.norm_square();
      for (unsigned int k = 0; k <= dim; ++k)
        moments[k] += point_weight[q] * linear_values(q, k) * derivative;
    }
    // What is left without the linear part: |k(.)|^2.
    for (const Tensor<1, dim> &moment : moments)
      squares -= moment.norm_square();
    return compute_stabilisation_weight(transport, density, stabilisation, rate) * squares;
  }

  template class CellMatrices<2>;
  template class CellMatrices<3>;
} // namespace caudal
