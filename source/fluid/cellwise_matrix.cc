// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/fluid/cellwise_matrix.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    /** Cells that a product takes at once: then the level's matrix stays in the cache. */
    constexpr unsigned int largest_block = 64;
  } // namespace

  template <int dim>
  CellwiseMatrix::Unknowns::Unknowns(const DoFHandler<dim>           &dofs,
                                     const AffineConstraints<double> &constraints)
      : n_per_cell(dofs.get_fe().n_dofs_per_cell())
      , n_components(dofs.get_fe().n_components())
  {
    for (unsigned int i = 0; i < n_per_cell; ++i)
    {
      // A single component has no system to be numbered in.
      const auto [component, scalar] =
          n_components == 1 ? std::make_pair(0u, i) : dofs.get_fe().system_to_component_index(i);
      places.push_back(component * (n_per_cell / n_components) + scalar);
    }
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
    std::vector<types::global_dof_index> cell_dofs(n_per_cell);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        cell->get_dof_indices(cell_dofs);
        first_resolution.push_back(resolution_begins.size() - 1);
        if (std::none_of(cell_dofs.begin(), cell_dofs.end(),
                         [&](const auto dof) { return constraints.is_constrained(dof); }))
          for (const auto dof : cell_dofs)
            add(dof, left);
        else
          for (const auto dof : cell_dofs)
          {
            if (!constraints.is_constrained(dof))
              resolutions.emplace_back(find(dof), 1.);
            else
            {
              for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
                resolutions.emplace_back(find(other), weight);
              add(dof, constrained);
            }
            resolution_begins.push_back(resolutions.size());
          }
        for (CellIndices *indices : {&left, &constrained})
          indices->begins.push_back(indices->global.size());
      }
  }

  template <typename Operation>
  void CellwiseMatrix::Unknowns::for_each_left(const unsigned int cell, const unsigned int i,
                                               const Operation &operation) const
  {
    if (!is_constrained(cell))
      operation(i, 1.);
    else
      for (std::size_t k = resolution_begins[first_resolution[cell] + i];
           k < resolution_begins[first_resolution[cell] + i + 1]; ++k)
        operation(resolutions[k].first, resolutions[k].second);
  }

  void CellwiseMatrix::Unknowns::gather(const unsigned int cell, const double *source,
                                        double *values) const
  {
    const unsigned int *local = left.local.data() + left.begins[cell];
    if (!is_constrained(cell))
      for (unsigned int i = 0; i < n_per_cell; ++i)
        values[places[i]] = source[local[i]];
    else
      for (unsigned int i = 0; i < n_per_cell; ++i)
      {
        double sum = 0;
        for_each_left(cell, i, [&](const unsigned int place, const double weight) {
          sum += weight * source[local[place]];
        });
        values[places[i]] = sum;
      }
  }

  void CellwiseMatrix::Unknowns::scatter(const unsigned int cell, const double *values,
                                         double *result) const
  {
    const unsigned int *local = left.local.data() + left.begins[cell];
    if (!is_constrained(cell))
      for (unsigned int i = 0; i < n_per_cell; ++i)
        result[local[i]] += values[places[i]];
    else
      for (unsigned int i = 0; i < n_per_cell; ++i)
        for_each_left(cell, i, [&](const unsigned int place, const double weight) {
          result[local[place]] += weight * values[places[i]];
        });
  }

  template <int dim>
  void CellwiseMatrix::count_levels(const DoFHandler<dim> &dofs)
  {
    level_begins.assign(1, 0);
    unsigned int n_cells = 0;
    for (unsigned int level = 0; level < dofs.get_triangulation().n_global_levels(); ++level)
    {
      if (level < dofs.get_triangulation().n_levels())
        for (const auto &cell : dofs.active_cell_iterators_on_level(level))
          n_cells += cell->is_locally_owned();
      level_begins.push_back(n_cells);
    }
    level_matrices.clear();
    scalar_matrices.clear();
  }

  template <int dim>
  void CellwiseMatrix::reinit(const DoFHandler<dim>           &dofs,
                              const AffineConstraints<double> &constraints)
  {
    rows = columns = std::make_shared<const Unknowns>(dofs, constraints);
    count_levels(dofs);
  }

  template <int dim>
  void CellwiseMatrix::reinit(const DoFHandler<dim> &row_dofs, const DoFHandler<dim> &dofs,
                              const AffineConstraints<double> &constraints)
  {
    rows    = std::make_shared<const Unknowns>(row_dofs, AffineConstraints<double>());
    columns = std::make_shared<const Unknowns>(dofs, constraints);
    count_levels(dofs);
  }

  void CellwiseMatrix::set_level_matrices(std::vector<FullMatrix<double>> matrices)
  {
    AssertDimension(matrices.size() + 1, level_begins.size());
    level_matrices              = std::move(matrices);
    level_matrices_by_component = level_matrices;
    for (unsigned int level = 0; level < level_matrices.size(); ++level)
      for (unsigned int i = 0; i < rows->n_per_cell; ++i)
        for (unsigned int j = 0; j < columns->n_per_cell; ++j)
          level_matrices_by_component[level](rows->places[i], columns->places[j]) =
              level_matrices[level](i, j);
  }

  void CellwiseMatrix::set_scalar_matrix(const unsigned int cell, const FullMatrix<double> &matrix)
  {
    Assert(rows == columns, ExcNotImplemented());
    const std::size_t n = n_scalar();
    AssertDimension(matrix.m(), n);
    if (scalar_matrices.empty())
      scalar_matrices.assign(level_begins.back() * n * n, 0.);
    double *values = &scalar_matrices[cell * n * n];
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        *values++ = matrix(i, j);
  }

  void CellwiseMatrix::clear_scalar_matrices()
  {
    scalar_matrices.clear();
  }

  template <typename Operation>
  void CellwiseMatrix::for_each_block(const Operation &operation) const
  {
    for (unsigned int level = 0; level + 1 < level_begins.size(); ++level)
      for (unsigned int cell = level_begins[level]; cell < level_begins[level + 1];
           cell += largest_block)
        operation(level, cell, std::min(largest_block, level_begins[level + 1] - cell));
  }

  void CellwiseMatrix::add_scalar_product(const unsigned int cell, const double *source,
                                          double *result) const
  {
    const std::size_t n      = n_scalar();
    const double     *matrix = &scalar_matrices[cell * n * n];
    for (unsigned int c = 0; c < columns->n_components; ++c)
      for (std::size_t j = 0; j < n; ++j)
      {
        const double  value  = source[c * n + j];
        const double *column = matrix + j * n;
        double       *target = result + c * n;
#pragma omp simd
        for (std::size_t i = 0; i < n; ++i)
          target[i] += column[i] * value;
      }
  }

  void CellwiseMatrix::vmult(FieldVector &result, const FieldVector &source) const
  {
    source.update_ghost_values();
    result            = 0;
    const double *in  = source.begin();
    double       *out = result.begin();

    FullMatrix<double> inputs, outputs;
    for_each_block([&](const unsigned int level, const unsigned int begin, const unsigned int n) {
      if (inputs.m() != n)
      {
        inputs.reinit(n, columns->n_per_cell);
        outputs.reinit(n, rows->n_per_cell);
      }
      for (unsigned int k = 0; k < n; ++k)
        columns->gather(begin + k, in, &inputs(k, 0));
      inputs.mTmult(outputs, level_matrices_by_component[level]);
      for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int cell = begin + k;
        if (!scalar_matrices.empty())
          add_scalar_product(cell, &inputs(k, 0), &outputs(k, 0));
        rows->scatter(cell, &outputs(k, 0), out);
        if (rows == columns && rows->is_constrained(cell))
        {
          const double       entry       = get_constrained_entry(level, cell, Parts::all);
          const CellIndices &constrained = rows->constrained;
          for (std::size_t i = constrained.begins[cell]; i < constrained.begins[cell + 1]; ++i)
            out[constrained.local[i]] += entry * in[constrained.local[i]];
        }
      }
    });
    result.compress(VectorOperation::add);
  }

  void CellwiseMatrix::Tvmult_add(FieldVector &result, const FieldVector &source) const
  {
    Assert(rows != columns, ExcNotImplemented());
    result.zero_out_ghost_values();
    const double *in  = source.begin();
    double       *out = result.begin();

    FullMatrix<double> inputs, outputs;
    for_each_block([&](const unsigned int level, const unsigned int begin, const unsigned int n) {
      if (inputs.m() != n)
      {
        inputs.reinit(n, rows->n_per_cell);
        outputs.reinit(n, columns->n_per_cell);
      }
      for (unsigned int k = 0; k < n; ++k)
        rows->gather(begin + k, in, &inputs(k, 0));
      inputs.mmult(outputs, level_matrices_by_component[level]);
      for (unsigned int k = 0; k < n; ++k)
        columns->scatter(begin + k, &outputs(k, 0), out);
    });
    result.compress(VectorOperation::add);
  }

  void CellwiseMatrix::get_cell_matrix(const unsigned int level, const unsigned int cell,
                                       FullMatrix<double> &matrix) const
  {
    // The assignment of matrices allocates memory.
    std::copy_n(&level_matrices[level](0, 0), matrix.n_elements(), &matrix(0, 0));
    if (scalar_matrices.empty())
      return;
    const unsigned int n      = n_scalar();
    const double      *scalar = &scalar_matrices[static_cast<std::size_t>(cell) * n * n];
    for (unsigned int i = 0; i < matrix.m(); ++i)
    {
      const unsigned int row = columns->places[i], component_begin = row / n * n;
      for (unsigned int j = 0; j < matrix.n(); ++j)
      {
        // Before the component's begin it is a large number.
        const unsigned int column = columns->places[j] - component_begin;
        if (column < n)
          matrix(i, j) += scalar[column * n + row - component_begin];
      }
    }
  }

  double CellwiseMatrix::get_diagonal_entry(const unsigned int level, const unsigned int cell,
                                            const unsigned int i, const Parts parts) const
  {
    double entry = level_matrices[level](i, i);
    if (parts == Parts::all && !scalar_matrices.empty())
    {
      const std::size_t n = n_scalar(), s = columns->places[i] % n;
      entry += scalar_matrices[(cell * n + s) * n + s];
    }
    return entry;
  }

  double CellwiseMatrix::get_constrained_entry(const unsigned int level, const unsigned int cell,
                                               const Parts parts) const
  {
    // The mean of the other diagonal entries has the right order of magnitude.
    double sum = 0;
    for (unsigned int i = 0; i < columns->n_per_cell; ++i)
      sum += std::abs(get_diagonal_entry(level, cell, i, parts)) / columns->n_per_cell;
    return sum;
  }

  void CellwiseMatrix::resolve(const unsigned int cell, const FullMatrix<double> &matrix,
                               double *values) const
  {
    if (!rows->is_constrained(cell) && !columns->is_constrained(cell))
    {
      const double *entries = &matrix(0, 0);
      for (std::size_t k = 0; k < matrix.n_elements(); ++k)
        values[k] += entries[k];
      return;
    }
    const std::size_t n = columns->left.n(cell);
    for (unsigned int i = 0; i < matrix.m(); ++i)
      rows->for_each_left(cell, i, [&](const unsigned int row, const double row_weight) {
        for (unsigned int j = 0; j < matrix.n(); ++j)
          columns->for_each_left(cell, j, [&](const unsigned int column, const double weight) {
            values[row * n + column] += row_weight * weight * matrix(i, j);
          });
      });
  }

  template <typename Operation>
  void CellwiseMatrix::for_each_resolved(const Operation &operation) const
  {
    FullMatrix<double>  matrix(rows->n_per_cell, columns->n_per_cell);
    std::vector<double> values;
    for_each_block([&](const unsigned int level, const unsigned int begin, const unsigned int n) {
      for (unsigned int cell = begin; cell < begin + n; ++cell)
      {
        get_cell_matrix(level, cell, matrix);
        values.assign(rows->left.n(cell) * columns->left.n(cell), 0.);
        resolve(cell, matrix, values.data());
        operation(level, cell, values);
      }
    });
  }

  void CellwiseMatrix::add_diagonal(FieldVector &result, const Parts parts) const
  {
    Assert(rows == columns, ExcNotImplemented());
    const CellIndices &left = columns->left, &constrained = columns->constrained;
    result.zero_out_ghost_values();
    FullMatrix<double>  matrix(rows->n_per_cell, columns->n_per_cell);
    std::vector<double> values;
    for_each_block([&](const unsigned int level, const unsigned int begin, const unsigned int n) {
      for (unsigned int cell = begin; cell < begin + n; ++cell)
      {
        const std::size_t   n_left = left.n(cell);
        const unsigned int *local  = left.local.data() + left.begins[cell];
        if (!columns->is_constrained(cell))
        {
          for (std::size_t i = 0; i < n_left; ++i)
            result.local_element(local[i]) += get_diagonal_entry(level, cell, i, parts);
          continue;
        }
        if (parts == Parts::all)
          get_cell_matrix(level, cell, matrix);
        else
          matrix = level_matrices[level];
        values.assign(n_left * n_left, 0.);
        resolve(cell, matrix, values.data());
        for (std::size_t i = 0; i < n_left; ++i)
          result.local_element(local[i]) += values[i * n_left + i];
        for (std::size_t i = constrained.begins[cell]; i < constrained.begins[cell + 1]; ++i)
          result.local_element(constrained.local[i]) += get_constrained_entry(level, cell, parts);
      }
    });
    result.compress(VectorOperation::add);
  }

  void
  CellwiseMatrix::add_diagonal_of_squares(const std::vector<const FullMatrix<double> *> &weights,
                                          FieldVector &result) const
  {
    Assert(rows != columns, ExcNotImplemented());
    const CellIndices &left = columns->left;
    result.zero_out_ghost_values();
    for_each_resolved(
        [&](const unsigned int, const unsigned int cell, const std::vector<double> &values) {
          const std::size_t n_rows = rows->left.n(cell), n = left.n(cell);
          for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < n_rows; ++k)
              for (std::size_t l = 0; l < n_rows; ++l)
                result.local_element(left.local[left.begins[cell] + j]) +=
                    values[k * n + j] * (*weights[cell])(k, l) * values[l * n + j];
        });
    result.compress(VectorOperation::add);
  }

  Triplets CellwiseMatrix::to_triplets() const
  {
    Assert(rows != columns, ExcNotImplemented());
    Triplets result;
    for_each_resolved([&](const unsigned int, const unsigned int cell,
                          const std::vector<double> &values) {
      const double *value = values.data();
      for (std::size_t i = rows->left.begins[cell]; i < rows->left.begins[cell + 1]; ++i)
        for (std::size_t j = columns->left.begins[cell]; j < columns->left.begins[cell + 1]; ++j)
          result.add(rows->left.global[i], columns->left.global[j], *value++);
    });
    return result;
  }

  void CellwiseMatrix::append_to(MatrixParts &parts) const
  {
    Assert(rows == columns, ExcNotImplemented());
    const CellIndices &left = columns->left, &constrained = columns->constrained;
    std::size_t        n_values = 0;
    for (unsigned int cell = 0; cell < level_begins.back(); ++cell)
      n_values += static_cast<std::size_t>(left.n(cell)) * left.n(cell);
    parts.storage.emplace_back(n_values);
    double            *values = parts.storage.back().data();
    FullMatrix<double> matrix(columns->n_per_cell, columns->n_per_cell);
    for_each_block([&](const unsigned int level, const unsigned int begin, const unsigned int n) {
      for (unsigned int cell = begin; cell < begin + n; ++cell)
      {
        get_cell_matrix(level, cell, matrix);
        resolve(cell, matrix, values);
        if (left.n(cell) > 0)
          parts.elements.push_back(
              {static_cast<int>(left.n(cell)), &left.global[left.begins[cell]], values});
        values += static_cast<std::size_t>(left.n(cell)) * left.n(cell);
        for (std::size_t i = constrained.begins[cell]; i < constrained.begins[cell + 1]; ++i)
          parts.entries.add(constrained.global[i], constrained.global[i],
                            get_constrained_entry(level, cell, Parts::all));
      }
    });
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
