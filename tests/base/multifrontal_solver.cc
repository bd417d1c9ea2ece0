// Elimination in fronts: an unsymmetric matrix of a square of nodes with two unknowns each, whose
// last fronts are wider than a panel, whole and with some unknowns kept; the solution is the one
// the right hand side was made of. Pivots that are too small for their fronts, and a singular
// matrix, are refused.

#include <caudal/base/multifrontal_solver.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <iostream>
#include <numeric>

using namespace caudal;
using namespace dealii;

namespace
{
  constexpr int n_side = 30, n = 2 * n_side * n_side;

  /** Each node and its eight neighbours; rows of a node are exchanged, so that pivots have to be.
   */
  Triplets make_entries()
  {
    Triplets entries;
    for (int x = 0; x < n_side; ++x)
      for (int y = 0; y < n_side; ++y)
        for (int dx = -1; dx <= 1; ++dx)
          for (int dy = -1; dy <= 1; ++dy)
            if (std::min(x + dx, y + dy) >= 0 && std::max(x + dx, y + dy) < n_side)
              for (const int a : {0, 1})
                for (const int b : {0, 1})
                {
                  const int row    = 2 * (n_side * x + y) + a;
                  const int column = 2 * (n_side * (x + dx) + y + dy) + b;
                  entries.add(row, column,
                              (dx == 0 && dy == 0 && a != b ? 12 : 0) +
                                  std::sin(row + 2. * column));
                }
    return entries;
  }

  void check_solution(const Triplets &entries, const std::vector<int> &groups, const int n_kept)
  {
    std::vector<double> vector(n);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      vector[entries.rows[k]] += entries.values[k] * std::sin(1. + entries.columns[k]);
    MultifrontalSolver solver;
    std::cout << "kept " << n_kept << ": sound " << solver.factorize(groups, entries, n_kept);
    solver.condense(vector);
    if (n_kept > 0)
    {
      LAPACKFullMatrix<double> schur_complement(n_kept);
      Vector<double>           kept(vector.end() - n_kept, vector.end());
      for (int i = 0; i < n_kept; ++i)
        for (int j = 0; j < n_kept; ++j)
          schur_complement.set(i, j, solver.get_schur_complement()[i * n_kept + j]);
      schur_complement.compute_lu_factorization();
      schur_complement.solve(kept);
      std::copy(kept.begin(), kept.end(), vector.end() - n_kept);
    }
    solver.expand(vector);
    double error = 0;
    for (int i = 0; i < n; ++i)
      error = std::max(error, std::abs(vector[i] - std::sin(1. + i)));
    std::cout << ", right " << (error < 1e-10) << std::endl;
  }

  /** Unknowns that have only a small diagonal entry and are coupled with the last one. */
  bool is_arrow_sound(const double diagonal)
  {
    const int        n_arrow = 60;
    Triplets         entries;
    std::vector<int> groups(n_arrow + 1);
    std::iota(groups.begin(), groups.end(), 0);
    for (int i = 0; i + 1 < n_arrow; ++i)
    {
      entries.add(i, i, diagonal);
      entries.add(i, n_arrow - 1, 1);
      entries.add(n_arrow - 1, i, 1);
    }
    entries.add(n_arrow - 1, n_arrow - 1, 1);
    MultifrontalSolver solver;
    return solver.factorize(groups, entries);
  }
} // namespace

int main()
{
  const Triplets   entries = make_entries();
  std::vector<int> groups;
  for (int i = 0; i <= n; i += 2)
    groups.push_back(i);
  check_solution(entries, groups, 0);
  check_solution(entries, groups, 40);
  for (const double diagonal : {1., 1e-12, 0.})
    std::cout << "small pivots " << diagonal << ": sound " << is_arrow_sound(diagonal) << std::endl;
}
