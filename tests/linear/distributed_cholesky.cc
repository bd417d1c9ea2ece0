// SPDX-License-Identifier: LGPL-2.1-or-later
// Cholesky factors on all ranks of the matrix of nodes on a line with springs to the next four and
// the next but eleven; every fifth node, of far reach, has one to all nodes within ten as well.
// Each entry is given in parts by all ranks. Residuals, and that a matrix with a negative
// eigenvalue is refused, on whichever rank it is.

#include <caudal/linear/distributed_cholesky.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace caudal;
using namespace dealii;

namespace
{
  constexpr int n = 90;

  unsigned int n_ranks()
  {
    return Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }

  /** Springs, and a weak one to the ground; the node @p soft has a strongly negative one. */
  Triplets make_matrix(const int soft)
  {
    Triplets   matrix;
    const auto add = [&](const int i, const int j, const double stiffness) {
      matrix.add(i, i, stiffness);
      matrix.add(j, j, stiffness);
      matrix.add(j, i, -stiffness);
    };
    for (int i = 0; i < n; ++i)
    {
      matrix.add(i, i, i == soft ? -100 : 0.1);
      for (int j = i + 1; j < n; ++j)
        if (j <= i + 4 || j == i + 12 || (j <= i + 10 && (i % 5 == 0 || j % 5 == 0)))
          add(i, j, 1. / (1 + j % 3));
    }
    for (double &value : matrix.values)
      value /= n_ranks();
    return matrix;
  }

  double compute_residual(const Triplets &matrix, const Vector<double> &solution,
                          const Vector<double> &rhs)
  {
    Vector<double> residual(rhs);
    for (std::size_t k = 0; k < matrix.size(); ++k)
    {
      const int    i = matrix.rows[k], j = matrix.columns[k];
      const double value = n_ranks() * matrix.values[k];
      residual[i] -= value * solution[j];
      if (i != j)
        residual[j] -= value * solution[i];
    }
    return residual.linfty_norm();
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int               rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  ConditionalOStream               out(std::cout, rank == 0);

  const IndexSet    owned = Utilities::create_evenly_distributed_partitioning(rank, n_ranks(), n);
  std::vector<bool> reaches_far(n);
  for (int i = 0; i < n; i += 5)
    reaches_far[i] = true;

  DistributedCholesky factors(MPI_COMM_WORLD);
  for (const int soft : {-1, 3, 45, 88, -1})
  {
    const Triplets matrix = make_matrix(soft);
    if (!factors.factorize(owned, matrix, reaches_far))
    {
      out << "not positive definite\n";
      continue;
    }
    DistributedCholesky::FieldVector values(owned, MPI_COMM_WORLD);
    Vector<double>                   rhs(n), solution(n);
    for (int i = 0; i < n; ++i)
      rhs[i] = std::sin(1. + i * i);
    for (const auto i : owned)
      values(i) = rhs[i];
    factors.solve(values);
    for (const auto i : owned)
      solution[i] = values(i);
    Utilities::MPI::sum(solution, MPI_COMM_WORLD, solution);
    out << std::fixed << std::setprecision(4) << "largest value " << solution.linfty_norm()
        << ", residual " << (compute_residual(matrix, solution, rhs) < 1e-12 ? "below" : "above")
        << " 1e-12\n";
  }
}
