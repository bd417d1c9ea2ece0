// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_boundary_flux_h
#define caudal_fluid_boundary_flux_h

#include <caudal/fluid/fluid_space.h>

#include <deal.II/base/function.h>

namespace caudal
{
  /** A prescribed velocity on the side of the domain with the boundary id @p side, whose component
   * out of the domain is multiplied by @p factor where it is positive. */
  template <int dim>
  class ScaledOutflow : public Function<dim>
  {
  public:
    ScaledOutflow(std::unique_ptr<Function<dim>> velocity, unsigned int side, double factor);

    double value(const Point<dim> &point, unsigned int component) const override;

  private:
    const std::unique_ptr<Function<dim>> velocity;
    const unsigned int                   side;
    const double                         factor;
  };

  /** What flows through the sides of the domain [m^2/s, in 3D m^3/s]. */
  struct BoundaryFlux
  {
    double net   = 0; // out of it
    double total = 0; // either way
  };

  /** The flux of the velocities that @p constraints prescribe on the sides. Collective. */
  template <int dim>
  BoundaryFlux compute_boundary_flux(const FluidSpace<dim>           &space,
                                     const AffineConstraints<double> &constraints);

  /**
   * The largest change of the factor by which FluidSpace multiplies outflows until @p end_time
   * [s]; 0 where a side is open. Throws a sentence if there is no incompressible flow, since
   * prescribed velocities bring more fluid into the domain than they let out, or less, by more
   * than a hundredth. Collective.
   */
  template <int dim>
  double check_boundary_flux(const FluidSpace<dim> &space, double end_time);
} // namespace caudal

#endif
