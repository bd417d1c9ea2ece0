// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_rigid_motion_h
#define caudal_solid_rigid_motion_h

#include <caudal/solid/rigid_map.h>
#include <caudal/solid/solid_body.h>

namespace caudal
{
  /** Some nodes of a body. */
  template <int dim>
  using Nodes = std::vector<typename SolidBody<dim>::Node>;

  /**
   * The rigid motion that maps the nodal field @p reference on @p x best: in
   * the mean square over @p nodes, weighted by their volumes (Kabsch 1976,
   * doi:10.1107/S0567739476001873).
   */
  template <int dim>
  RigidMotion<dim> fit_rigid_motion(const SolidBody<dim> &body, const Nodes<dim> &nodes,
                                    const Vector<double> &reference, const Vector<double> &x);

  /** The velocity v = mean + spin (x - center) of a rigid motion; spin is skew-symmetric. */
  template <int dim>
  struct RigidVelocity
  {
    Tensor<1, dim> mean, center;
    Tensor<2, dim> spin;
  };

  /** The rigid velocity that is closest to the nodal field @p v at the nodal positions @p x. */
  template <int dim>
  RigidVelocity<dim> fit_rigid_velocity(const SolidBody<dim> &body, const Nodes<dim> &nodes,
                                        const Vector<double> &x, const Vector<double> &v);

  /** Nodal fields that span the rigid velocities at the nodal positions @p x: dim (dim+1)/2. */
  template <int dim>
  std::vector<Vector<double>> make_rigid_velocities(const SolidBody<dim> &body,
                                                    const Vector<double> &x);
} // namespace caudal

#endif
