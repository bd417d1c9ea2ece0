// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_outline_h
#define caudal_fish_outline_h

#include <caudal/mesh/shape.h>

namespace caudal
{
  /**
   * The outline of a slender 2D body of unit length with a round nose at the
   * origin, given by its camber line y = c(s), 0 <= s <= 1, and its half
   * thickness h(s) measured along the camber line's normal. All lengths are
   * fractions of the body's length. h(0) = 0, with an infinite slope.
   */
  class Outline
  {
  public:
    virtual ~Outline() = default;

    /** h(s). */
    virtual double half_thickness(const double s) const = 0;

    /** c(s); zero for a symmetric body. */
    virtual double camber(const double s) const;

    /** dc/ds. */
    virtual double camber_slope(const double s) const;

    /** The point (s, c(s)) + eta h(s) n(s); the outline itself is eta = -1 and eta = 1. */
    Point<2> point(const double s, const double eta) const;
  };

  /**
   * The C-shaped grid round an outline's nose: the outermost @p n_layers layers
   * of cells wrap round the front of a core of @p n_core cells. The core's
   * front edge lies at the station @p core, and the diagonals from its two
   * corners meet the outline, under 45 degrees, at the station @p shoulder.
   * So no cell has two edges on the smooth outline, hence none a corner near
   * 180 degrees.
   */
  struct Nose
  {
    Nose(const Outline &outline, const unsigned int n_across);

    unsigned int n_layers;
    unsigned int n_core;
    double       core;
    double       shoulder;
  };

  /**
   * A grid of quadrilaterals inside the outline, scaled to @p length [m]: @p
   * n_along times @p n_across cells plus the few of the nose's cap. Every region
   * boundary is a grid line across the body; the material id is the region.
   */
  void make_outline_grid(Triangulation<2> &tria, const Outline &outline, const double length,
                         const std::vector<double> &region_boundaries, const unsigned int n_along,
                         const unsigned int n_across);
  /** The shapes inside an Outline, which are plane. */
  template <int dim>
  class SlenderShape : public Shape<dim>
  {
  public:
    bool has_grid() const override;

    void check_lengths(const ShapeLengths &lengths, const std::string &path) const override;

    void check_divisions(const ShapeLengths &lengths, const GridDivisions &divisions,
                         const std::string &path) const override;

    void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                   const std::string &path, Triangulation<dim> &tria) const override;

  private:
    virtual std::unique_ptr<Outline> make_outline() const = 0;
  };
} // namespace caudal

#endif
