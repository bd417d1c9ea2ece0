// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/fluid/cellwise_matrix.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>

namespace caudal
{
  template <int dim>
  void CellwiseMatrix::reinit(const DoFHandler<dim>           &dofs,
                              const AffineConstraints<double> &constraints)
  {
    const Utilities::MPI::Partitioner partitioner(dofs.locally_owned_dofs(),
                                                  DoFTools::extract_locally_relevant_dofs(dofs),
                                                  compatibility::get_communicator(dofs));
    unknowns.clear();
    local_unknowns.clear();
    constrained.clear();
    local_constrained.clear();
    resolutions.clear();
    unknowns_begin.assign(1, 0);
    constrained_begin.assign(1, 0);
    values_begin.assign(1, 0);

    std::vector<types::global_dof_index> cell_dofs(dofs.get_fe().n_dofs_per_cell()), resolved;
    const auto                           get_index = [&](const types::global_dof_index dof) {
      const auto         found = std::find(resolved.begin(), resolved.end(), dof);
      const unsigned int index = found - resolved.begin();
      if (found == resolved.end())
        resolved.push_back(dof);
      return index;
    };
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(cell_dofs);
        resolved.clear();
        std::vector<Resolution> resolution(cell_dofs.size());
        for (unsigned int i = 0; i < cell_dofs.size(); ++i)
          if (!constraints.is_constrained(cell_dofs[i]))
            resolution[i].emplace_back(get_index(cell_dofs[i]), 1.);
          else
          {
            for (const auto &[dof, weight] : *constraints.get_constraint_entries(cell_dofs[i]))
              resolution[i].emplace_back(get_index(dof), weight);
            constrained.push_back(cell_dofs[i]);
            local_constrained.push_back(partitioner.global_to_local(cell_dofs[i]));
          }
        for (const auto dof : resolved)
        {
          unknowns.push_back(dof);
          local_unknowns.push_back(partitioner.global_to_local(dof));
        }
        const bool is_constrained = constrained.size() > constrained_begin.back();
        resolutions.push_back(is_constrained ? resolution : std::vector<Resolution>());
        unknowns_begin.push_back(unknowns.size());
        constrained_begin.push_back(constrained.size());
        values_begin.push_back(values_begin.back() + resolved.size() * resolved.size());
      }
    values.assign(values_begin.back(), 0.);
    diagonals.assign(resolutions.size(), 0.);
  }

  void CellwiseMatrix::set(const unsigned int cell, const FullMatrix<double> &matrix)
  {
    double *target = &values[values_begin[cell]];
    if (resolutions[cell].empty())
    {
      std::copy_n(&matrix(0, 0), matrix.n_elements(), target);
      return;
    }
    const std::size_t n = unknowns_begin[cell + 1] - unknowns_begin[cell];
    std::fill_n(target, n * n, 0.);
    diagonals[cell] = 0;
    for (unsigned int i = 0; i < matrix.m(); ++i)
    {
      // The mean of the other diagonal entries has the right order of magnitude.
      diagonals[cell] += std::abs(matrix(i, i)) / matrix.m();
      for (const auto &[row, row_weight] : resolutions[cell][i])
        for (unsigned int j = 0; j < matrix.n(); ++j)
          for (const auto &[column, column_weight] : resolutions[cell][j])
            target[row * n + column] += row_weight * column_weight * matrix(i, j);
    }
  }

  void CellwiseMatrix::vmult(FieldVector &result, const FieldVector &source) const
  {
    source.update_ghost_values();
    result                  = 0;
    const double       *in  = source.begin();
    double             *out = result.begin();
    std::vector<double> input;
    for (unsigned int cell = 0; cell + 1 < unknowns_begin.size(); ++cell)
    {
      const unsigned int *place = local_unknowns.data() + unknowns_begin[cell];
      const std::size_t   n     = unknowns_begin[cell + 1] - unknowns_begin[cell];
      const double       *row   = values.data() + values_begin[cell];
      input.resize(n);
      for (std::size_t i = 0; i < n; ++i)
        input[i] = in[place[i]];
      for (std::size_t i = 0; i < n; ++i, row += n)
      {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j)
          sum += row[j] * input[j];
        out[place[i]] += sum;
      }
      for (std::size_t i = constrained_begin[cell]; i < constrained_begin[cell + 1]; ++i)
        out[local_constrained[i]] += diagonals[cell] * in[local_constrained[i]];
    }
    result.compress(VectorOperation::add);
  }

  void CellwiseMatrix::append_to(MatrixParts &matrix) const
  {
    for (unsigned int cell = 0; cell + 1 < unknowns_begin.size(); ++cell)
    {
      const int n = unknowns_begin[cell + 1] - unknowns_begin[cell];
      if (n > 0)
        matrix.elements.push_back(
            {n, &unknowns[unknowns_begin[cell]], &values[values_begin[cell]]});
      for (std::size_t i = constrained_begin[cell]; i < constrained_begin[cell + 1]; ++i)
        matrix.entries.add(constrained[i], constrained[i], diagonals[cell]);
    }
  }

  template void CellwiseMatrix::reinit(const DoFHandler<2> &, const AffineConstraints<double> &);
  template void CellwiseMatrix::reinit(const DoFHandler<3> &, const AffineConstraints<double> &);
} // namespace caudal
