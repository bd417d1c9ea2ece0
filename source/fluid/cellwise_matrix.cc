// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/fluid/cellwise_matrix.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>

namespace caudal
{
  template <int dim>
  CellwiseMatrix::Unknowns::Unknowns(const DoFHandler<dim>           &dofs,
                                     const AffineConstraints<double> &constraints)
  {
    const Utilities::MPI::Partitioner partitioner(dofs.locally_owned_dofs(),
                                                  DoFTools::extract_locally_relevant_dofs(dofs),
                                                  compatibility::get_communicator(dofs));
    const auto add = [&](const types::global_dof_index dof, CellIndices &indices) {
      indices.global.push_back(dof);
      indices.local.push_back(partitioner.global_to_local(dof));
    };
    // The place in the cell of an unknown that is left.
    const auto find = [&](const types::global_dof_index dof) -> unsigned int {
      const auto begin = left.global.begin() + left.begins.back();
      const auto found = std::find(begin, left.global.end(), static_cast<int>(dof));
      const auto place = found - begin;
      if (found == left.global.end())
        add(dof, left);
      return place;
    };
    std::vector<types::global_dof_index> cell_dofs(dofs.get_fe().n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(cell_dofs);
        std::vector<Resolution> resolution(cell_dofs.size());
        for (unsigned int i = 0; i < cell_dofs.size(); ++i)
          if (!constraints.is_constrained(cell_dofs[i]))
            resolution[i].emplace_back(find(cell_dofs[i]), 1.);
          else
          {
            for (const auto &[dof, weight] : *constraints.get_constraint_entries(cell_dofs[i]))
              resolution[i].emplace_back(find(dof), weight);
            add(cell_dofs[i], constrained);
          }
        const bool is_constrained = constrained.global.size() > constrained.begins.back();
        resolutions.push_back(is_constrained ? resolution : std::vector<Resolution>());
        for (CellIndices *indices : {&left, &constrained})
          indices->begins.push_back(indices->global.size());
      }
  }

  template <int dim>
  void CellwiseMatrix::reinit(const DoFHandler<dim>           &dofs,
                              const AffineConstraints<double> &constraints)
  {
    rows = columns = std::make_shared<const Unknowns>(dofs, constraints);
    allocate();
  }

  template <int dim>
  void CellwiseMatrix::reinit(const DoFHandler<dim> &row_dofs, const DoFHandler<dim> &dofs,
                              const AffineConstraints<double> &constraints)
  {
    rows    = std::make_shared<const Unknowns>(row_dofs, AffineConstraints<double>());
    columns = std::make_shared<const Unknowns>(dofs, constraints);
    allocate();
  }

  void CellwiseMatrix::allocate()
  {
    const unsigned int n_cells = columns->resolutions.size();
    begins.assign(1, 0);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      begins.push_back(begins.back() + rows->left.n(cell) * columns->left.n(cell));
    values.assign(begins.back(), 0.);
    diagonals.assign(n_cells, 0.);
  }

  void CellwiseMatrix::set(const unsigned int cell, const FullMatrix<double> &matrix)
  {
    double *target = &values[begins[cell]];
    if (columns->constrained.n(cell) == 0)
    {
      std::copy_n(&matrix(0, 0), matrix.n_elements(), target);
      return;
    }
    std::vector<Resolution> themselves; // what rows of another space stand for
    for (unsigned int i = 0; rows != columns && i < matrix.m(); ++i)
      themselves.push_back({{i, 1.}});
    const std::vector<Resolution> &row_resolutions =
        rows == columns ? rows->resolutions[cell] : themselves;
    const std::size_t n = columns->left.n(cell);
    std::fill_n(target, begins[cell + 1] - begins[cell], 0.);
    diagonals[cell] = 0;
    for (unsigned int i = 0; i < matrix.m(); ++i)
    {
      // The mean of the other diagonal entries has the right order of magnitude.
      if (rows == columns)
        diagonals[cell] += std::abs(matrix(i, i)) / matrix.m();
      for (const auto &[row, row_weight] : row_resolutions[i])
        for (unsigned int j = 0; j < matrix.n(); ++j)
          for (const auto &[column, column_weight] : columns->resolutions[cell][j])
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
    for (unsigned int cell = 0; cell + 1 < begins.size(); ++cell)
    {
      const std::size_t   n_rows = rows->left.n(cell), n = columns->left.n(cell);
      const unsigned int *row_place = rows->left.local.data() + rows->left.begins[cell];
      const unsigned int *place     = columns->left.local.data() + columns->left.begins[cell];
      const double       *row       = values.data() + begins[cell];
      input.resize(n);
      for (std::size_t i = 0; i < n; ++i)
        input[i] = in[place[i]];
      for (std::size_t i = 0; i < n_rows; ++i, row += n)
      {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j)
          sum += row[j] * input[j];
        out[row_place[i]] += sum;
      }
      const CellIndices &constrained = rows->constrained; // none if the matrix is not square
      for (std::size_t i = constrained.begins[cell]; i < constrained.begins[cell + 1]; ++i)
        out[constrained.local[i]] += diagonals[cell] * in[constrained.local[i]];
    }
    result.compress(VectorOperation::add);
  }

  void CellwiseMatrix::Tvmult_add(FieldVector &result, const FieldVector &source) const
  {
    Assert(rows != columns, ExcNotImplemented());
    result.zero_out_ghost_values();
    const double *in    = source.begin();
    double       *out   = result.begin();
    const double *value = values.data();
    for (unsigned int cell = 0; cell + 1 < begins.size(); ++cell)
      for (std::size_t i = rows->left.begins[cell]; i < rows->left.begins[cell + 1]; ++i)
        for (std::size_t j = columns->left.begins[cell]; j < columns->left.begins[cell + 1]; ++j)
          out[columns->left.local[j]] += *value++ * in[rows->left.local[i]];
    result.compress(VectorOperation::add);
  }

  void CellwiseMatrix::add_diagonal(FieldVector &result) const
  {
    Assert(rows == columns, ExcNotImplemented());
    const auto &[left, constrained, resolutions] = *columns;
    result.zero_out_ghost_values();
    for (unsigned int cell = 0; cell + 1 < begins.size(); ++cell)
    {
      const std::size_t n = left.n(cell);
      for (std::size_t i = 0; i < n; ++i)
        result.local_element(left.local[left.begins[cell] + i]) += values[begins[cell] + i * n + i];
      for (std::size_t i = constrained.begins[cell]; i < constrained.begins[cell + 1]; ++i)
        result.local_element(constrained.local[i]) += diagonals[cell];
    }
    result.compress(VectorOperation::add);
  }

  void
  CellwiseMatrix::add_diagonal_of_squares(const std::vector<const FullMatrix<double> *> &weights,
                                          FieldVector &result) const
  {
    Assert(rows != columns, ExcNotImplemented());
    result.zero_out_ghost_values();
    for (unsigned int cell = 0; cell + 1 < begins.size(); ++cell)
    {
      const std::size_t n_rows = rows->left.n(cell), n = columns->left.n(cell);
      const double     *value = values.data() + begins[cell];
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < n_rows; ++k)
          for (std::size_t l = 0; l < n_rows; ++l)
            result.local_element(columns->left.local[columns->left.begins[cell] + j]) +=
                value[k * n + j] * (*weights[cell])(k, l) * value[l * n + j];
    }
    result.compress(VectorOperation::add);
  }

  Triplets CellwiseMatrix::to_triplets() const
  {
    Assert(rows != columns, ExcNotImplemented());
    Triplets      result;
    const double *value = values.data();
    for (unsigned int cell = 0; cell + 1 < begins.size(); ++cell)
      for (std::size_t i = rows->left.begins[cell]; i < rows->left.begins[cell + 1]; ++i)
        for (std::size_t j = columns->left.begins[cell]; j < columns->left.begins[cell + 1]; ++j)
          result.add(rows->left.global[i], columns->left.global[j], *value++);
    return result;
  }

  void CellwiseMatrix::append_to(MatrixParts &matrix) const
  {
    const auto &[left, constrained, resolutions] = *columns;
    for (unsigned int cell = 0; cell + 1 < begins.size(); ++cell)
    {
      const int n = left.n(cell);
      if (n > 0)
        matrix.elements.push_back({n, &left.global[left.begins[cell]], &values[begins[cell]]});
      for (std::size_t i = constrained.begins[cell]; i < constrained.begins[cell + 1]; ++i)
        matrix.entries.add(constrained.global[i], constrained.global[i], diagonals[cell]);
    }
  }

#define INSTANTIATE(dim)                                                                           \
  template void CellwiseMatrix::reinit(const DoFHandler<dim> &,                                    \
                                       const AffineConstraints<double> &);                         \
  template void CellwiseMatrix::reinit(const DoFHandler<dim> &, const DoFHandler<dim> &,           \
                                       const AffineConstraints<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
