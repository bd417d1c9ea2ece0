// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_round_grids_h
#define caudal_mesh_round_grids_h

#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

namespace caudal
{
  using namespace dealii;

  /** Splits each cell of the curved @p coarse into @p n straight-sided ones in each direction. */
  template <int dim>
  void subdivide(const Triangulation<dim> &coarse, unsigned int n, Triangulation<dim> &tria);

  /**
   * The ellipse or ellipsoid round the origin with these semi-axes, of about @p n_cells cells:
   * 12 m^2 (2D) or 32 m^3 (3D).
   */
  template <int dim>
  void make_ellipsoid(Triangulation<dim> &tria, const Tensor<1, dim> &semi_axes, double n_cells);
} // namespace caudal

#endif
