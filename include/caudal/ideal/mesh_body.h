// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_mesh_body_h
#define caudal_ideal_mesh_body_h

#include <caudal/ideal/surface.h>
#include <caudal/mesh/straight_body.h>

namespace caudal::ideal
{
  /** The body inside a surface mesh. */
  class MeshBody : public StraightBody
  {
  public:
    explicit MeshBody(const Surface &surface);

    double get_length() const override
    {
      return tail - nose;
    }

    Point<3> place(const Point<3> &reference) const override
    {
      return Point<3>(reference[0] - nose, reference[1], reference[2]);
    }

    /** The largest |y| within a twentieth of the length. */
    double half_width(double s) const override;

    /** By int f dV = int F n_y dS with dF/dy = f, here f = 1, y, z, y^2, yz, z^2. */
    std::vector<BodySlice> compute_slices() const override;

    bool is_symmetric() const override
    {
      return false; // not known
    }

  private:
    const Surface &surface;
    double         nose, tail; // x [m]
  };
} // namespace caudal::ideal

#endif
