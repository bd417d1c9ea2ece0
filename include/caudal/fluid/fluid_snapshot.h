#ifndef caudal_fluid_fluid_snapshot_h
#define caudal_fluid_fluid_snapshot_h

#include <caudal/fluid/fluid_state.h>

#include <boost/serialization/vector.hpp>

#include <cstdint>

namespace caudal
{
  /**
   * The fluid's grid and fields, cell by cell: exact, and independent of the
   * number of ranks and of the numbering of cells and unknowns.
   */
  struct FluidSnapshot
  {
    /** CellId::to_binary() of the active cells, one after the other. */
    std::vector<std::uint32_t> cells;
    /** For each of them the nodal values of u at t^n, u at t^{n-1} and p. */
    std::vector<double> values;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &cells &values;
    }
  };

  /** Collects the snapshot of @p state on rank 0; on the other ranks it is empty. Collective. */
  template <int dim>
  FluidSnapshot take_snapshot(const FluidSpace<dim> &space, const FluidState<dim> &state);

  /**
   * Makes @p triangulation the grid of the @p snapshot, which all ranks hold, from the coarse
   * grid on. The result depends on nothing else, not even on the grid that it was before.
   * Throws if the snapshot is that of another domain. Collective.
   */
  template <int dim>
  void restore_grid(const FluidSnapshot &snapshot, const DomainParameters<dim> &domain,
                    parallel::distributed::Triangulation<dim> &triangulation);

  /** Sets @p state, on the grid of restore_grid(), to the snapshot's fields. Collective. */
  template <int dim>
  void restore_fields(const FluidSnapshot &snapshot, const FluidSpace<dim> &space,
                      FluidState<dim> &state);
} // namespace caudal

#endif
