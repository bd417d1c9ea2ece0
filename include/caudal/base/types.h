#ifndef caudal_base_types_h
#define caudal_base_types_h

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace caudal
{
  /** A fluid field, distributed over the ranks. */
  using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /**
   * target := source, layout included. The assignment operator keeps the ghost
   * layout of the target if both vectors have the same owned range, as it can
   * happen by chance after an adaptation of the grid; the ghost entries would
   * then be those of the old grid.
   */
  inline void copy_with_layout(const FieldVector &source, FieldVector &target)
  {
    target.reinit(source, /*omit_zeroing_entries=*/true);
    target = source;
  }

  /** Several of them: the unknowns of a coupled linear system. */
  using BlockFieldVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

  /** Entries (row, column, value) of a distributed matrix; entries of one place add up. */
  struct Triplets
  {
    std::vector<int>    rows;
    std::vector<int>    columns;
    std::vector<double> values;

    void add(const int row, const int column, const double value)
    {
      rows.push_back(row);
      columns.push_back(column);
      values.push_back(value);
    }

    void reserve(const std::size_t n_entries)
    {
      rows.reserve(n_entries);
      columns.reserve(n_entries);
      values.reserve(n_entries);
    }

    void clear()
    {
      rows.clear();
      columns.clear();
      values.clear();
    }
  };
} // namespace caudal

#endif
