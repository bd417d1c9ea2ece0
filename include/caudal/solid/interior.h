// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_interior_h
#define caudal_solid_interior_h

#include <caudal/solid/solid_body.h>

namespace caudal
{
  /**
   * Whether each cell of a body lies in its interior: all its vertices are further than @p depth
   * [m] from those of the surface, in the reference configuration.
   */
  template <int dim>
  std::vector<bool> find_interior(const SolidBody<dim> &body, double depth);
} // namespace caudal

#endif
