// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_size_check_h
#define caudal_viscous_size_check_h

#include <caudal/viscous/flow_scales.h>

namespace caudal
{
  /**
   * Throws a sentence if the memory does not suffice for the bodies' grids and the fluid's coarse
   * grid, which each rank has as a whole. Collective.
   */
  template <int dim>
  void check_sizes(const RunParameters<dim> &parameters, MPI_Comm communicator);

  /** Throws a sentence if it does not suffice for the finest cells that lie in the @p bodies. */
  template <int dim>
  void check_fluid_size(const RunParameters<dim> &parameters, const Bodies<dim> &bodies,
                        MPI_Comm communicator);

  /** Throws a sentence if it does not suffice for the cells that are flagged to be refined. */
  template <int dim>
  void check_growth(const parallel::distributed::Triangulation<dim> &triangulation);
} // namespace caudal

#endif
