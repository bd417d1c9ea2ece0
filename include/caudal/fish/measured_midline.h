// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_measured_midline_h
#define caudal_fish_measured_midline_h

#include <deal.II/base/point.h>

#include <functional>
#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /**
   * Midlines of a swimmer at some times, from a table: their inclinations theta(s) [rad] as sums of
   * Legendre polynomials P_k(2 s/L - 1), fitted by least squares. Lengths are in units of the
   * midline's own at that time, so that it has a constant one.
   */
  struct MeasuredMidline
  {
    std::vector<double>              times;        ///< [s]
    std::vector<std::vector<double>> coefficients; ///< by time, from P_0 on
    /** By time, the places s/L of the measured points, and the points over L. */
    std::vector<std::vector<double>>   places;
    std::vector<std::vector<Point<2>>> points;
    /** Shortest and longest of the measured midlines over their mean. */
    double shortest = 1., longest = 1.;
  };

  /**
   * Reads rows of a time [s] and the points x1, y1, x2, y2, ... of the midline, in any unit, from
   * nose to tail; or, if @p has_curvatures, the curvatures [1/m] at equal distances of a midline of
   * length @p length [m]. Throws a sentence if there are too few, or times that do not increase.
   */
  MeasuredMidline read_midline(const std::string &entry, const std::string &file,
                               bool has_curvatures, double length, unsigned int n_modes);

  /** P_k(2 x - 1) minus its value at x = 0, (-1)^k. */
  double compute_inclination_mode(unsigned int k, double x);

  /**
   * The root mean square of the distances of the curve with the inclination theta(s/L) from the
   * measured points of the midline with the number @p k, laid over them by a rigid motion, over L.
   */
  double compute_distance(const MeasuredMidline &midline, std::size_t k,
                          const std::function<double(double)> &theta);
} // namespace caudal

#endif
