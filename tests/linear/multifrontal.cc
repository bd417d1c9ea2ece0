// SPDX-License-Identifier: LGPL-2.1-or-later
// The direct solver on one to three ranks. A square of nodes with two unknowns each, in element
// matrices, and a body: unknowns without a position, whose entries rank 0 has. Printed are three
// unknowns of the solution, which are sin(1), sin(n/2) and sin(n), and what a repetition may not
// change: equal matrices give equal bits, with the ordering reused or not and whatever was
// factorised before; one moved entry needs a new ordering. Then pivots: too small ones are refused,
// larger groups or pivots from all rows do, and a singular matrix is an error of all ranks.

#include <caudal/linear/multifrontal.h>

#include <deal.II/base/conditional_ostream.h>

#include <cmath>
#include <iostream>

using namespace caudal;
using namespace dealii;

namespace
{
  using BlockVector = LinearAlgebra::distributed::BlockVector<double>;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  constexpr int n_side = 30, n_square = 2 * n_side * n_side, n_body = 25, n = n_square + n_body;

  int get_rank()
  {
    return Utilities::MPI::this_mpi_process(communicator);
  }

  /** Begin of a rank's part of so many things. */
  int get_begin(const int n_things, const int rank)
  {
    return n_things / 2 * rank / Utilities::MPI::n_mpi_processes(communicator) * 2;
  }

  /** Nodes' own entries have to be the pivots, for which their rows are exchanged. */
  struct Matrix
  {
    /** @p moved: node with which the last unknown is coupled. */
    explicit Matrix(const double factor, const int moved = n_side)
    {
      constexpr int n_per_element = 8, n_elements = (n_side - 1) * (n_side - 1);
      const int     n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      for (int e = n_elements * get_rank() / n_ranks; e < n_elements * (get_rank() + 1) / n_ranks;
           ++e)
      {
        for (const int corner : {0, 1, n_side, n_side + 1})
          for (const int a : {0, 1})
            unknowns.push_back(2 * (e / (n_side - 1) * n_side + e % (n_side - 1) + corner) + a);
        for (int k = 0; k < n_per_element * n_per_element; ++k)
          values.push_back(0.4 * std::sin(factor * (n_per_element * n_per_element * e + k)));
      }
      for (std::size_t k = 0; k < unknowns.size(); k += n_per_element)
        parts.elements.push_back({n_per_element, &unknowns[k], &values[k * n_per_element]});
      if (get_rank() == 0)
        add_entries(factor, moved);
    }

    Matrix(const Matrix &) = delete;

    MatrixParts parts;

  private:
    std::vector<int>    unknowns;
    std::vector<double> values;

    void add_entries(const double factor, const int moved)
    {
      for (int node = 0; node < n_side * n_side; ++node)
        for (const int a : {0, 1})
          parts.entries.add(2 * node + a, 2 * node + 1 - a, 12);
      for (int i = n_square; i < n; ++i)
      {
        const int neighbour = i == n - 1 ? 2 * moved : 40 * (i - n_square) + 300;
        parts.entries.add(i, i, 3);
        parts.entries.add(i, neighbour, factor);
        parts.entries.add(neighbour, i, -factor);
      }
    }
  };

  std::vector<int> make_pairs()
  {
    std::vector<int> begins;
    for (int i = 0; i < n; i += 2)
      begins.push_back(i);
    begins.push_back(n);
    return begins;
  }

  std::vector<double> make_positions()
  {
    std::vector<double> positions;
    for (int i = get_begin(n_square, get_rank()); i < get_begin(n_square, get_rank() + 1); ++i)
      positions.push_back(i / 2 / n_side);
    return positions;
  }

  BlockVector make_vector(const std::vector<double> &values, const int n_placed)
  {
    IndexSet  placed(n_placed), others(values.size() - n_placed);
    const int begin = get_begin(n_placed, get_rank()), end = get_begin(n_placed, get_rank() + 1);
    placed.add_range(begin, end);
    if (get_rank() == 0)
      others.add_range(0, others.size());
    BlockVector vector(2);
    vector.block(0).reinit(placed, communicator);
    vector.block(1).reinit(others, communicator);
    vector.collect_sizes();
    std::copy(values.begin() + begin, values.begin() + end, vector.block(0).begin());
    for (const auto i : others)
      vector.block(1)[i] = values[n_placed + i];
    return vector;
  }

  /** All ranks' products with the vector of sines. */
  std::vector<double> make_rhs(const MatrixParts &parts, const int size)
  {
    const Triplets      entries = parts.to_triplets();
    std::vector<double> rhs(size);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      rhs[entries.rows[k]] += entries.values[k] * std::sin(1. + entries.columns[k]);
    Utilities::MPI::sum(rhs, communicator, rhs);
    return rhs;
  }

  std::vector<double> solve(const MultifrontalSolver &solver, const MatrixParts &parts,
                            const int size, const int n_placed)
  {
    BlockVector vector = make_vector(make_rhs(parts, size), n_placed);
    solver.solve(vector);
    std::vector<double> all(size);
    const int           begin = get_begin(n_placed, get_rank());
    std::copy(vector.block(0).begin(),
              vector.block(0).begin() + vector.block(0).locally_owned_size(), all.begin() + begin);
    std::copy(vector.block(1).begin(),
              vector.block(1).begin() + vector.block(1).locally_owned_size(),
              all.begin() + n_placed);
    Utilities::MPI::sum(all, communicator, all);
    return all;
  }

  void print(const std::string &what, const std::vector<double> &solution, std::ostream &out)
  {
    out << what << ": " << solution.front() << ' ' << solution[solution.size() / 2 - 1] << ' '
        << solution.back() << '\n';
  }

  void test_repetitions(ConditionalOStream &out)
  {
    const Matrix           first(1), second(1.5), moved(1, 3);
    const std::vector<int> pairs = make_pairs();
    MultifrontalSolver     solver(communicator);
    solver.set_positions(make_positions());
    std::vector<double> expected;
    for (const auto &[name, matrix] :
         std::vector<std::pair<std::string, const Matrix *>>{{"first", &first},
                                                             {"other values", &second},
                                                             {"first", &first},
                                                             {"entry moved", &moved},
                                                             {"first", &first}})
    {
      const bool sound    = solver.factorize(pairs, matrix->parts);
      const auto solution = solve(solver, matrix->parts, n, n_square);
      print(name, solution, out.get_stream());
      out << "  sound " << sound << ", orderings " << solver.get_n_orderings();
      if (matrix == &first && !expected.empty())
        out << ", equal bits " << (solution == expected);
      out << '\n';
      if (expected.empty())
        expected = solution;
    }
    MultifrontalSolver fresh(communicator);
    fresh.set_positions(make_positions());
    fresh.factorize(pairs, first.parts);
    out << "fresh solver: equal bits " << (solve(fresh, first.parts, n, n_square) == expected)
        << '\n';
  }

  /** Unknowns with a diagonal entry that are coupled with the last one. */
  MatrixParts make_arrow(const int size, const double diagonal)
  {
    MatrixParts matrix;
    if (get_rank() == 0)
      for (int i = 0; i < size; ++i)
      {
        matrix.entries.add(i, i, i + 1 < size ? diagonal : 1);
        matrix.entries.add(i, size - 1, 1);
        matrix.entries.add(size - 1, i, 1 + i % 2);
      }
    return matrix;
  }

  void test_pivots(ConditionalOStream &out)
  {
    constexpr int      size = 60;
    MultifrontalSolver solver(communicator); // nothing has a position: rank 0 gets all
    for (const double diagonal : {1., 1e-7, 0.})
    {
      const MatrixParts matrix = make_arrow(size, diagonal);
      for (const int group_size : {1, size})
      {
        std::vector<int> groups;
        for (int i = 0; i <= size; i += group_size)
          groups.push_back(i);
        const bool sound = solver.factorize(groups, matrix);
        out << "diagonal " << diagonal << ", groups of " << group_size << ": sound " << sound
            << ", factors " << solver.is_factorized() << '\n';
        if (sound)
          print("  solution", solve(solver, matrix, size, 0), out.get_stream());
      }
      try
      {
        solver.factorize_with_pivoting(size, matrix);
        print("  pivots from all rows", solve(solver, matrix, size, 0), out.get_stream());
      }
      catch (ExceptionBase &)
      {
        const unsigned int n_told = Utilities::MPI::sum(1, communicator);
        out << "  singular, said by "
            << (n_told == Utilities::MPI::n_mpi_processes(communicator) ? "all" : "some") << '\n';
      }
    }
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout, get_rank() == 0);
  if (get_rank() != 0)
    std::cout.setstate(std::ios::failbit); // only rank 0 prints
  test_repetitions(out);
  test_pivots(out);
}
