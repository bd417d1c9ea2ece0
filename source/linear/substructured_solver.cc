#include <caudal/linear/substructured_solver.h>

#include <caudal/base/collective.h>
#include <caudal/linear/own_parts.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /**
     * What an entry of the factors and an unknown cost beside the operations of their elimination,
     * in units of these: 6.8e-9 s, 2.6e-7 s and 1.85e-11 s, by factorisations of 7,000 to 190,000
     * unknowns (OpenBLAS, one core).
     */
    constexpr double operations_per_entry = 370, operations_per_unknown = 1.4e4;
    /** Of the factors, far from bodies, for what must be known before they are. */
    constexpr double entries_per_unknown = 120;

    /** Unknowns in groups: first those of the placed ones, then those of the others. */
    struct Groups
    {
      Groups(const std::vector<int> &begins, const int n_placed)
          : n_placed_groups(std::lower_bound(begins.begin(), begins.end(), n_placed) -
                            begins.begin())
          , begins(begins)
          , of_unknown(begins.back())
      {
        AssertDimension(begins[n_placed_groups], n_placed);
        for (int group = 0; group < count(); ++group)
          std::fill(of_unknown.begin() + begins[group], of_unknown.begin() + begins[group + 1],
                    group);
      }

      int count() const
      {
        return begins.size() - 1;
      }

      const int               n_placed_groups;
      const std::vector<int> &begins;
      std::vector<int>        of_unknown;
    };

    /**
     * The strips of the placed groups, which get the ranks' @p shares of the estimated cost: it
     * grows with the cube of the number of entries in a row. Groups at one position share a
     * strip.
     */
    void cut_into_strips(const Groups &groups, const std::vector<double> &positions,
                         const std::vector<int> &sorted_unknowns, const std::vector<double> &shares,
                         const MatrixParts &matrix, MPI_Comm communicator, std::vector<int> &owner)
    {
      std::vector<double> work(groups.n_placed_groups); // entries of the rows
      for (const ElementMatrix &element : matrix.elements)
        for (int i = 0; i < element.n; ++i)
        {
          const int group = groups.of_unknown[element.unknowns[i]];
          AssertIndexRange(group, groups.n_placed_groups);
          work[group] += element.n;
        }
      for (const int row : matrix.entries.rows)
        if (groups.of_unknown[row] < groups.n_placed_groups)
          work[groups.of_unknown[row]] += 1;
      Utilities::MPI::sum(work, communicator, work);
      for (int group = 0; group < groups.n_placed_groups; ++group)
      {
        const double n_unknowns = groups.begins[group + 1] - groups.begins[group];
        const double row_length = work[group] / n_unknowns;
        work[group] =
            n_unknowns * (operations_per_unknown + entries_per_unknown * operations_per_entry +
                          0.5 * row_length * row_length * row_length);
      }
      const double total = std::accumulate(work.begin(), work.end(), 0.);
      // Positions that differ by round-off are one.
      const double tolerance =
          1e-9 * (positions[sorted_unknowns.back()] - positions[sorted_unknowns.front()]);
      double       sum = 0, limit = total * shares[0];
      double       last_position = positions[sorted_unknowns.front()];
      unsigned int strip         = 0;
      for (const int unknown : sorted_unknowns)
      {
        const int group = groups.of_unknown[unknown];
        if (unknown != groups.begins[group])
          continue;
        if (positions[unknown] > last_position + tolerance)
          while (sum > limit && strip + 1 < shares.size())
            limit += total * shares[++strip];
        owner[group]  = strip;
        last_position = positions[unknown];
        sum += work[group];
      }
    }

    /**
     * The rank of each group: that of its strip; without a place the highest one among its
     * neighbours', so that few reach from one rank to another.
     */
    std::vector<int> find_owners(const Groups &groups, const std::vector<double> &positions,
                                 const std::vector<int>    &sorted_unknowns,
                                 const std::vector<double> &shares, const MatrixParts &matrix,
                                 MPI_Comm communicator)
    {
      constexpr int    none = -1;
      std::vector<int> owner(groups.count(), none);
      cut_into_strips(groups, positions, sorted_unknowns, shares, matrix, communicator, owner);
      std::vector<std::pair<int, int>> pairs;
      for (std::size_t k = 0; k < matrix.entries.values.size(); ++k)
      {
        const int row    = groups.of_unknown[matrix.entries.rows[k]];
        const int column = groups.of_unknown[matrix.entries.columns[k]];
        if (std::max(row, column) >= groups.n_placed_groups)
          pairs.emplace_back(row, column);
      }
      // Neighbours of neighbours follow, until nothing more is reached.
      const auto first_free = owner.begin() + groups.n_placed_groups;
      for (bool some_reached = true; some_reached;)
      {
        std::vector<int> reached(first_free, owner.end());
        const auto       reach = [&](const int group, const int from) {
          if (owner[group] == none)
          {
            int &rank = reached[group - groups.n_placed_groups];
            rank      = std::max(rank, owner[from]);
          }
        };
        for (const auto &[row, column] : pairs)
        {
          reach(row, column);
          reach(column, row);
        }
        Utilities::MPI::max(reached, communicator, reached);
        some_reached = !std::equal(reached.begin(), reached.end(), first_free);
        std::copy(reached.begin(), reached.end(), first_free);
      }
      std::replace(owner.begin(), owner.end(), none, 0);
      return owner;
    }

    /** Which groups this rank's parts touch. */
    std::vector<int> find_touched(const Groups &groups, const MatrixParts &matrix)
    {
      std::vector<int> touched(groups.count());
      for (const ElementMatrix &element : matrix.elements)
        for (int i = 0; i < element.n; ++i)
          touched[groups.of_unknown[element.unknowns[i]]] = 1;
      for (const auto *indices : {&matrix.entries.rows, &matrix.entries.columns})
        for (const int unknown : *indices)
          touched[groups.of_unknown[unknown]] = 1;
      return touched;
    }

    /** All ranks' unknowns: each rank's owned ones of a block after those of the rank before. */
    std::vector<double> collect(const BlockFieldVector &vector)
    {
      std::vector<double> values(vector.size());
      std::size_t         offset = 0;
      for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      {
        const FieldVector &block = vector.block(b);
        std::copy_n(block.begin(), block.locally_owned_size(),
                    values.begin() + offset + block.get_partitioner()->local_range().first);
        offset += block.size();
      }
      Utilities::MPI::sum(values, vector.block(0).get_mpi_communicator(), values);
      return values;
    }

    void distribute(const std::vector<double> &values, BlockFieldVector &vector)
    {
      std::size_t offset = 0;
      for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      {
        FieldVector &block = vector.block(b);
        std::copy_n(values.begin() + offset + block.get_partitioner()->local_range().first,
                    block.locally_owned_size(), block.begin());
        offset += block.size();
      }
    }
  } // namespace

  SubstructuredSolver::SubstructuredSolver(MPI_Comm communicator)
      : communicator(communicator)
      , rank(Utilities::MPI::this_mpi_process(communicator))
      , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
      , shares(n_ranks, 1. / n_ranks)
  {}

  void SubstructuredSolver::reset()
  {
    exchanging_solver.reset();
    shares.assign(n_ranks, 1. / n_ranks);
    in_strips = true;
    clear();
  }

  void SubstructuredSolver::set_positions(const std::vector<double> &new_positions)
  {
    clear();
    in_strips = true;
    positions.clear();
    for (const auto &part : Utilities::MPI::all_gather(communicator, new_positions))
      positions.insert(positions.end(), part.begin(), part.end());
    sorted_unknowns.resize(positions.size());
    std::iota(sorted_unknowns.begin(), sorted_unknowns.end(), 0);
    std::stable_sort(sorted_unknowns.begin(), sorted_unknowns.end(),
                     [&](const int a, const int b) { return positions[a] < positions[b]; });
  }

  void SubstructuredSolver::factorize(const std::vector<int> &group_begins,
                                      const MatrixParts      &parts)
  {
    factorized = false;
    if (!try_to_factorize(group_begins, parts))
    {
      in_strips = false;
      interior.clear();
      try_to_factorize(group_begins, parts);
    }
    draw_conclusions();
    factorized = true;
  }

  bool SubstructuredSolver::try_to_factorize(const std::vector<int> &all_group_begins,
                                             const MatrixParts      &parts)
  {
    const Groups            groups(all_group_begins, positions.size());
    const int               n = groups.begins.back();
    std::optional<OwnParts> own;
    std::vector<int>        touched(groups.count(), 1);
    if (n_ranks > 1)
    {
      std::vector<int> rank_of(n, 0);
      if (in_strips)
      {
        const std::vector<int> owner =
            find_owners(groups, positions, sorted_unknowns, shares, parts, communicator);
        std::transform(groups.of_unknown.begin(), groups.of_unknown.end(), rank_of.begin(),
                       [&](const int group) { return owner[group]; });
      }
      own.emplace(parts, rank_of, communicator);
      touched = find_touched(groups, own->get());
    }
    std::vector<int> n_touching(touched);
    Utilities::MPI::sum(n_touching, communicator, n_touching);

    unknowns.clear();
    interface_unknowns.clear();
    interface_places.clear();
    std::vector<int> group_begins, place(n);
    const auto       add = [&](const int group) {
      group_begins.push_back(unknowns.size());
      for (int unknown = groups.begins[group]; unknown < groups.begins[group + 1]; ++unknown)
      {
        place[unknown] = unknowns.size();
        unknowns.push_back(unknown);
      }
    };
    for (int group = 0; group < groups.count(); ++group)
      if (n_touching[group] == 1 && touched[group])
        add(group);
    n_interior = unknowns.size();
    for (int group = 0; group < groups.count(); ++group)
      if (n_touching[group] > 1)
      {
        if (touched[group])
          add(group);
        for (int unknown = groups.begins[group]; unknown < groups.begins[group + 1]; ++unknown)
        {
          if (touched[group])
            interface_places.push_back(interface_unknowns.size());
          interface_unknowns.push_back(unknown);
        }
      }
    group_begins.push_back(unknowns.size());
    if (own)
      own->renumber(place);

    bool               is_sound = true;
    const MatrixParts &matrix   = own ? own->get() : parts;
    run_on_all(communicator, [&]() {
      if (n_interior == 0)
        return;
      if (in_strips)
        is_sound = interior.factorize(group_begins, matrix, interface_places.size());
      else
      {
        if (!exchanging_solver)
          exchanging_solver.emplace();
        exchanging_solver->factorize(group_begins, matrix.to_triplets());
      }
    });
    if (Utilities::MPI::min(static_cast<int>(is_sound), communicator) == 0)
      return false;
    if (!interface_unknowns.empty())
      factorize_interface(matrix);
    return true;
  }

  void SubstructuredSolver::factorize_interface(const MatrixParts &matrix)
  {
    const std::size_t   n_own = interface_places.size(), n = interface_unknowns.size();
    std::vector<double> sum(n * n);
    const auto add = [&](const std::size_t row, const std::size_t column, const double value) {
      sum[interface_places[row] * n + interface_places[column]] += value;
    };
    if (n_interior == 0)
    {
      const Triplets entries = matrix.to_triplets();
      for (std::size_t k = 0; k < entries.values.size(); ++k)
        add(entries.rows[k], entries.columns[k], entries.values[k]);
    }
    else
      for (std::size_t i = 0; i < n_own; ++i)
        for (std::size_t j = 0; j < n_own; ++j)
          add(i, j, interior.get_schur_complement()[i * n_own + j]);
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

  void SubstructuredSolver::draw_conclusions()
  {
    const double n       = interface_unknowns.size();
    double       entries = 0, operations = 0;
    if (n_interior > 0)
    {
      entries = in_strips ? interior.get_factor_entries() : exchanging_solver->get_factor_entries();
      operations =
          in_strips ? interior.get_factor_operations() : exchanging_solver->get_factor_operations();
    }
    n_factor_entries   = Utilities::MPI::sum(entries, communicator) + n * n;
    factorisation_cost = (Utilities::MPI::max(operations, communicator) + 2. / 3. * n * n * n) /
                         (Utilities::MPI::max(entries, communicator) + n * n);

    if (!in_strips || n_ranks == 1)
      return;
    // A part of the way, as each cut has other factors.
    const std::vector<double> all =
        Utilities::MPI::all_gather(communicator, operations + operations_per_entry * entries +
                                                     operations_per_unknown * unknowns.size());
    const double mean = std::accumulate(all.begin(), all.end(), 0.) / n_ranks;
    double       sum  = 0;
    for (unsigned int r = 0; r < n_ranks; ++r)
      sum += shares[r] *= std::pow(mean / (all[r] + 0.1 * mean), 0.25);
    for (double &share : shares)
      share /= sum;
  }

  void SubstructuredSolver::solve(BlockFieldVector &vector)
  {
    Assert(factorized, ExcMessage("factorize() comes before solve()."));
    std::vector<double> everything = collect(vector);
    std::vector<double> values(unknowns.size());
    for (unsigned int k = 0; k < n_interior; ++k)
      values[k] = everything[unknowns[k]];
    run_on_all(communicator, [&]() {
      if (n_interior > 0 && in_strips)
        interior.condense(values);
    });

    Vector<double> at_interface(interface_unknowns.size());
    for (unsigned int k = 0; k < interface_places.size(); ++k)
      at_interface[interface_places[k]] = values[n_interior + k];
    Utilities::MPI::sum(at_interface, communicator, at_interface);
    for (unsigned int k = 0; k < at_interface.size(); ++k)
      at_interface[k] += everything[interface_unknowns[k]];
    if (!interface_unknowns.empty())
      interface_matrix.solve(at_interface);
    for (unsigned int k = 0; k < interface_places.size(); ++k)
      values[n_interior + k] = at_interface[interface_places[k]];
    run_on_all(communicator, [&]() {
      if (n_interior > 0 && in_strips)
        interior.expand(values);
      else if (n_interior > 0)
        exchanging_solver->solve(values);
    });

    // Each unknown is told by one rank.
    std::fill(everything.begin(), everything.end(), 0.);
    for (unsigned int k = 0; k < n_interior; ++k)
      everything[unknowns[k]] = values[k];
    if (rank == 0)
      for (unsigned int k = 0; k < at_interface.size(); ++k)
        everything[interface_unknowns[k]] = at_interface[k];
    Utilities::MPI::sum(everything, communicator, everything);
    distribute(everything, vector);
  }
} // namespace caudal
