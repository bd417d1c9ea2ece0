#ifndef caudal_ideal_surface_fields_h
#define caudal_ideal_surface_fields_h

#include <caudal/ideal/surface.h>

#include <deal.II/lac/vector.h>

namespace caudal::ideal
{
  /** The flow on the surface, at its nodes; vectors in the frame of the positions. */
  struct SurfaceFields
  {
    Vector<double>            pressure; ///< p - p_infinity [Pa]
    std::vector<Tensor<1, 3>> velocity; ///< of the fluid, grad phi [m/s]
  };

  /**
   * The pressure by Bernoulli's equation with the rate of change that a node sees as it moves,
   *   p = -rho (delta phi/delta t - u.grad phi + |grad phi|^2/2),
   * grad phi being composed of its tangential part, by differentiation along the surface and
   * averaged over the cells that meet in a node, and of the given normal part u.n.
   */
  SurfaceFields compute_surface_fields(const Surface &surface, const std::vector<Point<3>> &nodes,
                                       const std::vector<Tensor<1, 3>> &node_velocities,
                                       const Vector<double>            &potential,
                                       const Vector<double> &potential_rate, double density);
} // namespace caudal::ideal

#endif
