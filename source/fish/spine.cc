// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/spine.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  Spine::Spine(const Gait &gait, const std::vector<double> &places)
      : gait(gait)
  {
    const double length = gait.get_length(), interval = length / n_intervals;
    for (unsigned int k = 0; k < n_intervals; ++k)
      add_piece(length * k / n_intervals, length * (k + 1) / n_intervals);
    for (const double s : places)
    {
      // The ends of an interval belong to it, not to the next one.
      intervals.push_back(std::clamp<int>(static_cast<int>(std::ceil(s / interval - 1e-9)) - 1, 0,
                                          n_intervals - 1));
      add_piece(intervals.back() * interval, s);
    }
    points.insert(points.end(), places.begin(), places.end());
  }

  void Spine::add_piece(const double begin, const double end)
  {
    const QGauss<1> gauss(n_quadrature_points);
    for (unsigned int q = 0; q < n_quadrature_points; ++q)
    {
      points.push_back(begin + (end - begin) * gauss.point(q)[0]);
      weights.push_back((end - begin) * gauss.weight(q));
    }
  }

  std::vector<SpinePoint> Spine::bend(const std::vector<double> &c,
                                      const std::vector<double> &rates) const
  {
    const SpineAngles  angles    = gait.compute_angles(points, c, rates);
    const unsigned int n         = c.size();
    const bool         has_rates = !rates.empty();

    const auto set_turn = [&](SpinePoint &spine, const unsigned int p) {
      spine.tangent = Point<2>(std::cos(angles.theta[p]), std::sin(angles.theta[p]));
      for (unsigned int i = 0; i < n; ++i)
      {
        spine.turn_by_c[i] = angles.by_c[i][p];
        if (has_rates && !angles.by_c_rate.empty())
          spine.turn_by_c_rate[i] = angles.by_c_rate[i][p];
      }
    };
    // Adds int (T, H_i N, H_i' N - H_i theta' T) ds, with the angles at the end of ds.
    const auto advance = [&](SpinePoint &spine, const double ds) {
      const Tensor<1, 2> normal = spine.get_normal();
      spine.position += ds * spine.tangent;
      double turn = 0.;
      for (unsigned int i = 0; i < rates.size(); ++i)
        turn += rates[i] * spine.turn_by_c[i];
      for (unsigned int i = 0; i < n; ++i)
      {
        spine.position_by_c[i] += ds * spine.turn_by_c[i] * normal;
        if (has_rates)
          spine.position_by_c_rate[i] +=
              ds * (spine.turn_by_c_rate[i] * normal - spine.turn_by_c[i] * turn * spine.tangent);
      }
    };
    const auto integrate = [&](SpinePoint &spine, const unsigned int piece) {
      for (unsigned int q = 0; q < n_quadrature_points; ++q)
      {
        const unsigned int p = piece * n_quadrature_points + q;
        set_turn(spine, p);
        advance(spine, weights[p]);
      }
    };

    SpinePoint nose;
    nose.turn_by_c.resize(n);
    nose.position_by_c.resize(n);
    nose.turn_by_c_rate.resize(has_rates ? n : 0);
    nose.position_by_c_rate.resize(has_rates ? n : 0);
    std::vector<SpinePoint> left_ends(1, nose), result;
    left_ends.reserve(n_intervals);
    result.reserve(intervals.size());
    for (unsigned int k = 1; k < n_intervals; ++k)
    {
      left_ends.push_back(left_ends.back());
      integrate(left_ends.back(), k - 1);
    }
    for (unsigned int p = 0; p < intervals.size(); ++p)
    {
      result.push_back(left_ends[intervals[p]]);
      integrate(result.back(), n_intervals + p);
      set_turn(result.back(), weights.size() + p);
    }
    return result;
  }
} // namespace caudal
