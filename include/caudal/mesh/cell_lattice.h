// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_cell_lattice_h
#define caudal_mesh_cell_lattice_h

#include <caudal/mesh/domain.h>

#include <deal.II/base/bounding_box.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>
#include <unordered_set>

namespace caudal
{
  /**
   * Integer coordinates of the congruent cells: on level l the cell with the
   * coordinates i occupies lower_corner + h_l * [i, i+1).
   */
  template <int dim>
  class CellLattice
  {
  public:
    using Coordinates = std::array<int, dim>;

    explicit CellLattice(const DomainParameters<dim> &domain)
        : domain(domain)
    {}

    unsigned int get_finest_level() const
    {
      return domain.get_finest_level();
    }

    Tensor<1, dim> get_cell_size(unsigned int level) const
    {
      return domain.get_cell_size(level);
    }

    /** The coordinates on @p level of the cell that holds @p point (inside the domain or not). */
    Coordinates get_coordinates(const Point<dim> &point, unsigned int level) const;
    bool        is_inside(const Coordinates &coordinates, unsigned int level) const;
    int         get_number_of_cells(const unsigned int direction, const unsigned int level) const
    {
      return domain.cells[direction] << level;
    }
    bool is_periodic(const unsigned int direction) const
    {
      return domain.is_periodic(direction);
    }
    /** The cell of the domain that this one, outside in a periodic direction, repeats. */
    Coordinates wrap(Coordinates coordinates, unsigned int level) const;
    Point<dim>  get_lower_corner(const Coordinates &coordinates, unsigned int level) const;

  private:
    const DomainParameters<dim> domain;
  };

  /**
   * Calls operation(coordinates) for all cells from @p first to @p last, in each direction, until
   * one call returns true. Returns whether one did.
   */
  template <std::size_t dim, class Operation>
  bool any_cell_between(const std::array<int, dim> &first, const std::array<int, dim> &last,
                        const Operation &operation)
  {
    for (auto cell = first;;)
    {
      if (operation(cell))
        return true;
      unsigned int d = 0;
      for (; d < dim && cell[d] >= last[d]; ++d)
        cell[d] = first[d];
      if (d == dim)
        return false;
      ++cell[d];
    }
  }

  /** A set of cells together with their ancestors on all levels. */
  template <int dim>
  class CellSet
  {
  public:
    explicit CellSet(const CellLattice<dim> &lattice);

    /** Adds every cell of the domain and of @p level that meets one of the @p boxes, each enlarged
     * by @p margin cells. */
    void add(const std::vector<BoundingBox<dim>> &boxes, double margin, unsigned int level);

    /** Whether the cell, or one inside of it, belongs to the set. */
    bool contains(const Point<dim> &cell_center, unsigned int level) const;

    /** Whether a cell inside of it, and finer than it, belongs to the set. */
    bool contains_finer(const Point<dim> &cell_center, unsigned int level) const;

    /** Number of cells of the finest level. */
    std::size_t size() const
    {
      return cells.back().size();
    }

    /** Whether each of the set's cells of the finest level is an active one (collective). */
    bool is_covered_by(const parallel::distributed::Triangulation<dim> &triangulation) const;

  private:
    using Coordinates = typename CellLattice<dim>::Coordinates;

    const CellLattice<dim> &lattice;

    std::vector<std::unordered_set<Coordinates, boost::hash<Coordinates>>> cells; // by level
  };

  /** Finds the locally owned active cells, down to a coarsest level, by their coordinates. */
  template <int dim>
  class ActiveCells
  {
  public:
    using Cell        = typename Triangulation<dim>::active_cell_iterator;
    using Coordinates = typename CellLattice<dim>::Coordinates;

    ActiveCells(const CellLattice<dim> &lattice, const Triangulation<dim> &triangulation,
                unsigned int coarsest_level);

    /** nullptr if the cell is not there, not an active one of this level or another rank's. */
    const Cell *find(const Coordinates &coordinates, unsigned int level) const;

    /** Whether one of this level meets the @p box, enlarged by @p margin cells. */
    bool meet(const BoundingBox<dim> &box, double margin, unsigned int level) const;

    unsigned int get_coarsest_level() const
    {
      return coarsest_level;
    }

    const CellLattice<dim> &get_lattice() const
    {
      return lattice;
    }

  private:
    const CellLattice<dim> &lattice;

    const unsigned int coarsest_level;

    struct Level
    {
      std::unordered_map<Coordinates, Cell, boost::hash<Coordinates>> cells;
      Coordinates lowest, highest; // in each direction
    };
    std::vector<Level> levels; // from the coarsest one on
  };
} // namespace caudal

#endif
