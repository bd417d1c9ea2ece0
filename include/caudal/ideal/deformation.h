// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_deformation_h
#define caudal_ideal_deformation_h

#include <caudal/ideal/surface.h>

#include <deal.II/lac/full_matrix.h>

namespace caudal::ideal
{
  /**
   * A body whose shape depends on a few coordinates c_i: joint angles, for example. All
   * vectors are in the body's frame.
   */
  class Deformation
  {
  public:
    virtual ~Deformation() = default;

    virtual unsigned int n_modes() const = 0;

    /** The surface's nodes and their derivatives with respect to c. */
    virtual SurfaceMotion place(const std::vector<double> &c) const = 0;

    /**
     * The body's own mass matrix over its density, for the motions of Potentials: rotations,
     * translations, modes [m^3 to m^5].
     */
    virtual FullMatrix<double> compute_body_mass(const std::vector<double> &c) const = 0;

    /** sum_j rates_j d^2X/(dc_i dc_j) at the surface's nodes, by mode i. */
    virtual std::vector<std::vector<Tensor<1, 3>>>
    compute_mode_rates(const std::vector<double> &c, const std::vector<double> &rates) const = 0;

    /**
     * The derivatives of (1/2) u^T M u, M the body's own mass matrix over its density, with
     * respect to the coordinates c_i for fixed rates u of all motions [m^5].
     */
    virtual std::vector<double>
    compute_body_energy_gradient(const std::vector<double> &c,
                                 const std::vector<double> &u) const = 0;

    /**
     * How near the body is to intersecting itself: the largest of half-width times curvature
     * of the spine, and of the sum of two half-widths over the distance of their places. It has
     * to be less than 1.
     */
    virtual double compute_bend(const std::vector<double> &c) const = 0;

    /** Whether -c is the mirror image of c, y -> -y. */
    virtual bool is_symmetric() const = 0;

    /** [m] */
    virtual double get_length() const = 0;
  };
} // namespace caudal::ideal

#endif
