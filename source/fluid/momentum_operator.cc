#include <caudal/fluid/momentum_operator.h>

#include <caudal/base/expression.h>

#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

namespace caudal
{
  template <int dim>
  MomentumOperator<dim>::MomentumOperator(const FluidSpace<dim> &space)
    : space(space)
  {}

  template <int dim>
  void MomentumOperator<dim>::reinit()
  {
    const DoFHandler<dim> &velocity_dofs = space.velocity_dofs, &pressure_dofs = space.pressure_dofs;
    const IndexSet        &owned_velocities = velocity_dofs.locally_owned_dofs();
    const IndexSet        &owned_pressures  = pressure_dofs.locally_owned_dofs();
    IndexSet               relevant;
    DoFTools::extract_locally_relevant_dofs(velocity_dofs, relevant);

    TrilinosWrappers::SparsityPattern pattern(owned_velocities, owned_velocities, relevant,
                                              space.get_communicator());
    DoFTools::make_sparsity_pattern(velocity_dofs, pattern, space.homogeneous_constraints, false,
                                    space.get_triangulation().locally_owned_subdomain());
    pattern.compress();
    constant_matrix.reinit(pattern);
    matrix.reinit(pattern);
    constant_matrix_is_valid = false;
    matrix_is_constant       = false;

    const AffineConstraints<double>      no_constraints;
    std::vector<types::global_dof_index> rows(pressure_dofs.get_fe().n_dofs_per_cell());
    std::vector<types::global_dof_index> columns(velocity_dofs.get_fe().n_dofs_per_cell());
    TrilinosWrappers::SparsityPattern divergence_pattern(owned_pressures, owned_velocities,
                                                         space.get_communicator(), columns.size());
    const auto for_each_cell = [&](const auto &operation) {
      for (const auto &cell : velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(columns);
            typename DoFHandler<dim>::active_cell_iterator(*cell, &pressure_dofs)
              ->get_dof_indices(rows);
            operation(cell->level());
          }
    };
    for_each_cell([&](const unsigned int) {
      no_constraints.add_entries_local_to_global(rows, space.homogeneous_constraints, columns,
                                                 divergence_pattern);
    });
    divergence_pattern.compress();
    divergence_matrix.reinit(divergence_pattern);
    for_each_cell([&](const unsigned int level) {
      no_constraints.distribute_local_to_global(space.get_cell_matrices(level).get_divergence(),
                                                rows, space.homogeneous_constraints, columns,
                                                divergence_matrix);
    });
    divergence_matrix.compress(VectorOperation::add);
  }

  template <int dim>
  void MomentumOperator<dim>::assemble_constant_matrix(const MomentumWeights &weights)
  {
    if (constant_matrix_is_valid && weights == constant_weights)
      return;
    const unsigned int                   n = space.velocity_element.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n);
    std::vector<FullMatrix<double>>      level_matrices;
    for (unsigned int level = 0; level < space.get_triangulation().n_global_levels(); ++level)
      {
        level_matrices.emplace_back(n, n);
        space.get_cell_matrices(level).get_momentum_matrix(weights, level_matrices.back());
      }
    constant_matrix = 0;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          space.homogeneous_constraints.distribute_local_to_global(level_matrices[cell->level()],
                                                                   dofs, constant_matrix);
        }
    constant_matrix.compress(VectorOperation::add);
    constant_weights         = weights;
    constant_matrix_is_valid = true;
    matrix_is_constant       = false;
  }

  template <int dim>
  bool MomentumOperator<dim>::assemble(const MomentumStep &step,
                                       const FieldVector  &velocity,
                                       const FieldVector  &pressure,
                                       FieldVector        &residual)
  {
    assemble_constant_matrix(step.weights);
    const bool matrix_changes = step.transport != nullptr || !matrix_is_constant;
    if (matrix_changes)
      matrix.copy_from(constant_matrix);
    matrix_is_constant = step.transport == nullptr;
    residual           = 0;

    const FluidParameters<dim> &parameters = space.get_parameters();
    const FESystem<dim>        &element    = space.velocity_element;
    const unsigned int          n = element.n_dofs_per_cell(), n_s = element.base_element(0).n_dofs_per_cell();
    const unsigned int          n_p = space.pressure_element.n_dofs_per_cell();
    const auto   body_force = make_expression<dim>("Fluid/Body force", parameters.body_force, dim);
    const bool   has_body_force = parameters.body_force.find_first_not_of("0; ") != std::string::npos;
    const double rate           = step.weights.inertia / parameters.density;
    body_force->set_time(step.time);

    FullMatrix<double>                   cell_matrix(n, n), convection(n_s, n_s), full_convection(n, n);
    Vector<double>                       cell_residual(n), values(n), transport(n), product(n);
    Vector<double>                       pressure_values(n_p);
    std::vector<types::global_dof_index> dofs(n);
    FEValues<dim> force_values(element, QGauss<dim>(3),
                               update_values | update_quadrature_points | update_JxW_values);

    // cell_residual -= weight * C(w) u, C acting on each component.
    const auto subtract_convection = [&](const double weight) {
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto [component_i, scalar_i] = element.system_to_component_index(i);
          for (unsigned int j = 0; j < n; ++j)
            if (element.system_to_component_index(j).first == component_i)
              cell_residual[i] -=
                weight * convection(scalar_i, element.system_to_component_index(j).second) * values[j];
        }
    };

    std::vector<FullMatrix<double>> implicit_matrices, old_matrices;
    for (unsigned int level = 0; level < space.get_triangulation().n_global_levels(); ++level)
      {
        implicit_matrices.emplace_back(n, n);
        old_matrices.emplace_back(n, n);
        space.get_cell_matrices(level).get_momentum_matrix(step.weights, implicit_matrices.back());
        space.get_cell_matrices(level).get_momentum_matrix(step.old_weights, old_matrices.back());
      }

    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const CellMatrices<dim> &matrices = space.get_cell_matrices(cell->level());
          cell->get_dof_indices(dofs);
          cell_residual = 0;

          if (step.inertia_history != nullptr)
            {
              cell->get_dof_values(*step.inertia_history, values);
              for (unsigned int i = 0; i < n; ++i)
                {
                  const auto [component_i, scalar_i] = element.system_to_component_index(i);
                  for (unsigned int j = 0; j < n; ++j)
                    if (element.system_to_component_index(j).first == component_i)
                      cell_residual[i] -=
                        matrices.get_mass()(scalar_i, element.system_to_component_index(j).second) *
                        values[j];
                }
            }
          if (step.old_velocity != nullptr)
            {
              cell->get_dof_values(*step.old_velocity, values);
              old_matrices[cell->level()].vmult(product, values);
              cell_residual -= product;
            }
          for (const auto &[old, weight] : step.old_convection)
            {
              cell->get_dof_values(*old, values);
              matrices.get_convection_matrix(values, parameters.density,
                                             parameters.convection_stabilisation, rate, convection);
              if (cell->at_boundary())
                add_outflow_terms(cell, values, convection);
              subtract_convection(weight);
            }

          typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs)
            ->get_dof_values(pressure, pressure_values);
          matrices.get_divergence().Tvmult_add(cell_residual, pressure_values);

          cell->get_dof_values(velocity, values);
          implicit_matrices[cell->level()].vmult(product, values);
          cell_residual -= product;
          if (step.transport != nullptr)
            {
              cell->get_dof_values(*step.transport, transport);
              matrices.get_convection_matrix(transport, parameters.density,
                                             parameters.convection_stabilisation, rate, convection);
              if (cell->at_boundary())
                add_outflow_terms(cell, transport, convection);
              subtract_convection(1);
              for (unsigned int i = 0; i < n; ++i)
                {
                  const auto [component_i, scalar_i] = element.system_to_component_index(i);
                  for (unsigned int j = 0; j < n; ++j)
                    {
                      const auto [component_j, scalar_j] = element.system_to_component_index(j);
                      full_convection(i, j) =
                        component_i == component_j ? convection(scalar_i, scalar_j) : 0;
                    }
                }
              space.homogeneous_constraints.distribute_local_to_global(full_convection, dofs, matrix);
            }
          if (has_body_force)
            {
              force_values.reinit(cell);
              for (unsigned int q = 0; q < force_values.n_quadrature_points; ++q)
                {
                  const Point<dim> &point = force_values.quadrature_point(q);
                  check_finite("Fluid/Body force", parameters.body_force, *body_force, point);
                  for (unsigned int i = 0; i < n; ++i)
                    cell_residual[i] +=
                      body_force->value(point, element.system_to_component_index(i).first) *
                      force_values.shape_value(i, q) * force_values.JxW(q);
                }
            }
          space.homogeneous_constraints.distribute_local_to_global(cell_residual, dofs, residual);
        }
    matrix.compress(VectorOperation::add);
    residual.compress(VectorOperation::add);
    return matrix_changes;
  }

  template <int dim>
  void MomentumOperator<dim>::add_outflow_terms(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const Vector<double>                                 &transport,
    FullMatrix<double>                                   &convection) const
  {
    const FESystem<dim> &element    = space.velocity_element;
    const auto           conditions = space.get_parameters().get_boundary_conditions();
    const auto          &scalar     = element.base_element(0);
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          conditions[cell->face(f)->boundary_id()] == BoundaryCondition::outflow)
        {
          const QGauss<dim - 1> face_quadrature(3);
          const Quadrature<dim> quadrature = QProjector<dim>::project_to_face(
            ReferenceCells::get_hypercube<dim>(), face_quadrature, f);
          const Tensor<1, dim> &h = space.get_cell_size(cell->level());
          double                area = 1;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != f / 2)
              area *= h[d];
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              double normal_velocity = 0;
              for (unsigned int i = 0; i < transport.size(); ++i)
                if (element.system_to_component_index(i).first == f / 2)
                  normal_velocity += (f % 2 == 0 ? -1 : 1) * transport[i] *
                                     scalar.shape_value(element.system_to_component_index(i).second,
                                                        quadrature.point(q));
              // The skew-symmetric form lacks 1/2 (w.n) u.v on the side; where
              // the flow reverses, that term would feed energy.
              if (space.get_parameters().backflow_stabilisation)
                normal_velocity = std::max(normal_velocity, 0.);
              const double factor = 0.5 * space.get_parameters().density * normal_velocity * area *
                                    face_quadrature.weight(q);
              for (unsigned int i = 0; i < convection.m(); ++i)
                for (unsigned int j = 0; j < convection.n(); ++j)
                  convection(i, j) += factor * scalar.shape_value(i, quadrature.point(q)) *
                                      scalar.shape_value(j, quadrature.point(q));
            }
        }
  }

  template <int dim>
  void MomentumOperator<dim>::compute_divergence(const FieldVector &velocity,
                                                 FieldVector       &result) const
  {
    Vector<double> values(space.velocity_element.n_dofs_per_cell());
    Vector<double> moments(space.pressure_element.n_dofs_per_cell());
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_values(velocity, values);
          space.get_cell_matrices(cell->level()).get_divergence().vmult(moments, values);
          typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs)
            ->set_dof_values(moments, result);
        }
  }

  template <int dim>
  void MomentumOperator<dim>::apply_inverse_pressure_mass(FieldVector &vector) const
  {
    const unsigned int n = space.pressure_element.n_dofs_per_cell();
    Vector<double>     values(n), result(n);
    for (const auto &cell : space.pressure_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_values(vector, values);
          space.get_cell_matrices(cell->level()).get_inverse_pressure_mass().vmult(result, values);
          cell->set_dof_values(result, vector);
        }
  }

  template <int dim>
  void MomentumOperator<dim>::append_entries(Triplets &entries) const
  {
    for (const auto row : matrix.locally_owned_range_indices())
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        entries.add(row, entry->column(), entry->value());
  }

  template class MomentumOperator<2>;
  template class MomentumOperator<3>;
} // namespace caudal
