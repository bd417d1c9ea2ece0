// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_elliptic_body_h
#define caudal_fish_elliptic_body_h

#include <caudal/mesh/shape.h>

#include <utility>

namespace caudal
{
  /**
   * A body of elliptic sections across its spine, with round ends: their half-axes are
   *   a(s) = g_a(s) E(s), b(s) = g_b(s) E(s), E = 2 sqrt(s (L - s))/L,
   * so that it is the image of the unit ball: s = L (1 + X_1)/2, y = g_a X_2, z = g_b X_3, with
   * the Jacobian L g_a g_b/2.
   */
  class EllipticBody : public StraightBody
  {
  public:
    explicit EllipticBody(double length);

    double get_length() const override
    {
      return length;
    }

    bool is_symmetric() const override
    {
      return true;
    }

    Point<3>               place(const Point<3> &reference) const override;
    double                 half_width(double s) const override;
    std::vector<BodySlice> compute_slices() const override;

    /** E(s) */
    static double get_end_factor(double s, double length);

  private:
    /** g_a and g_b at s [m]. */
    virtual std::pair<double, double> get_scales(double s) const = 0;

    const double length;
  };

  /**
   * The shapes that an EllipticBody describes: its surface, the grid inside (3D), and that of the
   * section z = 0 (2D).
   */
  template <int dim>
  class EllipticShape : public Shape<dim>
  {
  public:
    bool has_surface() const override
    {
      return true;
    }

    void check_divisions(const ShapeLengths &lengths, const GridDivisions &divisions,
                         const std::string &path) const override;

    /**
     * Elements along the body are those between its round ends, elements across are those of a
     * section: a core and m layers round it, a fifth of them on each side. In 3D the core has
     * n_x x n_y x n_z elements, each flank n_x x n_y x m or n_x x n_z x m, each end
     * n_y x n_z x m. Nose, length and volume (2D: area) are those of the body.
     *
     * Automatic elements suit a thin tail, too. In 2D they are graded by the body's thickness
     * (make_graded_grid()). In 3D the core is as many elements across as the tail needs, and goes
     * on without layers where that many fill the body (make_cubed_ball()).
     */
    void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                   const std::string &path, Triangulation<dim> &tria) const override;
  };
} // namespace caudal

#endif
