// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_prescribed_motion_h
#define caudal_fish_prescribed_motion_h

#include <caudal/fish/gait.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace caudal
{
  /** A point m(s) of a gait's spine in the body's frame [m], and the rate of theta there [rad/s].
   */
  struct GaitPoint
  {
    Point<2> place;
    double   turning_rate;
  };

  /** The spine at the places @p s between 0 and the gait's length [m], at @p time [s]. */
  std::vector<GaitPoint> compute_gait_points(const Gait &gait, const std::vector<double> &s,
                                             double time);

  /** A point of the reference shape in the body's frame, and the section that it lies in. */
  template <int dim>
  struct BodyPoint
  {
    Point<dim> place; ///< origin at the nose, x along the spine, y lateral [m]
    double     right; ///< where the line along y through it enters the body [m]
    double     left;  ///< and where it leaves it [m]
  };

  /**
   * The motion that a gait prescribes to points of the body, up to a rigid one: the body finds
   * its own place and direction from the balance of its momenta. A section goes along the normal
   * N of the spine m, X = m(s,t) + n N(s,t), with
   *   n - kappa n^2/2 = eta - kappa h^2/2,   h^2 = (eta_left^2 + eta_right^2)/2,
   * eta the lateral coordinate at rest and kappa the curvature: that is
   *   n = (2 eta - kappa h^2)/(1 + sqrt(1 - 2 kappa eta + kappa^2 h^2)).
   * So det(dX/ds) = (1 - kappa n) dn/deta = 1 everywhere, as an incompressible body needs it, and
   * sections with eta_left = -eta_right = h keep their ends. dn/dkappa = (n^2 - h^2)/(2 (1 -
   * kappa n)) gives dX/dt = dm/dt + dn/dkappa kappa_t N - n theta_t T. Beyond its ends the spine
   * goes on straight.
   *
   * The spine in 400 equal pieces: dm/ds = T = (cos theta, sin theta) integrated from the nose on
   * by the trapezoidal rule with its correction by derivatives; between their ends cubic Hermite
   * interpolation of m and theta. Where the gait shifts sections, they are shifted instead.
   */
  template <int dim>
  class PrescribedMotion
  {
  public:
    struct State
    {
      std::vector<Point<dim>>     positions;  ///< X(s) [m]
      std::vector<Tensor<1, dim>> velocities; ///< dX/dt(s) [m/s]
    };

    /** The gait has to outlive the object. */
    PrescribedMotion(const Gait &gait, const std::vector<BodyPoint<dim>> &points);

    /**
     * In the body frame at @p time [s]. Throws a sentence where a section reaches the centre of
     * curvature.
     */
    State compute(double time) const;

  private:
    const Gait                       &gait;
    const std::vector<BodyPoint<dim>> points;

    State compute_shifted(double time) const;
  };
} // namespace caudal

#endif
