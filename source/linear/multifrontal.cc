// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/linear/multifrontal.h>

#include "division.h"
#include "factorization.h"
#include "own_parts.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <algorithm>
#include <optional>

using namespace dealii;

namespace caudal
{
  namespace
  {
    using BlockVector = LinearAlgebra::distributed::BlockVector<double>;

    /** Cost of UMFPACK's factors: about a hundred solutions with them, as it does not tell. */
    constexpr double umfpack_cost = 2500;

    /** All ranks' unknowns: each rank's owned ones of a block after those of the rank before. */
    std::vector<double> collect(const BlockVector &vector)
    {
      std::vector<double> values(vector.size());
      std::size_t         offset = 0;
      for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      {
        const auto &block = vector.block(b);
        std::copy_n(block.begin(), block.locally_owned_size(),
                    values.begin() + offset + block.get_partitioner()->local_range().first);
        offset += block.size();
      }
      Utilities::MPI::sum(values, vector.block(0).get_mpi_communicator(), values);
      return values;
    }

    void distribute(const std::vector<double> &values, BlockVector &vector)
    {
      std::size_t offset = 0;
      for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      {
        auto &block = vector.block(b);
        std::copy_n(values.begin() + offset + block.get_partitioner()->local_range().first,
                    block.locally_owned_size(), block.begin());
        offset += block.size();
      }
    }

    void factorize_by_umfpack(const unsigned int n, const Triplets &entries,
                              SparseDirectUMFPACK &factors)
    {
      DynamicSparsityPattern places(n, n);
      for (std::size_t k = 0; k < entries.values.size(); ++k)
        places.add(entries.rows[k], entries.columns[k]);
      SparsityPattern pattern;
      pattern.copy_from(places);
      SparseMatrix<double> matrix(pattern);
      for (std::size_t k = 0; k < entries.values.size(); ++k)
        matrix.add(entries.rows[k], entries.columns[k], entries.values[k]);
      const std::string error = catch_error([&]() { factors.factorize(matrix); });
      AssertThrow(error.empty(),
                  ExcMessage("The direct solver (UMFPACK) could not factorise the " +
                             std::to_string(n) + " x " + std::to_string(n) +
                             " matrix: it is singular, or memory ran out. " + error));
    }
  } // namespace

  Triplets MatrixParts::to_triplets() const
  {
    Triplets all = entries;
    for (const ElementMatrix &element : elements)
      for (int i = 0; i < element.n; ++i)
        for (int j = 0; j < element.n; ++j)
          all.add(element.unknowns[i], element.unknowns[j], element.values[i * element.n + j]);
    return all;
  }

  struct MultifrontalSolver::Implementation
  {
    explicit Implementation(const MPI_Comm communicator)
        : communicator(communicator)
        , rank(Utilities::MPI::this_mpi_process(communicator))
        , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    {}

    bool factorize(const std::vector<int> &group_begins, const MatrixParts &parts);
    void factorize_interface();
    void estimate_cost();
    void solve(std::vector<double> &values);

    const MPI_Comm     communicator;
    const unsigned int rank, n_ranks;

    bool   factorized = false;
    double n_entries = 0, cost = 0;

    Positions                positions;
    std::optional<Share>     share; // of the factors; none if rank 0 has all by UMFPACK
    Factorization            interior;
    LAPACKFullMatrix<double> interface_matrix;
    SparseDirectUMFPACK      umfpack;
  };

  bool MultifrontalSolver::Implementation::factorize(const std::vector<int> &group_begins,
                                                     const MatrixParts      &parts)
  {
    const Groups            groups(group_begins, positions.size());
    std::optional<OwnParts> exchanged;
    if (n_ranks > 1)
      exchanged.emplace(parts, positions.divide(groups, parts, communicator), communicator);
    const MatrixParts &own_parts = exchanged ? exchanged->get() : parts;
    share.emplace(groups, own_parts, communicator);
    if (exchanged)
      exchanged->renumber(share->place);

    bool is_sound = true;
    run_on_all(communicator, [&]() {
      is_sound = interior.compute(share->group_begins, own_parts, share->interface_places.size());
    });
    if (Utilities::MPI::min(static_cast<int>(is_sound), communicator) == 0)
      return false;
    if (!share->interface_unknowns.empty())
      factorize_interface();
    return true;
  }

  void MultifrontalSolver::Implementation::factorize_interface()
  {
    const auto         &places = share->interface_places;
    const std::size_t   n_own = places.size(), n = share->interface_unknowns.size();
    std::vector<double> sum(n * n);
    for (std::size_t i = 0; i < n_own; ++i)
      for (std::size_t j = 0; j < n_own; ++j)
        sum[places[i] * n + places[j]] = interior.get_schur_complement()[i * n_own + j];
    Utilities::MPI::sum(sum, communicator, sum);

    interface_matrix.reinit(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        interface_matrix.set(i, j, sum[i * n + j]);
    try
    {
      interface_matrix.compute_lu_factorization();
    }
    catch (const LACExceptions::ExcSingular &)
    {
      AssertThrow(false, ExcMessage("The direct solver could not factorise the interface of the "
                                    "ranks: its matrix is singular."));
    }
  }

  void MultifrontalSolver::Implementation::estimate_cost()
  {
    const double n           = share->interface_unknowns.size();
    const double own_entries = interior.get_n_entries(), operations = interior.get_n_operations();
    n_entries = Utilities::MPI::sum(own_entries, communicator) + n * n;
    cost      = (Utilities::MPI::max(operations, communicator) + 2. / 3. * n * n * n) /
           (Utilities::MPI::max(own_entries, communicator) + n * n);
  }

  void MultifrontalSolver::Implementation::solve(std::vector<double> &everything)
  {
    const unsigned int  n_interior = share->n_interior;
    const auto         &unknowns   = share->unknowns;
    const auto         &places     = share->interface_places;
    std::vector<double> values(unknowns.size());
    for (unsigned int k = 0; k < n_interior; ++k)
      values[k] = everything[unknowns[k]];
    interior.condense(values);

    Vector<double> at_interface(share->interface_unknowns.size());
    for (unsigned int k = 0; k < places.size(); ++k)
      at_interface[places[k]] = values[n_interior + k];
    Utilities::MPI::sum(at_interface, communicator, at_interface);
    for (unsigned int k = 0; k < at_interface.size(); ++k)
      at_interface[k] += everything[share->interface_unknowns[k]];
    if (at_interface.size() > 0)
      interface_matrix.solve(at_interface);
    for (unsigned int k = 0; k < places.size(); ++k)
      values[n_interior + k] = at_interface[places[k]];
    interior.expand(values);

    // Each unknown is told by one rank.
    std::fill(everything.begin(), everything.end(), 0.);
    for (unsigned int k = 0; k < n_interior; ++k)
      everything[unknowns[k]] = values[k];
    if (rank == 0)
      for (unsigned int k = 0; k < at_interface.size(); ++k)
        everything[share->interface_unknowns[k]] = at_interface[k];
    Utilities::MPI::sum(everything, communicator, everything);
  }

  MultifrontalSolver::MultifrontalSolver(const MPI_Comm communicator)
      : implementation(std::make_unique<Implementation>(communicator))
  {}

  MultifrontalSolver::~MultifrontalSolver() = default;

  void MultifrontalSolver::set_positions(const std::vector<double> &positions)
  {
    clear();
    implementation->positions.set(positions, implementation->communicator);
  }

  bool MultifrontalSolver::factorize(const std::vector<int> &group_begins, const MatrixParts &parts)
  {
    clear();
    implementation->factorized = implementation->factorize(group_begins, parts);
    if (implementation->factorized)
      implementation->estimate_cost();
    return implementation->factorized;
  }

  void MultifrontalSolver::factorize_with_pivoting(const unsigned int n, const MatrixParts &parts)
  {
    clear();
    const OwnParts all(parts, std::vector<int>(n, 0), implementation->communicator);
    run_on_root(implementation->communicator, [&]() {
      factorize_by_umfpack(n, all.get().to_triplets(), implementation->umfpack);
    });
    implementation->share.reset();
    implementation->n_entries  = 0;
    implementation->cost       = umfpack_cost;
    implementation->factorized = true;
  }

  void MultifrontalSolver::solve(BlockVector &vector) const
  {
    Assert(is_factorized(), ExcMessage("A factorisation comes before solve()."));
    std::vector<double> everything = collect(vector);
    if (implementation->share)
      implementation->solve(everything);
    else
    {
      Vector<double> values(everything.begin(), everything.end());
      if (implementation->rank == 0)
        implementation->umfpack.solve(values);
      std::copy(values.begin(), values.end(), everything.begin());
      MPI_Bcast(everything.data(), everything.size(), MPI_DOUBLE, 0, implementation->communicator);
    }
    distribute(everything, vector);
  }

  void MultifrontalSolver::clear()
  {
    implementation->factorized = false;
  }

  bool MultifrontalSolver::is_factorized() const
  {
    return implementation->factorized;
  }

  double MultifrontalSolver::get_factor_entries() const
  {
    return implementation->n_entries;
  }

  unsigned int MultifrontalSolver::get_n_orderings() const
  {
    return implementation->interior.get_n_orderings();
  }

  double MultifrontalSolver::get_factorisation_cost() const
  {
    return implementation->cost;
  }
} // namespace caudal
