// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_outline_h
#define caudal_fish_outline_h

#include <caudal/mesh/shape.h>

#include <boost/math/tools/roots.hpp>

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
    virtual double half_thickness(double s) const = 0;

    /** c(s); zero for a symmetric body. */
    virtual double camber(double /*s*/) const
    {
      return 0.;
    }

    /** dc/ds. */
    virtual double camber_slope(double /*s*/) const
    {
      return 0.;
    }

    /** The point (s, c(s)) + eta h(s) n(s); the outline itself is eta = -1 and eta = 1. */
    Point<2> point(double s, double eta) const;
  };

  /** The zero of a function between @p a and @p b, where it has different signs. */
  template <class Function>
  double find_zero(const Function &f, const double a, const double b)
  {
    const auto [low, high] = boost::math::tools::bisect(
        f, a, b, [](const double x, const double y) { return y - x <= 1e-14; });
    return 0.5 * (low + high);
  }

  /** Throws if the first region ends within the nose of a grid, which ends at @p nose_end. */
  void check_first_region(const std::string &path, double nose_end,
                          const std::vector<double> &region_boundaries);

  /** The point at the share @p fraction of the way from @p a to @p b. */
  inline Point<2> interpolate(const Point<2> &a, const Point<2> &b, const double fraction)
  {
    return a + fraction * (b - a);
  }

  /**
   * The shapes inside an Outline, which are plane. Their grids are n_along times n_across
   * quadrilaterals plus the few of the nose's cap; region boundaries are grid lines across the
   * body.
   */
  template <int dim>
  class SlenderShape : public Shape<dim>
  {
  public:
    bool has_grid() const override
    {
      return dim == 2;
    }

    void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
    {
      require_positive(lengths.length, path, "Length");
    }

    void check_divisions(const ShapeLengths &lengths, const GridDivisions &divisions,
                         const std::string &path) const override;

    void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                   const std::string &path, Triangulation<dim> &tria) const override;

  private:
    virtual std::unique_ptr<Outline> make_outline() const = 0;
  };
} // namespace caudal

#endif
