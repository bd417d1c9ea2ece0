// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/fluid/momentum_operator.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace caudal
{
  template <int dim>
  MomentumOperator<dim>::MomentumOperator(const FluidSpace<dim> &space)
      : space(space)
  {}

  template <int dim>
  void MomentumOperator<dim>::reinit()
  {
    matrix.reinit(space.velocity_dofs, space.get_homogeneous_constraints());
    matrix_is_constant = false;
    divergence_matrix.reinit(space.pressure_dofs, space.velocity_dofs,
                             space.get_homogeneous_constraints());
    std::vector<FullMatrix<double>> divergences;
    for (unsigned int level = 0; level < space.get_triangulation().n_global_levels(); ++level)
      divergences.push_back(space.get_cell_matrices(level).get_divergence());
    divergence_matrix.set_level_matrices(std::move(divergences));
  }

  namespace
  {
    /** Scalar matrices act on each component of a cell's velocities. */
    template <int dim>
    class ComponentwiseProduct
    {
    public:
      explicit ComponentwiseProduct(const FESystem<dim> &element)
          : n_scalar(element.n_dofs_per_cell() / dim)
          , input(n_scalar)
          , output(n_scalar)
      {
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int s = 0; s < n_scalar; ++s)
            index[d].push_back(element.component_to_system_index(d, s));
      }

      /** result -= weight * matrix applied to each component of values */
      void subtract(const double weight, const FullMatrix<double> &matrix,
                    const Vector<double> &values, Vector<double> &result)
      {
        for (unsigned int d = 0; d < dim; ++d)
        {
          for (unsigned int s = 0; s < n_scalar; ++s)
            input[s] = values[index[d][s]];
          matrix.vmult(output, input);
          for (unsigned int s = 0; s < n_scalar; ++s)
            result[index[d][s]] -= weight * output[s];
        }
      }

    private:
      const unsigned int        n_scalar;
      std::vector<unsigned int> index[dim];
      Vector<double>            input, output;
    };

    /** What a cell contributes to matrix and residual of a step. */
    template <int dim>
    class CellAssembler
    {
    public:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      CellAssembler(const FluidSpace<dim> &space, const MomentumStep &step)
          : space(space)
          , step(step)
          , parameters(space.get_parameters())
          , rate(step.weights.inertia / parameters.density)
          , componentwise(space.velocity_element)
          , values(space.velocity_element.n_dofs_per_cell())
          , product(values.size())
          , transport(values.size())
          , pressures(space.pressure_element.n_dofs_per_cell())
          , convection(values.size() / dim, values.size() / dim)
          , body_force(space.get_body_force_loads(step.instant))
          , tractions(space.get_side_loads(step.instant))
          , face(space.velocity_element.base_element(0), QGauss<dim - 1>(3),
                 update_values | update_JxW_values)
      {
        for (unsigned int level = 0; level < space.get_triangulation().n_global_levels(); ++level)
        {
          implicit_matrices.emplace_back(values.size(), values.size());
          old_matrices.emplace_back(values.size(), values.size());
          space.get_cell_matrices(level).get_momentum_matrix(step.weights,
                                                             implicit_matrices.back());
          space.get_cell_matrices(level).get_momentum_matrix(step.old_weights, old_matrices.back());
        }
      }

      /** residual -= the terms known from before; += pressure, body force and tractions */
      void add_known_terms(const Cell &cell, const FieldVector &pressure, Vector<double> &residual)
      {
        const CellMatrices<dim> &matrices = space.get_cell_matrices(cell->level());
        if (step.inertia_history != nullptr)
        {
          cell->get_dof_values(*step.inertia_history, values);
          componentwise.subtract(1, matrices.get_mass(), values, residual);
        }
        if (step.old_velocity != nullptr)
        {
          cell->get_dof_values(*step.old_velocity, values);
          old_matrices[cell->level()].vmult(product, values);
          residual -= product;
        }
        for (const auto &[old, weight] : step.old_convection)
        {
          cell->get_dof_values(*old, values);
          compute_convection(cell, values);
          componentwise.subtract(weight, convection, values, residual);
        }
        Cell(*cell, &space.pressure_dofs)->get_dof_values(pressure, pressures);
        matrices.get_divergence().Tvmult_add(residual, pressures);
        if (!body_force.are_zero())
          add_loads(body_force.get(cell), residual);
        if (!tractions.are_zero())
          add_loads(tractions.get(cell), residual);
      }

      /**
       * residual -= the implicit terms of @p velocity. Returns the matrix of the convection, which
       * is that of get_implicit_matrices() besides, or none.
       */
      const FullMatrix<double> *subtract_implicit_terms(const Cell        &cell,
                                                        const FieldVector &velocity,
                                                        Vector<double>    &residual)
      {
        cell->get_dof_values(velocity, values);
        implicit_matrices[cell->level()].vmult(product, values);
        residual -= product;
        if (step.transport == nullptr)
          return nullptr;
        cell->get_dof_values(*step.transport, transport);
        compute_convection(cell, transport);
        componentwise.subtract(1, convection, values, residual);
        return &convection;
      }

      /** The constant parts of the implicit terms, for each level. */
      const std::vector<FullMatrix<double>> &get_implicit_matrices() const
      {
        return implicit_matrices;
      }

    private:
      const FluidSpace<dim>          &space;
      const MomentumStep             &step;
      const FluidParameters<dim>     &parameters;
      const double                    rate;
      ComponentwiseProduct<dim>       componentwise;
      Vector<double>                  values, product, transport, pressures;
      FullMatrix<double>              convection;
      std::vector<FullMatrix<double>> implicit_matrices, old_matrices;
      const BodyForceLoads<dim>      &body_force;
      const SideLoads<dim>           &tractions;
      FEFaceValues<dim>               face; // of an open side

      static void add_loads(const ArrayView<const double> &loads, Vector<double> &residual)
      {
        for (unsigned int i = 0; i < residual.size(); ++i)
          residual[i] += loads[i];
      }

      void compute_convection(const Cell &cell, const Vector<double> &velocity)
      {
        space.get_cell_matrices(cell->level())
            .get_convection_matrix(velocity, parameters.density,
                                   parameters.convection_stabilisation, rate, convection);
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && lets_through(cell->face(f)->boundary_id()))
            add_outflow_term(cell, f, velocity);
      }

      /** Whether velocities that are not prescribed may be carried through the side. */
      bool lets_through(const types::boundary_id side) const
      {
        const BoundaryCondition<dim> &condition = space.get_boundary_condition(side);
        return condition.is_open() ||
               (step.grid_moves && !space.is_periodic(side / 2) &&
                condition.get_prescribed_components(side / 2).n_selected_components(dim) < dim);
      }

      /**
       * Adds what the skew-symmetric form of the convection lacks on open
       * sides, and on free-slip sides that move, 1/2 rho (w.n) u.v; where the flow reverses that
       * term would feed energy and may be left out (Braack & Mucha 2014,
       * doi:10.4208/jcm.1405-m4347).
       */
      void add_outflow_term(const Cell &cell, const unsigned int f, const Vector<double> &velocity)
      {
        face.reinit(typename Triangulation<dim>::cell_iterator(cell), f);
        for (const unsigned int q : face.quadrature_point_indices())
        {
          double flux = 0;
          for (const unsigned int s : face.dof_indices())
            flux += (f % 2 == 0 ? -1 : 1) * face.shape_value(s, q) *
                    velocity[space.velocity_element.component_to_system_index(f / 2, s)];
          if (parameters.backflow_stabilisation &&
              space.get_boundary_condition(cell->face(f)->boundary_id()).resists_backflow())
            flux = std::max(flux, 0.);
          for (const unsigned int i : face.dof_indices())
            for (const unsigned int j : face.dof_indices())
              convection(i, j) += 0.5 * parameters.density * flux * face.JxW(q) *
                                  face.shape_value(i, q) * face.shape_value(j, q);
        }
      }
    };
  } // namespace

  template <int dim>
  FieldVector MomentumOperator<dim>::assemble(const MomentumStep &step, const FieldVector &velocity,
                                              const FieldVector &pressure) const
  {
    const bool matrix_changes =
        step.transport != nullptr || !matrix_is_constant || !(step.weights == constant_weights);
    matrix_is_constant   = false; // unless all cells are set
    FieldVector residual = space.make_velocity_vector();

    const unsigned int                   n = space.velocity_element.n_dofs_per_cell();
    Vector<double>                       cell_residual(n);
    std::vector<types::global_dof_index> dofs(n);
    // A body force or a traction may fail on the cells of one rank only.
    const std::string error = catch_error([&]() {
      CellAssembler<dim> assembler(space, step);
      if (matrix_changes)
      {
        matrix.set_level_matrices(assembler.get_implicit_matrices());
        matrix.clear_scalar_matrices();
      }
      unsigned int index = 0;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell_residual = 0;
          assembler.add_known_terms(cell, pressure, cell_residual);
          const FullMatrix<double> *convection =
              assembler.subtract_implicit_terms(cell, velocity, cell_residual);
          cell->get_dof_indices(dofs);
          space.get_homogeneous_constraints().distribute_local_to_global(cell_residual, dofs,
                                                                         residual);
          if (convection != nullptr)
            matrix.set_scalar_matrix(index++, *convection);
        }
    });
    residual.compress(VectorOperation::add);
    throw_on_all(space.get_communicator(), error);
    matrix_is_constant = step.transport == nullptr;
    constant_weights   = step.weights;
    return residual;
  }

  template <int dim>
  FieldVector MomentumOperator<dim>::compute_diagonal() const
  {
    FieldVector diagonal = space.make_velocity_vector();
    matrix.add_diagonal(diagonal);
    return diagonal;
  }

  template <int dim>
  FieldVector MomentumOperator<dim>::compute_smooth_diagonal(const double grad_div) const
  {
    std::vector<const FullMatrix<double> *> weights;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        weights.push_back(&space.get_cell_matrices(cell->level()).get_inverse_pressure_mass());
    FieldVector squares = space.make_velocity_vector();
    divergence_matrix.add_diagonal_of_squares(weights, squares);
    FieldVector diagonal = space.make_velocity_vector();
    matrix.add_diagonal(diagonal, CellwiseMatrix::Parts::of_levels);
    diagonal.add(-grad_div, squares);
    return diagonal;
  }

  template <int dim>
  FieldVector MomentumOperator<dim>::compute_divergence(const FieldVector &velocity) const
  {
    FieldVector    result = space.make_pressure_vector();
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
    return result;
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

  template class MomentumOperator<2>;
  template class MomentumOperator<3>;
} // namespace caudal
