#ifndef caudal_potential_boundary_elements_h
#define caudal_potential_boundary_elements_h

#include <caudal/potential/surface_quadrature.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

namespace caudal::potential
{
  /**
   * The flow around a surface for each of its motions: the three rotations about the
   * origin, the three translations, and the modes of SurfaceMotion, in this order.
   */
  struct Potentials
  {
    /** phi_k at the surface's nodes for unit rate of motion k; by node, motion [m^2 or m^3]. */
    FullMatrix<double> values;

    /**
     * The fluid's mass matrix over its density, -int phi_k (u_l.n) dS, u_l the surface's
     * velocity in motion l, symmetrised [m^3 to m^5].
     */
    FullMatrix<double> added_mass;

    double volume = 0.; ///< inside the surface [m^3]
  };

  /** What computing potentials has cost, in s of CPU of this rank. */
  struct BoundaryElementCost
  {
    double assembly = 0.;
    double solution = 0.;
  };

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
    BoundaryElements(const Surface &surface, MPI_Comm communicator);

    /** Collective; every rank gets the same. Throws if the matrix is singular. */
    Potentials compute_potentials(const SurfaceMotion &motion);

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
} // namespace caudal::potential

#endif
