// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/fluid/fluid_snapshot.h>

#include <deal.II/grid/cell_id.h>

#include <map>

namespace caudal
{
  namespace
  {
    using Key = CellId::binary_type;

    /** The places of the snapshot's cells in it. */
    std::map<Key, std::size_t> make_index(const FluidSnapshot &snapshot)
    {
      std::map<Key, std::size_t> index;
      for (const Key &cell : get_cells(snapshot))
        index.emplace(cell, index.size());
      return index;
    }

    /** The values of @p field in the cell, by the unknowns of @p dofs. */
    template <int dim>
    Vector<double> get_values(const DoFHandler<dim> &dofs, const CellAccessor<dim> &cell,
                              const FieldVector &field)
    {
      Vector<double> values(dofs.get_fe().n_dofs_per_cell());
      typename DoFHandler<dim>::active_cell_iterator(cell, &dofs)->get_dof_values(field, values);
      return values;
    }

    /** Sets the cell's values of @p field from @p value on, which moves on. */
    template <int dim>
    void set_values(const DoFHandler<dim> &dofs, const CellAccessor<dim> &cell, FieldVector &field,
                    std::vector<double>::const_iterator &value)
    {
      Vector<double> values(dofs.get_fe().n_dofs_per_cell());
      for (double &one : values)
        one = *value++;
      typename DoFHandler<dim>::active_cell_iterator(cell, &dofs)->set_dof_values(values, field);
    }
  } // namespace

  std::vector<CellId::binary_type> get_cells(const FluidSnapshot &snapshot)
  {
    constexpr unsigned int           key_size = std::tuple_size<CellId::binary_type>::value;
    std::vector<CellId::binary_type> cells(snapshot.cells.size() / key_size);
    for (std::size_t k = 0; k < cells.size(); ++k)
      std::copy_n(snapshot.cells.begin() + k * key_size, key_size, cells[k].begin());
    return cells;
  }

  void check_fit(const bool fits)
  {
    AssertThrow(fits, ExcMessage("The checkpoint holds the fluid on another grid. Resume with the "
                                 "Domain that wrote it."));
  }

  template <int dim>
  FluidSnapshot take_snapshot(const FluidSpace<dim>                  &space,
                              const std::vector<const FieldVector *> &velocities,
                              const FieldVector                      &pressure)
  {
    FluidSnapshot snapshot;
    for (const auto &cell : space.get_triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const Key key = cell->id().template to_binary<dim>();
        snapshot.cells.insert(snapshot.cells.end(), key.begin(), key.end());
        const auto append = [&](const Vector<double> &values) {
          snapshot.values.insert(snapshot.values.end(), values.begin(), values.end());
        };
        for (const FieldVector *velocity : velocities)
          append(get_values(space.velocity_dofs, *cell, *velocity));
        append(get_values(space.pressure_dofs, *cell, pressure));
      }
    return snapshot;
  }

  template <int dim>
  void restore_fields(const FluidSnapshot &snapshot, const FluidSpace<dim> &space,
                      const std::vector<FieldVector *> &velocities, FieldVector &pressure)
  {
    const auto         index  = make_index(snapshot);
    const unsigned int stride = velocities.size() * space.velocity_element.n_dofs_per_cell() +
                                space.pressure_element.n_dofs_per_cell();
    run_on_all(space.get_communicator(),
               [&]() { check_fit(snapshot.values.size() == index.size() * stride); });
    for (FieldVector *velocity : velocities)
      velocity->reinit(space.get_velocity_layout());
    pressure.reinit(space.make_pressure_vector());
    for (const auto &cell : space.get_triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
      {
        auto value =
            snapshot.values.begin() + index.at(cell->id().template to_binary<dim>()) * stride;
        for (FieldVector *velocity : velocities)
          set_values(space.velocity_dofs, *cell, *velocity, value);
        set_values(space.pressure_dofs, *cell, pressure, value);
      }
    for (FieldVector *velocity : velocities)
      velocity->update_ghost_values();
    pressure.update_ghost_values();
  }

#define INSTANTIATE(dim)                                                                           \
  template FluidSnapshot take_snapshot(                                                            \
      const FluidSpace<dim> &, const std::vector<const FieldVector *> &, const FieldVector &);     \
  template void restore_fields(const FluidSnapshot &, const FluidSpace<dim> &,                     \
                               const std::vector<FieldVector *> &, FieldVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
