#ifndef caudal_mesh_outline_h
#define caudal_mesh_outline_h

#include <deal.II/base/point.h>

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

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
   * NACA's four-digit airfoils with the standard, open trailing edge
   * (Jacobs, Ward and Pinkerton, NACA Report 460, 1933):
   *   h(s) = 5 t (0.2969 sqrt(s) - 0.1260 s - 0.3516 s^2 + 0.2843 s^3 - 0.1015 s^4),
   * so that the tail of a NACA 0012 ends bluntly, 0.252 % of the chord thick.
   * The digits are camber and position of the largest camber (in hundredths
   * and tenths of the chord), and thickness t (in hundredths).
   */
  class NacaOutline : public Outline
  {
  public:
    explicit NacaOutline(const std::string &digits);

    double half_thickness(const double s) const override;
    double camber(const double s) const override;
    double camber_slope(const double s) const override;

  private:
    const double largest_camber;
    const double camber_position;
    const double thickness;
  };

  /**
   * Carling's eel (Carling, Williams and Bowtell 1998; Kern and Koumoutsakos
   * 2006): half width
   *   sqrt(2 w_h s - s^2)                          for s < s_b,
   *   w_h - (w_h - w_t) (s - s_b) / (s_t - s_b)    for s_b <= s < s_t,
   *   w_t (1 - s) / (1 - s_t)                      beyond,
   * w_h = s_b = 0.04, s_t = 0.95, w_t = 0.01. Where the original tail ends in
   * a point, this one tapers to the half width 0.1 w_t, because a quadrilateral
   * can't end in a point: it adds 0.1 % to the area.
   */
  class EelOutline : public Outline
  {
  public:
    double half_thickness(const double s) const override;
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
   * The stations that divide [@p first, 1] into @p n_columns columns, such that
   * each region boundary is a station and the columns are as uniform as that
   * allows (at least one in each region).
   */
  std::vector<double> compute_stations(const double               first,
                                       const std::vector<double> &region_boundaries,
                                       const unsigned int         n_columns);

  /** The number of the region that the station @p s, as a fraction of the length, lies in. */
  unsigned int get_region(const double s, const std::vector<double> &region_boundaries);

  /**
   * A grid of quadrilaterals inside the outline, scaled to @p length [m]: @p
   * n_along times @p n_across cells plus the few of the nose's cap. Every region
   * boundary is a grid line across the body; the material id is the region.
   */
  void make_outline_grid(Triangulation<2> &tria, const Outline &outline, const double length,
                         const std::vector<double> &region_boundaries, const unsigned int n_along,
                         const unsigned int n_across);
} // namespace caudal

#endif
