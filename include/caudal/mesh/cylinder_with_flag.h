#ifndef caudal_mesh_cylinder_with_flag_h
#define caudal_mesh_cylinder_with_flag_h

#include <deal.II/grid/tria.h>

namespace caudal
{
  using namespace dealii;

  /** Splits each cell of the curved @p coarse into @p n straight-sided ones in each direction. */
  template <int dim>
  void subdivide(const Triangulation<dim> &coarse, unsigned int n, Triangulation<dim> &tria);

  /**
   * The body of Turek and Hron's benchmark (2006, doi:10.1007/3-540-34596-5_15):
   * a cylinder round the origin with a flag that ends at x = @p radius + @p length
   * and is @p thickness thick [m]. The flag has @p n_along times @p n_across
   * cells; it goes on through the cylinder as a strip of as many layers, on
   * which the rest of the cylinder rests as two segments. Material ids: 0 in
   * the cylinder, 1 in the flag.
   */
  void make_cylinder_with_flag(Triangulation<2> &tria, double radius, double length,
                               double thickness, unsigned int n_along, unsigned int n_across);
} // namespace caudal

#endif
