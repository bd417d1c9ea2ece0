// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/mesh/cell_lattice.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace caudal
{
  template <int dim>
  typename CellLattice<dim>::Coordinates
  CellLattice<dim>::get_coordinates(const Point<dim> &point, const unsigned int level) const
  {
    const Tensor<1, dim> h = get_cell_size(level);
    Coordinates          coordinates;
    for (unsigned int d = 0; d < dim; ++d)
      coordinates[d] = std::floor((point[d] - domain.lower_corner[d]) / h[d]);
    return coordinates;
  }

  template <int dim>
  bool CellLattice<dim>::is_inside(const Coordinates &coordinates, const unsigned int level) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (coordinates[d] < 0 || coordinates[d] >= static_cast<int>(domain.cells[d] << level))
        return false;
    return true;
  }

  template <int dim>
  typename CellLattice<dim>::Coordinates CellLattice<dim>::wrap(Coordinates        coordinates,
                                                                const unsigned int level) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (domain.is_periodic(d))
      {
        const int n    = get_number_of_cells(d, level);
        coordinates[d] = ((coordinates[d] % n) + n) % n;
      }
    return coordinates;
  }

  template <int dim>
  Point<dim> CellLattice<dim>::get_lower_corner(const Coordinates &coordinates,
                                                const unsigned int level) const
  {
    const Tensor<1, dim> h      = get_cell_size(level);
    Point<dim>           corner = domain.lower_corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] += coordinates[d] * h[d];
    return corner;
  }

  template <int dim>
  CellSet<dim>::CellSet(const CellLattice<dim> &lattice)
      : lattice(lattice)
      , cells(lattice.get_finest_level() + 1)
  {}

  template <int dim>
  void CellSet<dim>::add(const std::vector<BoundingBox<dim>> &boxes, const double margin,
                         const unsigned int level)
  {
    const Tensor<1, dim> slack = margin * lattice.get_cell_size(level);
    for (const BoundingBox<dim> &box : boxes)
    {
      const auto &[lower, upper] = box.get_boundary_points();
      any_cell_between(lattice.get_coordinates(lower - slack, level),
                       lattice.get_coordinates(upper + slack, level), [&](auto cell) {
                         cell = lattice.wrap(cell, level);
                         if (lattice.is_inside(cell, level))
                           // Once an ancestor is known, so are all above it.
                           for (int l = level; l >= 0 && cells[l].insert(cell).second; --l)
                             for (int &coordinate : cell)
                               coordinate >>= 1;
                         return false;
                       });
    }
  }

  template <int dim>
  bool CellSet<dim>::contains(const Point<dim> &cell_center, const unsigned int level) const
  {
    return cells[level].count(lattice.get_coordinates(cell_center, level)) > 0;
  }

  template <int dim>
  bool CellSet<dim>::contains_finer(const Point<dim> &cell_center, const unsigned int level) const
  {
    if (!contains(cell_center, level))
      return false;
    const Coordinates parent = lattice.get_coordinates(cell_center, level);
    Coordinates       first, last;
    for (unsigned int d = 0; d < dim; ++d)
    {
      first[d] = 2 * parent[d];
      last[d]  = first[d] + 1;
    }
    return any_cell_between(first, last,
                            [&](const auto &child) { return cells[level + 1].count(child) > 0; });
  }

  template <int dim>
  bool
  CellSet<dim>::is_covered_by(const parallel::distributed::Triangulation<dim> &triangulation) const
  {
    const unsigned int finest  = lattice.get_finest_level();
    std::size_t        n_found = 0;
    if (triangulation.n_levels() > finest)
      for (const auto &cell : triangulation.active_cell_iterators_on_level(finest))
        if (cell->is_locally_owned() && contains(cell->center(), finest))
          ++n_found;
    return Utilities::MPI::sum(n_found, compatibility::get_communicator(triangulation)) == size();
  }

  template <int dim>
  ActiveCells<dim>::ActiveCells(const CellLattice<dim>   &lattice,
                                const Triangulation<dim> &triangulation,
                                const unsigned int        coarsest_level)
      : lattice(lattice)
      , coarsest_level(coarsest_level)
      , levels(lattice.get_finest_level() + 1 - coarsest_level)
  {
    for (unsigned int l = coarsest_level; l <= lattice.get_finest_level(); ++l)
    {
      Level &level = levels[l - coarsest_level];
      level.lowest.fill(std::numeric_limits<int>::max());
      level.highest.fill(std::numeric_limits<int>::lowest());
      if (l >= triangulation.n_levels())
        continue;
      for (const auto &cell : triangulation.active_cell_iterators_on_level(l))
        if (cell->is_locally_owned())
        {
          const auto coordinates = lattice.get_coordinates(cell->center(), l);
          level.cells.emplace(coordinates, cell);
          for (unsigned int d = 0; d < dim; ++d)
          {
            level.lowest[d]  = std::min(level.lowest[d], coordinates[d]);
            level.highest[d] = std::max(level.highest[d], coordinates[d]);
          }
        }
    }
  }

  template <int dim>
  const typename ActiveCells<dim>::Cell *ActiveCells<dim>::find(const Coordinates &coordinates,
                                                                const unsigned int level) const
  {
    const auto       &cells   = levels[level - coarsest_level].cells;
    const Coordinates wrapped = lattice.wrap(coordinates, level);
    const auto        entry = lattice.is_inside(wrapped, level) ? cells.find(wrapped) : cells.end();
    return entry == cells.end() ? nullptr : &entry->second;
  }

  template <int dim>
  bool ActiveCells<dim>::meet(const BoundingBox<dim> &box, const double margin,
                              const unsigned int level) const
  {
    const Coordinates   &lowest  = levels[level - coarsest_level].lowest;
    const Coordinates   &highest = levels[level - coarsest_level].highest;
    const Tensor<1, dim> size    = lattice.get_cell_size(level);
    const Point<dim>     origin  = lattice.get_lower_corner({}, level);
    const auto &[lower, upper]   = box.get_boundary_points();
    Coordinates first, last;
    for (unsigned int d = 0; d < dim; ++d)
    {
      // Numbers that no integer holds are clipped before they become one.
      const double begin = std::floor((lower[d] - origin[d]) / size[d] - margin);
      const double end   = std::floor((upper[d] - origin[d]) / size[d] + margin);
      if (lattice.is_periodic(d))
      {
        // A box as long as the period meets all cells.
        const int  n        = lattice.get_number_of_cells(d, level);
        const bool is_short = end - begin < n && std::abs(begin) < 1e9;
        first[d]            = is_short ? begin : 0;
        last[d]             = is_short ? end : n - 1;
        continue;
      }
      if (!(begin <= highest[d] && end >= lowest[d]))
        return false;
      first[d] = std::max<double>(begin, lowest[d]);
      last[d]  = std::min<double>(end, highest[d]);
    }
    return any_cell_between(first, last,
                            [&](const auto &cell) { return find(cell, level) != nullptr; });
  }

  template class CellLattice<2>;
  template class CellLattice<3>;
  template class CellSet<2>;
  template class CellSet<3>;
  template class ActiveCells<2>;
  template class ActiveCells<3>;
} // namespace caudal
