// The direct solver on one to three ranks: a chain of groups of two that the ranks share, three
// unknowns that all ranks hold and whose entries rank 0 has (one reaches over the ranks' border,
// one is known to the others only, one to nobody), entries given in parts by several ranks, and
// element matrices, of which some belong to another rank's strip. The
// solution is the one the right hand side was made of; equal solutions have equal bits; a
// singular matrix is an error of all ranks.

#include <caudal/linear/substructured_solver.h>

#include <deal.II/base/conditional_ostream.h>

#include <cmath>
#include <iostream>

using namespace caudal;
using namespace dealii;

namespace
{
  constexpr int n_chain = 24, n_free = 3, n = n_chain + n_free;

  /** Pairs of unknowns, and the last one alone. */
  std::vector<int> make_group_begins()
  {
    std::vector<int> begins;
    for (int i = 0; i < n; i += 2)
      begins.push_back(i);
    begins.push_back(n);
    return begins;
  }

  /**
   * The matrix: each rank has the elements of three that begin in its part of the chain, and
   * couplings of this part; rank 0 has those of the others.
   */
  struct Matrix
  {
    Matrix(const IndexSet &owned, const bool is_root, const double middle)
    {
      constexpr int size = 3;
      for (const int i : owned)
        if (i + size <= n_chain)
          for (int k = 0; k < size; ++k)
            unknowns.push_back(i + k);
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        for (int j = 0; j < size; ++j)
          values.push_back(static_cast<int>(k % size) == j ? 2 + 0.1 * unknowns[k]
                                                           : 1. / (5 + k % size - j));
      for (std::size_t k = 0; k < unknowns.size(); k += size)
        parts.elements.push_back({size, &unknowns[k], &values[k * size]});

      Triplets &entries = parts.entries;
      for (const int i : owned)
        if (std::abs(i - n_chain / 2) < 2 && middle != 0)
        {
          entries.add(i, n_chain, middle);
          entries.add(n_chain, i, 0.5 * middle); // a part of it
          entries.add(n_chain, i, 0.5 * middle);
        }
      if (is_root)
      {
        entries.add(n_chain, n_chain + 1, 2);
        entries.add(n_chain + 1, n_chain, -1);
        entries.add(n_chain + 1, n_chain + 1, 3);
        entries.add(n_chain + 2, n_chain + 2, middle);
      }
    }

    Matrix(const Matrix &) = delete;

    std::vector<int>    unknowns;
    std::vector<double> values;
    MatrixParts         parts;
  };
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm                   communicator = MPI_COMM_WORLD;
  const int                        rank         = Utilities::MPI::this_mpi_process(communicator);
  const int                        n_ranks      = Utilities::MPI::n_mpi_processes(communicator);
  ConditionalOStream               out(std::cout, rank == 0);

  IndexSet owned(n_chain), held(n_free);
  owned.add_range(rank * n_chain / n_ranks, (rank + 1) * n_chain / n_ranks);
  if (rank == 0)
    held.add_range(0, n_free);
  const auto get_solution = [](const int i) { return std::sin(1. + i); };

  SubstructuredSolver           solver(communicator);
  std::vector<BlockFieldVector> solutions;
  for (const double middle : {1., 4., 4.})
  {
    const Matrix   matrix(owned, rank == 0, middle);
    const Triplets entries = matrix.parts.to_triplets();
    // The right hand side: all ranks' products with the solution.
    std::vector<double> rhs(n);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      rhs[entries.rows[k]] += entries.values[k] * get_solution(entries.columns[k]);
    Utilities::MPI::sum(rhs, communicator, rhs);

    BlockFieldVector vector(2);
    vector.block(0).reinit(owned, communicator);
    vector.block(1).reinit(held, communicator);
    vector.collect_sizes();
    for (const auto i : owned)
      vector.block(0)[i] = rhs[i];
    for (const auto i : held)
      vector.block(1)[i] = rhs[n_chain + i];

    solver.set_positions(std::vector<double>(owned.begin(), owned.end()));
    solver.factorize(make_group_begins(), matrix.parts);
    solver.solve(vector);
    double error = 0;
    for (const auto i : owned)
      error = std::max(error, std::abs(vector.block(0)[i] - get_solution(i)));
    for (const auto i : held)
      error = std::max(error, std::abs(vector.block(1)[i] - get_solution(n_chain + i)));
    out << "middle " << middle << ": right " << (Utilities::MPI::max(error, communicator) < 1e-12)
        << std::endl;
    solutions.push_back(vector);
    solver.reset();
  }
  bool equal = true;
  for (const unsigned int b : {0, 1})
    equal &= std::equal(solutions[1].block(b).begin(), solutions[1].block(b).end(),
                        solutions[2].block(b).begin());
  out << "equal bits " << (Utilities::MPI::min<int>(equal, communicator) == 1) << std::endl;

  const Matrix matrix(owned, rank == 0, 0);
  try
  {
    solver.factorize(make_group_begins(), matrix.parts);
    out << "not noticed" << std::endl;
  }
  catch (ExceptionBase &)
  {
    const int n_told = Utilities::MPI::sum(1, communicator);
    out << "singular, said by " << (n_told == n_ranks ? "all" : "some") << std::endl;
  }
}
