// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/least_squares.h>
#include <caudal/fish/measured_midline.h>
#include <caudal/fish/number_table.h>

#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

namespace caudal
{
  namespace
  {
    /** Legendre polynomials through values at some places between 0 and 1, by least squares. */
    std::vector<double> fit(const std::vector<double> &places, const std::vector<double> &values,
                            const unsigned int n_modes)
    {
      const auto coefficients =
          fit_least_squares(places, values, n_modes + 1, [](const double x, const unsigned int k) {
            return boost::math::legendre_p(static_cast<int>(k), 2. * x - 1.);
          });
      return {coefficients.begin(), coefficients.end()};
    }

    /** Adds a midline by its points; angles go on from that of the midline before. */
    void add_points(const std::vector<double> &row, const std::string &place,
                    const unsigned int n_modes, double &last_angle, std::vector<double> &lengths,
                    MeasuredMidline &midline)
    {
      std::vector<Point<2>> points;
      for (std::size_t i = 1; i + 1 < row.size(); i += 2)
        points.emplace_back(row[i], row[i + 1]);
      std::vector<double> arcs(1, 0.), middles, angles;
      double              angle = last_angle;
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        const Tensor<1, 2> piece = points[i] - points[i - 1];
        AssertThrow(piece.norm() > 0.,
                    ExcMessage(place + "the points " + std::to_string(i) + " and " +
                               std::to_string(i + 1) + " are the same. Give different ones."));
        arcs.push_back(arcs.back() + piece.norm());
        middles.push_back(0.5 * (arcs[i - 1] + arcs[i]));
        angle += std::remainder(std::atan2(piece[1], piece[0]) - angle, 2. * numbers::PI);
        if (i == 1)
          last_angle = angle;
        angles.push_back(angle);
      }
      const double length = arcs.back();
      for (double &x : middles)
        x /= length;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        arcs[i] /= length;
        points[i] /= length;
      }
      midline.coefficients.push_back(fit(middles, angles, n_modes));
      midline.places.push_back(arcs);
      midline.points.push_back(points);
      lengths.push_back(length);
    }

    /** Adds a midline by its curvatures at equal distances [1/m]. */
    void add_curvatures(const std::vector<double> &row, const double length,
                        const unsigned int n_modes, MeasuredMidline &midline)
    {
      const std::size_t     n = row.size() - 1;
      std::vector<double>   places(1, 0.), angles(1, 0.);
      std::vector<Point<2>> points(1);
      for (std::size_t i = 1; i < n; ++i)
      {
        const double step = 1. / (n - 1);
        places.push_back(step * i);
        angles.push_back(angles.back() + 0.5 * step * length * (row[i] + row[i + 1]));
        const double middle = 0.5 * (angles[i - 1] + angles[i]);
        points.push_back(points.back() + step * Point<2>(std::cos(middle), std::sin(middle)));
      }
      midline.coefficients.push_back(fit(places, angles, n_modes));
      midline.places.push_back(places);
      midline.points.push_back(points);
    }
  } // namespace

  double compute_inclination_mode(const unsigned int k, const double x)
  {
    return boost::math::legendre_p(static_cast<int>(k), 2. * std::clamp(x, 0., 1.) - 1.) -
           (k % 2 == 0 ? 1. : -1.);
  }

  MeasuredMidline read_midline(const std::string &entry, const std::string &file,
                               const bool has_curvatures, const double length,
                               const unsigned int n_modes)
  {
    const NumberTable table     = read_number_table(entry, file, 0);
    const std::string place     = entry + ": " + file + ": ";
    const std::size_t n_columns = table.rows.empty() ? 0 : table.rows[0].values.size();
    const std::size_t n_points  = has_curvatures ? n_columns - 1 : (n_columns - 1) / 2;
    AssertThrow(table.rows.size() >= 4,
                ExcMessage(place + "there are " + std::to_string(table.rows.size()) +
                           " midlines. Give at least four."));
    AssertThrow(has_curvatures || n_columns % 2 == 1,
                ExcMessage(place + "a row has " + std::to_string(n_columns) +
                           " numbers. Give a time and pairs of coordinates."));
    AssertThrow(n_points >= n_modes + 2,
                ExcMessage(place + "a midline has " + std::to_string(n_points) +
                           " places, which are too few for Modes = " + std::to_string(n_modes) +
                           ". Give more of them, or fewer modes."));
    MeasuredMidline     midline;
    std::vector<double> lengths;
    double              last_angle = 0.;
    for (const auto &row : table.rows)
    {
      AssertThrow(row.values.size() == n_columns,
                  ExcMessage(row.place + "there are " + std::to_string(row.values.size()) +
                             " numbers, and " + std::to_string(n_columns) +
                             " in the first row. Give as many in each."));
      AssertThrow(midline.times.empty() || row.values[0] > midline.times.back(),
                  ExcMessage(row.place + "its time is not later than that of the row before. Sort "
                                         "the rows by time."));
      midline.times.push_back(row.values[0]);
      if (has_curvatures)
        add_curvatures(row.values, length, n_modes, midline);
      else
        add_points(row.values, row.place, n_modes, last_angle, lengths, midline);
    }
    if (!has_curvatures)
    {
      double mean = 0.;
      for (const double value : lengths)
        mean += value / lengths.size();
      const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
      midline.shortest         = *least / mean;
      midline.longest          = *most / mean;
    }
    return midline;
  }

  double compute_distance(const MeasuredMidline &midline, const std::size_t k,
                          const std::function<double(double)> &theta)
  {
    using Complex           = std::complex<double>; // x + i y
    const auto &places      = midline.places[k];
    const auto  to_complex  = [](const Point<2> &point) { return Complex(point[0], point[1]); };
    const int   n_per_piece = 20;

    std::vector<Complex> curve(1), points(1, to_complex(midline.points[k][0]));
    for (std::size_t j = 1; j < places.size(); ++j)
    {
      const double step  = (places[j] - places[j - 1]) / n_per_piece;
      Complex      place = curve.back();
      for (int i = 0; i < n_per_piece; ++i)
        place += step * std::polar(1., theta(places[j - 1] + (i + 0.5) * step));
      curve.push_back(place);
      points.push_back(to_complex(midline.points[k][j]));
    }
    const double n = places.size();
    Complex      curve_mean, point_mean, turn;
    for (std::size_t j = 0; j < places.size(); ++j)
    {
      curve_mean += curve[j] / n;
      point_mean += points[j] / n;
    }
    for (std::size_t j = 0; j < places.size(); ++j)
      turn += std::conj(curve[j] - curve_mean) * (points[j] - point_mean);
    turn /= std::abs(turn);
    double squares = 0.;
    for (std::size_t j = 0; j < places.size(); ++j)
      squares += std::norm(points[j] - point_mean - turn * (curve[j] - curve_mean)) / n;
    return std::sqrt(squares);
  }
} // namespace caudal
