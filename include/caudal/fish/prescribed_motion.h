// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_prescribed_motion_h
#define caudal_fish_prescribed_motion_h

#include <caudal/fish/gait.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace caudal
{
  /**
   * The motion that a gait prescribes to points of the body, up to a rigid one: the body finds
   * its own place and direction from the balance of its momenta. Sections stay straight and
   * normal to the spine m, X = m(s,t) + y N(s,t), so that a symmetric body keeps its area; beyond
   * its ends the spine goes on straight.
   *
   * The spine in 400 equal pieces: dm/ds = T = (cos theta, sin theta) integrated from the nose on
   * by the trapezoidal rule; between their ends cubic Hermite interpolation of m, linear of theta.
   * Velocities are the exact time derivatives of the places of these ends.
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

    /**
     * @p points s of the reference shape [m] in the body frame: origin at the nose, x towards
     * the tail, y lateral. The gait has to outlive the object.
     */
    PrescribedMotion(const Gait &gait, const std::vector<Point<dim>> &points);

    /** In the body frame at @p time [s]. */
    State compute(double time) const;

  private:
    const Gait                   &gait;
    const std::vector<Point<dim>> points;
  };
} // namespace caudal

#endif
