// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/compatibility.h>
#include <caudal/fluid/snapshot_index.h>

#include <deal.II/base/mpi.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>

using namespace dealii;

namespace caudal
{
  namespace
  {
    using Key = CellId::binary_type;

    void append(const Key &key, const double *const begin, const std::size_t n_values,
                FluidSnapshot &snapshot)
    {
      snapshot.cells.insert(snapshot.cells.end(), key.begin(), key.end());
      snapshot.values.insert(snapshot.values.end(), begin, begin + n_values);
    }
  } // namespace

  template <int dim>
  SnapshotIndex<dim>::SnapshotIndex(const FluidSnapshot &part, const MPI_Comm communicator)
      : communicator(communicator)
  {
    const std::vector<Key> keys     = get_cells(part);
    const std::size_t      n_values = keys.empty() ? 0 : part.values.size() / keys.size();
    std::map<unsigned int, FluidSnapshot>    cells;
    std::set<Key>                            all_refined;
    std::map<unsigned int, std::vector<Key>> parents;
    for (std::size_t k = 0; k < keys.size(); ++k)
    {
      append(keys[k], part.values.data() + k * n_values, n_values, cells[find_rank(keys[k])]);
      const CellId id(keys[k]);
      const auto   children = id.get_child_indices();
      for (unsigned int level = 0; level < children.size(); ++level)
        all_refined.insert(
            CellId(id.get_coarse_cell_id(), level, children.data()).template to_binary<dim>());
    }
    for (const Key &key : all_refined)
      parents[find_rank(key)].push_back(key);

    for (const auto &message : Utilities::MPI::some_to_some(communicator, cells))
    {
      const std::vector<Key> received = get_cells(message.second);
      const std::size_t      n        = message.second.values.size() / received.size();
      for (std::size_t k = 0; k < received.size(); ++k)
      {
        const auto begin = message.second.values.begin() + k * n;
        values[received[k]].assign(begin, begin + n);
      }
    }
    for (const auto &message : Utilities::MPI::some_to_some(communicator, parents))
      refined.insert(message.second.begin(), message.second.end());
    n_cells = Utilities::MPI::sum(static_cast<unsigned int>(values.size()), communicator);
  }

  template <int dim>
  unsigned int SnapshotIndex<dim>::find_rank(const Key &cell) const
  {
    return boost::hash_range(cell.begin(), cell.end()) %
           Utilities::MPI::n_mpi_processes(communicator);
  }

  template <int dim>
  template <typename Answer>
  std::vector<Answer>
  SnapshotIndex<dim>::ask(const std::vector<Key>                   &cells,
                          const std::function<Answer(const Key &)> &answer) const
  {
    std::map<unsigned int, std::vector<Key>>    questions;
    std::map<unsigned int, std::vector<Answer>> answers;
    for (const Key &cell : cells)
      questions[find_rank(cell)].push_back(cell);
    for (const auto &question : Utilities::MPI::some_to_some(communicator, questions))
      for (const Key &cell : question.second)
        answers[question.first].push_back(answer(cell));
    const auto received = Utilities::MPI::some_to_some(communicator, answers);

    std::map<unsigned int, std::size_t> next; // answer of a rank
    std::vector<Answer>                 all;
    for (const Key &cell : cells)
    {
      const unsigned int rank = find_rank(cell);
      all.push_back(received.at(rank)[next[rank]++]);
    }
    return all;
  }

  template <int dim>
  std::vector<char> SnapshotIndex<dim>::are_refined(const std::vector<Key> &cells) const
  {
    return ask<char>(cells, [&](const Key &cell) { return refined.count(cell) > 0; });
  }

  template <int dim>
  FluidSnapshot SnapshotIndex<dim>::extract(const Triangulation<dim> &grid) const
  {
    std::vector<Key> cells;
    for (const auto &cell : grid.active_cell_iterators())
      if (cell->is_locally_owned())
        cells.push_back(cell->id().template to_binary<dim>());
    const auto    all = ask<std::vector<double>>(cells, [&](const Key &cell) {
      const auto found = values.find(cell);
      return found == values.end() ? std::vector<double>() : found->second;
    });
    FluidSnapshot snapshot;
    run_on_all(communicator, [&]() {
      for (std::size_t k = 0; k < cells.size(); ++k)
      {
        check_fit(!all[k].empty());
        append(cells[k], all[k].data(), all[k].size(), snapshot);
      }
    });
    return snapshot;
  }

  template <int dim>
  void restore_grid(const SnapshotIndex<dim> &snapshot, const DomainParameters<dim> &domain,
                    parallel::distributed::Triangulation<dim> &triangulation)
  {
    triangulation.clear();
    make_domain(triangulation, domain);
    for (unsigned int level = 0;; ++level)
    {
      std::vector<typename Triangulation<dim>::active_cell_iterator> cells;
      std::vector<Key>                                               keys;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->level() == static_cast<int>(level))
        {
          cells.push_back(cell);
          keys.push_back(cell->id().template to_binary<dim>());
        }
      const std::vector<char> are_refined = snapshot.are_refined(keys);
      int                     refines     = 0;
      for (std::size_t k = 0; k < cells.size(); ++k)
        if (are_refined[k])
        {
          cells[k]->set_refine_flag();
          refines = 1;
        }
      if (Utilities::MPI::max(refines, compatibility::get_communicator(triangulation)) == 0)
        break;
      check_fit(level + 1 < domain.levels);
      triangulation.execute_coarsening_and_refinement();
    }
    check_fit(triangulation.n_global_active_cells() == snapshot.get_n_cells());
  }

#define INSTANTIATE(dim)                                                                           \
  template class SnapshotIndex<dim>;                                                               \
  template void restore_grid(const SnapshotIndex<dim> &, const DomainParameters<dim> &,            \
                             parallel::distributed::Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
