// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/divergence_matrix.h>

#include <map>

namespace caudal
{
  namespace
  {
    /**
     * The columns of a cell, by their places among this rank's entries, for the cell's matrix
     * @p local and its unknowns @p dofs: v_i is the sum of the unconstrained v_j times weights.
     */
    std::map<unsigned int, Vector<double>>
    resolve_columns(const FullMatrix<double>                   &local,
                    const std::vector<types::global_dof_index> &dofs,
                    const AffineConstraints<double>            &constraints,
                    const Utilities::MPI::Partitioner          &partitioner)
    {
      std::map<unsigned int, Vector<double>> result;
      const auto add = [&](const types::global_dof_index dof, const double weight,
                           const unsigned int i) {
        Vector<double> &column =
            result.try_emplace(partitioner.global_to_local(dof), local.m()).first->second;
        for (unsigned int k = 0; k < local.m(); ++k)
          column[k] += weight * local(k, i);
      };
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (!constraints.is_constrained(dofs[i]))
          add(dofs[i], 1., i);
        else
          for (const auto &[dof, weight] : *constraints.get_constraint_entries(dofs[i]))
            add(dof, weight, i);
      return result;
    }
  } // namespace

  template <int dim>
  void DivergenceMatrix::reinit(const FluidSpace<dim>           &space,
                                const AffineConstraints<double> &constraints)
  {
    const auto velocity_partitioner = space.make_velocity_vector().get_partitioner();
    const auto pressure_partitioner = space.make_pressure_vector().get_partitioner();
    rows.clear();
    columns.clear();
    columns_begin.assign(1, 0);
    values.clear();
    rows_per_cell = space.pressure_element.n_dofs_per_cell();

    std::vector<types::global_dof_index> velocities(space.velocity_element.n_dofs_per_cell());
    std::vector<types::global_dof_index> pressures(rows_per_cell);
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(velocities);
        typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs)
            ->get_dof_indices(pressures);
        const auto resolved =
            resolve_columns(space.get_cell_matrices(cell->level()).get_divergence(), velocities,
                            constraints, *velocity_partitioner);
        for (const auto dof : pressures)
          rows.push_back(pressure_partitioner->global_to_local(dof));
        for (const auto &[place, column] : resolved)
          columns.push_back(place);
        columns_begin.push_back(columns.size());
        for (unsigned int k = 0; k < rows_per_cell; ++k)
          for (const auto &[place, column] : resolved)
            values.push_back(column[k]);
      }
  }

  template <class Operation>
  void DivergenceMatrix::for_each_row(const Operation &operation) const
  {
    const double *value = values.data();
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      const std::size_t   cell  = row / rows_per_cell;
      const unsigned int *first = columns.data() + columns_begin[cell];
      const unsigned int *last  = columns.data() + columns_begin[cell + 1];
      operation(rows[row], first, last, value);
      value += last - first;
    }
  }

  void DivergenceMatrix::vmult(FieldVector &pressure, const FieldVector &velocity) const
  {
    velocity.update_ghost_values();
    const double *in  = velocity.begin();
    double       *out = pressure.begin();
    for_each_row([&](const unsigned int row, const unsigned int *first, const unsigned int *last,
                     const double *value) {
      double sum = 0;
      for (; first != last; ++first, ++value)
        sum += *value * in[*first];
      out[row] = sum;
    });
  }

  void DivergenceMatrix::Tvmult(FieldVector &velocity, const FieldVector &pressure) const
  {
    velocity = 0;
    Tvmult_add(velocity, pressure);
  }

  void DivergenceMatrix::Tvmult_add(FieldVector &velocity, const FieldVector &pressure) const
  {
    velocity.zero_out_ghost_values();
    const double *in  = pressure.begin();
    double       *out = velocity.begin();
    for_each_row([&](const unsigned int row, const unsigned int *first, const unsigned int *last,
                     const double *value) {
      for (; first != last; ++first, ++value)
        out[*first] += *value * in[row];
    });
    velocity.compress(VectorOperation::add);
  }

  template void DivergenceMatrix::reinit(const FluidSpace<2> &, const AffineConstraints<double> &);
  template void DivergenceMatrix::reinit(const FluidSpace<3> &, const AffineConstraints<double> &);
} // namespace caudal
