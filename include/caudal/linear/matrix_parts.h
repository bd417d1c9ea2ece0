#ifndef caudal_linear_matrix_parts_h
#define caudal_linear_matrix_parts_h

#include <cstddef>
#include <vector>

namespace caudal
{
  /** Entries (row, column, value) of a matrix; entries of one place add up. */
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
  };

  /** A dense matrix that couples some unknowns with each other; somebody else keeps its arrays. */
  struct ElementMatrix
  {
    int           n;
    const int    *unknowns;
    const double *values; // row by row

    std::size_t n_entries() const
    {
      return static_cast<std::size_t>(n) * n;
    }
  };

  /** A (rank's part of a) sparse matrix as a sum that nobody has put together. */
  struct MatrixParts
  {
    std::vector<ElementMatrix> elements;
    Triplets                   entries;

    Triplets to_triplets() const
    {
      Triplets all = entries;
      for (const ElementMatrix &element : elements)
        for (int i = 0; i < element.n; ++i)
          for (int j = 0; j < element.n; ++j)
            all.add(element.unknowns[i], element.unknowns[j], element.values[i * element.n + j]);
      return all;
    }
  };
} // namespace caudal

#endif
