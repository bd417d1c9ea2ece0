// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_exterior_flow_h
#define caudal_ideal_exterior_flow_h

#include <caudal/ideal/placed_surface.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>

namespace caudal::ideal
{
  /** Kernels of potential theory between a point x and an element of the surface at y. */
  struct LaplaceKernel
  {
    double single_layer; ///< G(x,y) = 1/(4 pi |y - x|) [1/m]
    double double_layer; ///< dG/dn_y dS = -(y - x).N/(4 pi |y - x|^3), N = n dS [1/m, N in m^2]
  };

  /**
   * r = y - x [m], which must not be zero; N is the element's area times its normal [m^2]. By
   * coordinates, so that loops over points are vectorised.
   */
  inline LaplaceKernel evaluate_laplace_kernel(const double r_x, const double r_y, const double r_z,
                                               const double N_x, const double N_y, const double N_z)
  {
    const double inverse = 1. / (r_x * r_x + r_y * r_y + r_z * r_z);
    const double G       = std::sqrt(inverse) / (4. * numbers::PI);
    return {G, -(r_x * N_x + r_y * N_y + r_z * N_z) * inverse * G};
  }

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

  /** CPU time that flows have taken on this rank [s]. */
  struct BoundaryElementCost
  {
    double assembly = 0.;
    double solution = 0.;
    double gradient = 0.; ///< of energies
  };

  /**
   * The solved boundary integral equations of a surface in one position; see
   * BoundaryElements. If the surface and its modes are symmetric, z -> -z, the equations of one
   * half are computed, and those of the other half are their mirror images.
   */
  class ExteriorFlow
  {
  public:
    /** The equations are shared among the ranks of @p communicator. Collective. */
    ExteriorFlow(const Surface &surface, SurfaceMotion motion, ReferenceRules &rules,
                 MPI_Comm communicator, BoundaryElementCost &cost);

    ExteriorFlow(const ExteriorFlow &) = delete;

    /** The result, equal on all ranks. */
    const Potentials &get_potentials() const
    {
      return potentials;
    }

    /**
     * The derivatives of T/rho = (1/2) u^T M u, M the added mass, with respect to the
     * coordinates c_i of the modes [m^5], for fixed rates u of all motions. @p mode_rates are
     * sum_j u_(6+j) d^2X/(dc_i dc_j) by mode i and node.
     *
     * They are exact for the discrete equations A phi + b = 0, T/rho = -f.phi/2: with the
     * adjoint potential lambda, A^T lambda = f, it is dT/rho = (lambda.(dA phi + db) - df.phi)/2,
     * d for the change of places at fixed phi (e.g. M. B. Giles and N. A. Pierce, Flow Turbul.
     * Combust. 65, 2000, doi:10.1023/A:1011430410075). So one pass over the surface serves
     * all modes, and the work of the joints is the change of the energy also on coarse
     * surfaces. Collective.
     */
    std::vector<double>
    compute_energy_gradient(const std::vector<double>                    &u,
                            const std::vector<std::vector<Tensor<1, 3>>> &mode_rates);

    /**
     * Whether the energy of a sum of motions @p u and @p v can differ from the sum of their
     * energies: in symmetric shapes, only if some parts of them have the same symmetry.
     */
    bool interact(const Vector<double> &u, const Vector<double> &v) const;

  private:
    /** A flow on the whole surface, at the nodes. */
    struct NodalFlow
    {
      Vector<double>            potential;
      std::vector<Tensor<1, 3>> velocity; ///< of the surface
    };

    /** Derivatives with respect to places and velocities of the nodes. */
    struct NodalGradient
    {
      std::vector<Tensor<1, 3>> place, velocity;
    };

    void                     compute_velocities();
    LAPACKFullMatrix<double> assemble(); // returns -b by node, motion
    void                     solve(LAPACKFullMatrix<double> right_hand_sides);
    void                     integrate();

    /** The nodes whose equations this rank computes: a share of all, or of one half. */
    std::vector<unsigned int> get_own_nodes() const;

    /** What the mirror z -> -z does to a motion; 1 if the surface is not symmetric. */
    double get_mirror_sign(unsigned int motion) const;

    /** The motions of this mirror sign. */
    Vector<double> extract_part(const Vector<double> &motions, double sign) const;

    NodalGradient differentiate_energy(const Vector<double> &u);
    void          differentiate_rule(unsigned int cell, unsigned int rule,
                                     const std::vector<unsigned int> &observers, const NodalFlow &flow,
                                     const Vector<double> &adjoint, NodalGradient &gradient) const;

    const Surface                         &surface;
    const SurfaceMotion                    motion;
    const MPI_Comm                         communicator;
    BoundaryElementCost                   &cost;
    PlacedSurface                          placed;
    std::vector<std::vector<Tensor<1, 3>>> velocities; // u_l by motion, node
    FullMatrix<double>                     fluxes;     // int N_i u_l.n dS by node, motion
    const bool                             is_symmetric;
    std::vector<unsigned int>              images; // of the nodes, or themselves
    LAPACKFullMatrix<double>               matrix; // A, then its factors
    Potentials                             potentials;
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
