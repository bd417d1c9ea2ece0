// Elimination in fronts: an unsymmetric matrix of a square of nodes with two unknowns each, given
// by element matrices and by single entries, whose last fronts are wider than a panel, whole and
// with some unknowns kept; the solution is the one the right hand side was made of. Pivots that are
// too small for their fronts, and a singular matrix, are refused.

#include <caudal/linear/multifrontal_solver.h>

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

  /**
   * Squares of four nodes with dense matrices, and entries of each node that have to be pivots,
   * for which its rows are exchanged.
   */
  struct Matrix
  {
    Matrix()
    {
      constexpr int n_per_square = 8;
      for (int x = 0; x + 1 < n_side; ++x)
        for (int y = 0; y + 1 < n_side; ++y)
          for (const int node :
               {n_side * x + y, n_side * (x + 1) + y, n_side * x + y + 1, n_side * (x + 1) + y + 1})
            for (const int a : {0, 1})
              unknowns.push_back(2 * node + a);
      values.resize(unknowns.size() * n_per_square);
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = 0.4 * std::sin(k);
      for (std::size_t k = 0; k < unknowns.size(); k += n_per_square)
        parts.elements.push_back({n_per_square, &unknowns[k], &values[k * n_per_square]});
      for (int node = 0; node < n_side * n_side; ++node)
        for (const int a : {0, 1})
          parts.entries.add(2 * node + a, 2 * node + 1 - a, 12);
    }

    Matrix(const Matrix &) = delete;

    std::vector<int>    unknowns;
    std::vector<double> values;
    MatrixParts         parts;
  };

  void check_solution(const MatrixParts &matrix, const std::vector<int> &groups, const int n_kept)
  {
    const Triplets      entries = matrix.to_triplets();
    std::vector<double> vector(n);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      vector[entries.rows[k]] += entries.values[k] * std::sin(1. + entries.columns[k]);
    MultifrontalSolver solver;
    std::cout << "kept " << n_kept << ": sound " << solver.factorize(groups, matrix, n_kept);
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
    MatrixParts      matrix;
    Triplets        &entries = matrix.entries;
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
    return solver.factorize(groups, matrix);
  }
} // namespace

int main()
{
  const Matrix     matrix;
  std::vector<int> groups;
  for (int i = 0; i <= n; i += 2)
    groups.push_back(i);
  check_solution(matrix.parts, groups, 0);
  check_solution(matrix.parts, groups, 40);
  for (const double diagonal : {1., 1e-12, 0.})
    std::cout << "small pivots " << diagonal << ": sound " << is_arrow_sound(diagonal) << std::endl;
}
