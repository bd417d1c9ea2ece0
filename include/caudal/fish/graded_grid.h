// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_graded_grid_h
#define caudal_fish_graded_grid_h

#include <caudal/fish/outline.h>

namespace caudal
{
  /**
   * Makes the grid of a body of unit length inside @p outline with elements about as large as
   * @p size, graded by the body's thickness: one across where it is thin, and an odd number where
   * it is thicker, which changes by two from one column to the next. At the surface they are
   * 0.64 to 1 @p size high wherever the thickness allows it, as the coupling to the fluid asks
   * for. Region boundaries are grid lines across the body; the material ids are the numbers of the
   * regions. The area is that of the outline. Throws a sentence if the first region ends within
   * the grid's nose; @p path is that of section `Shape`.
   */
  void make_graded_grid(const Outline &outline, double size,
                        const std::vector<double> &region_boundaries, const std::string &path,
                        Triangulation<2> &tria);
} // namespace caudal

#endif
