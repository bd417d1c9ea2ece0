// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_front_assembly_h
#define caudal_linear_front_assembly_h

#include "front.h"

namespace caudal
{
  /**
   * Assembly of fronts from the parts of D A D that begin with their pivots and from what their
   * children in the elimination tree leave for them.
   */
  class FrontAssembly
  {
  public:
    /** @p scales: the diagonal of D. */
    FrontAssembly(const EliminationTree &tree, const MatrixParts &matrix,
                  const std::vector<double> &scales);

    /** Adds the matrix' parts; @p front and @p update are the blocks of front number @p index. */
    void add_parts(std::size_t index, const FrontFactors &front, const Block &update);

    /** Adds what a child of the front of the last add_parts() has left for its rest. */
    void add_update(const EliminationTree::Front &child, const double *child_update,
                    const FrontFactors &front, const Block &update);

    /** Calls add(row, column, value) for all that couples kept unknowns only. */
    template <class Add>
    void for_each_kept_entry(const Add &add) const
    {
      const std::size_t kept = tree.fronts.size();
      for (int k = tree.elements.begins[kept]; k < tree.elements.begins[kept + 1]; ++k)
      {
        const ElementMatrix &element = matrix.elements[tree.elements.numbers[k]];
        const double        *value   = element.values;
        for (int i = 0; i < element.n; ++i)
          for (int j = 0; j < element.n; ++j, ++value)
            add(element.unknowns[i], element.unknowns[j], *value);
      }
      for (int k = tree.entries.begins[kept]; k < tree.entries.begins[kept + 1]; ++k)
      {
        const int entry = tree.entries.numbers[k];
        add(matrix.entries.rows[entry], matrix.entries.columns[entry],
            matrix.entries.values[entry]);
      }
    }

  private:
    /** Rows of a child's rest that follow each other in the front, too. */
    struct Run
    {
      int begin, length;
    };

    const EliminationTree     &tree;
    const MatrixParts         &matrix;
    const std::vector<double> &scales;
    std::vector<int>           places; // of the present front's unknowns in it
    std::vector<int>           rows;   // of a child's rest
    std::vector<Run>           runs;

    void find_runs(int n_pivots);
    void add_element(const ElementMatrix &element, const FrontFactors &front,
                     const Block &update) const;
  };
} // namespace caudal

#endif
