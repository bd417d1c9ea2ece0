// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_boundary_elements_h
#define caudal_ideal_boundary_elements_h

#include <caudal/ideal/exterior_flow.h>

namespace caudal::ideal
{
  /**
   * Boundary elements for Laplace's equation outside of a closed surface, with given
   * normal derivative u.n on it (n out of the body) and decay at infinity. Green's third
   * identity at a node x of the surface, with the potential's value at x subtracted so that
   * no solid angle appears and all integrals of the double layer are bounded:
   *
   *   phi(x) - int (phi(y) - phi(x)) dG/dn_y dS = - int G u.n dS
   *
   * (e.g. C. Pozrikidis, A Practical Guide to Boundary Element Methods, 2002, chapter 2).
   * Collocation at all nodes; phi is quadratic on each cell, like the surface; u.n is not
   * interpolated. Nearly singular integrals over a cell are computed on parts of it which
   * are the smaller the nearer they are to x.
   */
  class BoundaryElements
  {
  public:
    /** The rows of the matrix are shared among the ranks of @p communicator. */
    BoundaryElements(const Surface &surface, const MPI_Comm communicator)
        : surface(surface)
        , communicator(communicator)
        , rules(surface.get_fe())
    {}

    /** The flow, equal on all ranks. Throws if the matrix is singular. Collective. */
    ExteriorFlow solve(SurfaceMotion motion)
    {
      return ExteriorFlow(surface, std::move(motion), rules, communicator, cost);
    }

    const BoundaryElementCost &get_cost() const
    {
      return cost;
    }

  private:
    const Surface      &surface;
    const MPI_Comm      communicator;
    ReferenceRules      rules;
    BoundaryElementCost cost;
  };
} // namespace caudal::ideal

#endif
