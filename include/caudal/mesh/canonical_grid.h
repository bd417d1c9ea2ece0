// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_canonical_grid_h
#define caudal_mesh_canonical_grid_h

#include <caudal/mesh/domain.h>

namespace caudal
{
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
