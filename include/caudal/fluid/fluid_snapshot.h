// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_fluid_snapshot_h
#define caudal_fluid_fluid_snapshot_h

#include <caudal/fluid/fluid_space.h>

#include <deal.II/grid/cell_id.h>

#include <boost/serialization/vector.hpp>

#include <cstdint>

namespace caudal
{
  /**
   * Values of the fluid's fields cell by cell: exact, and independent of the number of ranks and
   * of the numbering of cells and unknowns.
   */
  struct FluidSnapshot
  {
    /** CellId::to_binary() of active cells, one after the other. */
    std::vector<std::uint32_t> cells;
    /** For each of them the nodal values of the velocity fields and those of the pressure. */
    std::vector<double> values;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &cells &values;
    }
  };

  /** The snapshot of this rank's cells. The fields have up-to-date ghost values. */
  template <int dim>
  FluidSnapshot take_snapshot(const FluidSpace<dim>                  &space,
                              const std::vector<const FieldVector *> &velocities,
                              const FieldVector                      &pressure);

  /** The ids of its cells, in their order. */
  std::vector<dealii::CellId::binary_type> get_cells(const FluidSnapshot &snapshot);

  /** Throws the sentence that a snapshot is that of another grid unless it @p fits. */
  void check_fit(bool fits);

  /**
   * Sets the fields on the grid of the @p snapshot, which holds at least this rank's cells, to its
   * values. Throws if it has been taken of another number of fields. Collective.
   */
  template <int dim>
  void restore_fields(const FluidSnapshot &snapshot, const FluidSpace<dim> &space,
                      const std::vector<FieldVector *> &velocities, FieldVector &pressure);
} // namespace caudal

#endif
