// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_snapshot_index_h
#define caudal_fluid_snapshot_index_h

#include <caudal/fluid/fluid_snapshot.h>

#include <functional>
#include <map>
#include <set>

namespace caudal
{
  /**
   * Finds cells in the snapshots of all ranks, of which each has a part, and none has all: a cell
   * is kept by the rank that a hash of its id tells, and all who look for it ask there. Member
   * functions are collective.
   */
  template <int dim>
  class SnapshotIndex
  {
  public:
    using Key = dealii::CellId::binary_type;

    /** @p part: any cells; each of them on one rank. */
    SnapshotIndex(const FluidSnapshot &part, MPI_Comm communicator);

    /** Number of active cells on all ranks. */
    unsigned int get_n_cells() const
    {
      return n_cells;
    }

    /** Whether cells have been refined in the snapshot. */
    std::vector<char> are_refined(const std::vector<Key> &cells) const;

    /** That of this rank's active cells of a grid. Throws if there is one that is not active. */
    FluidSnapshot extract(const dealii::Triangulation<dim> &grid) const;

  private:
    unsigned int find_rank(const Key &cell) const;

    /** What the ranks that keep the @p cells answer about them, in their order. */
    template <typename Answer>
    std::vector<Answer> ask(const std::vector<Key>                   &cells,
                            const std::function<Answer(const Key &)> &answer) const;

    const MPI_Comm                     communicator;
    unsigned int                       n_cells = 0;
    std::map<Key, std::vector<double>> values; // of active cells that this rank keeps
    std::set<Key>                      refined;
  };

  /**
   * Makes @p triangulation the grid of the @p snapshot, from the coarse grid on. Throws if the
   * snapshot is that of another domain. Collective.
   */
  template <int dim>
  void restore_grid(const SnapshotIndex<dim> &snapshot, const DomainParameters<dim> &domain,
                    dealii::parallel::distributed::Triangulation<dim> &triangulation);
} // namespace caudal

#endif
