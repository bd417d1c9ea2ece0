// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_cubed_ball_h
#define caudal_fish_cubed_ball_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace caudal
{
  using namespace dealii;

  /** Numbers of elements of make_cubed_ball(). */
  struct CubedBallDivisions
  {
    std::vector<unsigned int> core; ///< of the core in each direction

    unsigned int n_layers = 1; ///< round it
    unsigned int n_tail   = 0; ///< columns behind it and its layers
  };

  /**
   * The unit disc or ball as an image of a cube: a core of elements, from whose faces layers of
   * elements reach to the circle or sphere. Its columns along the first axis are normal to it,
   * but for the layers at the two ends, so that it can be stretched to a slender body.
   *
   * With a tail the layers end before the ball does: from the face of the layer behind the core
   * on, as many elements as the core has fill whole sections. Where the layers end, three elements
   * meet in a point of the surface, so that none has a corner near 180 degrees.
   *
   * The corners of the core's sections, and where they are seen on the circle, lie at angles
   * between 45 degrees and those of equal edges on the circle, which are those of the tail's.
   */
  template <int dim>
  void make_cubed_ball(Triangulation<dim> &tria, const CubedBallDivisions &divisions);
} // namespace caudal

#endif
