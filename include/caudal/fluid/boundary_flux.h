// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_boundary_flux_h
#define caudal_fluid_boundary_flux_h

#include <caudal/fluid/fluid_space.h>

namespace caudal
{
  /**
   * Throws a sentence if, until @p end_time [s], the velocities that the sides prescribe bring
   * more fluid into the domain than they let out, or less, and no side is open for the rest: there
   * is no incompressible flow then. Fluxes whose sum is less than 1e-6 of their moduli's cancel.
   * Collective.
   */
  template <int dim>
  void check_boundary_flux(const FluidSpace<dim> &space, double end_time);
} // namespace caudal

#endif
