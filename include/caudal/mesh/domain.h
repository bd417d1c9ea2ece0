// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_domain_h
#define caudal_mesh_domain_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /**
   * Section `Domain`: a box of congruent coarse cells. Its sides have the
   * boundary ids 0 left, 1 right, 2 bottom, 3 top, 4 back, 5 front.
   */
  template <int dim>
  struct DomainParameters
  {
    Point<dim>                lower_corner;
    Point<dim>                size;
    std::vector<unsigned int> cells               = std::vector<unsigned int>(dim, 8);
    unsigned int              levels              = 4;
    std::string               periodic_directions = "none";
    std::string               frame               = "fixed";
    std::string               frame_velocity;
    double                    frame_time = 0;

    DomainParameters();
    void add_parameters(ParameterHandler &prm);
    void check() const;

    /** Edges of a cell of refinement level @p level [m]. */
    Tensor<1, dim> get_cell_size(const unsigned int level) const
    {
      Tensor<1, dim> edges;
      for (unsigned int d = 0; d < dim; ++d)
        edges[d] = size[d] / cells[d] / (1 << level);
      return edges;
    }

    /** The mean edge of the cells of the finest level [m]. */
    double get_finest_cell() const
    {
      return get_cell_size(get_finest_level()).norm() / std::sqrt(dim);
    }

    /** Whether what leaves the domain in this direction comes back on the other side. */
    bool is_periodic(const unsigned int direction) const
    {
      return periodic_directions.find("xyz"[direction]) != std::string::npos;
    }

    /** Whether the grid moves. */
    bool has_moving_frame() const
    {
      return frame != "fixed";
    }

    /** Throws a sentence unless the frame is that of the grid or of one of the @p bodies. */
    void check_frame(const std::vector<std::string> &bodies, bool is_explicit) const;

    double get_shortest_side() const
    {
      double shortest = size[0];
      for (unsigned int d = 1; d < dim; ++d)
        shortest = std::min(shortest, size[d]);
      return shortest;
    }

    unsigned int get_finest_level() const
    {
      return levels - 1;
    }

    /** Spacing of the lattice of velocity nodes on the finest level: half a cell [m]. */
    Tensor<1, dim> get_finest_spacing() const
    {
      return 0.5 * get_cell_size(get_finest_level());
    }
  };

  /** The sides' names in the order of their boundary ids. */
  std::vector<std::string> get_side_names(unsigned int dim);

  /** The unrefined grid of the domain. */
  template <int dim>
  void make_domain(parallel::distributed::Triangulation<dim> &triangulation,
                   const DomainParameters<dim>               &parameters);

  /**
   * Builds the cells of @p triangulation anew, from the coarse grid of the domain to the leaves of
   * its forest. The order of the cells, and with it that of the unknowns and of all sums over
   * cells, then depends on the forest alone and not on how the grid came about: a grid that was
   * adapted for a long time and one that was read from a checkpoint are the same. Each rank keeps
   * its cells. Collective.
   */
  template <int dim>
  void make_canonical(parallel::distributed::Triangulation<dim> &triangulation,
                      const DomainParameters<dim>               &domain);
} // namespace caudal

#endif
