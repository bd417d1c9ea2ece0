// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_surface_layer_h
#define caudal_mesh_surface_layer_h

#include <deal.II/base/quadrature.h>

#include <array>

namespace caudal
{
  using namespace dealii;

  /**
   * Gauss points on the face @p face of the unit cell, @p n_points[d] of them in the direction d
   * (the number in the face's normal direction is of no concern). Their weights make
   *   sum_r f(s_r) JxW_r = int_face f h dS,  h = det(J) / |dS/dxi|,
   * h being the height of the cell at the face, so that a cell's faces count like a layer of it.
   */
  template <int dim>
  Quadrature<dim> make_surface_quadrature(unsigned int                         face,
                                          const std::array<unsigned int, dim> &n_points);

  /** Gauss points of the unit cell, @p n_points[d] of them in the direction d. */
  template <int dim>
  Quadrature<dim> make_volume_quadrature(const std::array<unsigned int, dim> &n_points);
} // namespace caudal

#endif
