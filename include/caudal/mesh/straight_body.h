// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_straight_body_h
#define caudal_mesh_straight_body_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace caudal
{
  using namespace dealii;

  /**
   * A slice of a body across its spine, as a rigid piece: what it displaces and the
   * integrals of the products of (1, y, z) over it, y lateral and z dorsal from the spine.
   */
  struct BodySlice
  {
    double                s;       ///< arc length from the nose [m]
    SymmetricTensor<2, 3> moments; ///< int (1,y,z)(1,y,z) dV [m^3, m^4, m^5]
  };

  /**
   * A straight body in three dimensions, by its closed surface: nose at s = 0, tail at
   * s = get_length(). A point of it is (s, y, z), with y lateral and z dorsal [m].
   */
  class StraightBody
  {
  public:
    virtual ~StraightBody() = default;

    virtual double get_length() const = 0;

    /**
     * Where the surface's node with the reference point @p reference is, (s, y, z) [m]: a point
     * of the unit sphere, or of the mesh that the surface comes from.
     */
    virtual Point<3> place(const Point<3> &reference) const = 0;

    /** Half the lateral width at s [m]. */
    virtual double half_width(double s) const = 0;

    /** The volume in slices, for integrals over the body. */
    virtual std::vector<BodySlice> compute_slices() const = 0;

    /** Whether a bend to the left is the mirror image of one to the right. */
    virtual bool is_symmetric() const = 0;
  };
} // namespace caudal

#endif
