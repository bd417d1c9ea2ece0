// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/linear/distributed_cholesky.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace dealii;

namespace caudal
{
  namespace
  {
    constexpr int nowhere = -1;

    Triplets take_lower(const Triplets &entries)
    {
      Triplets lower;
      for (std::size_t k = 0; k < entries.size(); ++k)
        if (entries.rows[k] >= entries.columns[k])
          lower.add(entries.rows[k], entries.columns[k], entries.values[k]);
      return lower;
    }
  } // namespace

  DistributedCholesky::DistributedCholesky(const MPI_Comm communicator)
      : communicator(communicator)
      , rank(Utilities::MPI::this_mpi_process(communicator))
  {}

  void DistributedCholesky::find_interface(const Triplets          &lower,
                                           const std::vector<bool> &reaches_far)
  {
    std::vector<int> is_between(ownership.size());
    // One of two unknowns that meet across: first those of far reach, as they settle most others.
    for (const bool is_first : {true, false})
    {
      std::vector<int> found = is_between;
      for (std::size_t k = 0; k < lower.size(); ++k)
      {
        const int  row = lower.rows[k], column = lower.columns[k];
        const bool is_settled = is_between[row] + is_between[column] > 0;
        if (is_settled || ownership.find_rank(column) == ownership.find_rank(row))
          continue;
        if (!is_first || reaches_far[row] != reaches_far[column])
          found[is_first && reaches_far[column] ? column : row] = 1;
      }
      Utilities::MPI::max(found, communicator, is_between);
    }
    place.assign(ownership.size(), nowhere);
    n_interface = 0;
    for (unsigned int i = 0; i < place.size(); ++i)
      if (is_between[i] == 1)
        place[i] = n_interface++;

    interior.clear();
    owned_interface.clear();
    for (unsigned int i = ownership.get_begin(rank); i < ownership.get_end(rank); ++i)
      (place[i] == nowhere ? interior : owned_interface).push_back(i);
  }

  DistributedCholesky::Parts DistributedCholesky::divide(const Triplets &lower) const
  {
    Parts                     parts;
    Triplets                  inside;
    std::vector<unsigned int> owners;
    for (std::size_t k = 0; k < lower.size(); ++k)
    {
      const int row = lower.rows[k], column = lower.columns[k];
      if (place[row] != nowhere && place[column] != nowhere)
      {
        parts.between.add(place[row], place[column], lower.values[k]);
        continue;
      }
      inside.add(row, column, lower.values[k]);
      owners.push_back(ownership.find_rank(place[row] == nowhere ? row : column));
    }
    parts.inside = exchange(inside, owners, communicator);
    return parts;
  }

  void DistributedCholesky::number_unknowns(Triplets &inside)
  {
    std::set<int> places;
    for (const std::vector<int> *unknowns : {&inside.rows, &inside.columns})
      for (const int i : *unknowns)
        if (place[i] != nowhere)
          places.insert(place[i]);
    met_interface.assign(places.begin(), places.end());

    const auto find = [](const std::vector<int> &all, const int one) {
      return static_cast<int>(std::lower_bound(all.begin(), all.end(), one) - all.begin());
    };
    const int n_interior = interior.size();
    for (std::vector<int> *unknowns : {&inside.rows, &inside.columns})
      for (int &i : *unknowns)
        i = place[i] == nowhere ? find(interior, i) : n_interior + find(met_interface, place[i]);
    for (std::size_t k = 0; k < inside.size(); ++k)
      if (inside.rows[k] < inside.columns[k]) // an interior unknown behind one of the interface
        std::swap(inside.rows[k], inside.columns[k]);
  }

  bool DistributedCholesky::factorize_interior(Triplets &inside, Triplets &between)
  {
    number_unknowns(inside);
    std::vector<double> bounds(n_interface); // of the eigenvalues of A_kk, by Gershgorin's circles
    for (std::size_t k = 0; k < between.size(); ++k)
    {
      bounds[between.rows[k]] += std::abs(between.values[k]);
      if (between.rows[k] != between.columns[k])
        bounds[between.columns[k]] += std::abs(between.values[k]);
    }
    Utilities::MPI::sum(bounds, communicator, bounds);

    bool is_definite = true;
    run_on_all(communicator, [&]() {
      const unsigned int n_interior = interior.size(), n_met = met_interface.size();
      for (unsigned int k = 0; k < n_met; ++k)
        inside.add(n_interior + k, n_interior + k, bounds[met_interface[k]]);
      if (n_interior > 0)
        is_definite = interior_factor.factorize(n_interior + n_met, inside, n_met);
      if (n_met == 0 || !is_definite)
        return;
      corner = interior_factor.extract_last(n_met);
      LAPACKFullMatrix<double> schur_complement(n_met);
      corner.mTmult(schur_complement, corner);
      for (unsigned int i = 0; i < n_met; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          between.add(met_interface[i], met_interface[j],
                      schur_complement(i, j) - (i == j ? bounds[met_interface[i]] : 0));
    });
    return Utilities::MPI::min(static_cast<int>(is_definite), communicator) == 1;
  }

  bool DistributedCholesky::factorize(const IndexSet &owned, const Triplets &entries,
                                      const std::vector<bool> &reaches_far)
  {
    ownership            = Ownership(owned.n_elements(), communicator);
    const Triplets lower = take_lower(entries);
    find_interface(lower, reaches_far);
    auto [inside, between] = divide(lower);
    bool is_definite       = factorize_interior(inside, between);
    if (is_definite && n_interface > 0)
    {
      const Triplets all = gather_on_root(between, communicator);
      run_on_root(communicator, [&]() {
        is_definite = interface_factor.factorize(n_interface, all, n_interface);
      });
      is_definite = Utilities::MPI::min(static_cast<int>(is_definite), communicator) == 1;
      with_interface.reinit(rank == 0 ? complete_index_set(n_interface) : IndexSet(n_interface),
                            get_own_interface(), communicator);
    }
    return is_definite;
  }

  IndexSet DistributedCholesky::get_own_interface() const
  {
    std::vector<unsigned int> places(met_interface.begin(), met_interface.end());
    for (const int i : owned_interface)
      places.push_back(place[i]);
    std::sort(places.begin(), places.end());
    IndexSet own(n_interface);
    own.add_indices(places.begin(), places.end());
    return own;
  }

  void DistributedCholesky::solve(FieldVector &values) const
  {
    const unsigned int n_interior = interior.size();
    Vector<double>     own(n_interior + met_interface.size());
    for (unsigned int k = 0; k < n_interior; ++k)
      own[k] = values(interior[k]);
    if (n_interior > 0)
      interior_factor.solve_lower(own);
    if (n_interface > 0)
      solve_interface(own, values);
    if (n_interior > 0)
      interior_factor.solve_upper(own);
    for (unsigned int k = 0; k < n_interior; ++k)
      values(interior[k]) = own[k];
  }

  void DistributedCholesky::solve_interface(Vector<double> &own, FieldVector &values) const
  {
    const unsigned int n_met = met_interface.size();
    const auto         last  = own.end() - n_met; // L_kk^-1 times what the interior leaves
    Vector<double>     ordered(last, own.end()), product(n_met);
    FieldVector        at_interface(with_interface);
    if (n_met > 0)
      corner.vmult(product, ordered);
    for (unsigned int k = 0; k < n_met; ++k)
      at_interface(met_interface[k]) = product[k];
    for (const int i : owned_interface)
      at_interface(place[i]) += values(i);
    at_interface.compress(VectorOperation::add);

    if (rank == 0)
    {
      Vector<double> all(at_interface.begin(), at_interface.begin() + n_interface);
      interface_factor.solve(all);
      std::copy(all.begin(), all.end(), at_interface.begin());
    }
    at_interface.update_ghost_values();

    for (unsigned int k = 0; k < n_met; ++k)
      product[k] = at_interface(met_interface[k]);
    if (n_met > 0)
      corner.Tvmult(ordered, product);
    std::copy(ordered.begin(), ordered.end(), last); // L_kk^T times the solution
    for (const int i : owned_interface)
      values(i) = at_interface(place[i]);
  }
} // namespace caudal
