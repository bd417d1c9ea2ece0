// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/prescribed_motion.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** Derivatives of samples with equal distances, of fourth order. */
    std::vector<double> differentiate(const std::vector<double> &values, const double spacing)
    {
      const std::size_t   n = values.size();
      std::vector<double> result(n);
      const auto          one_sided = [&](const auto &value) {
        return (-25. * value(0) + 48. * value(1) - 36. * value(2) + 16. * value(3) -
                3. * value(4)) /
               (12. * spacing);
      };
      const auto skewed = [&](const auto &value) {
        return (-3. * value(0) - 10. * value(1) + 18. * value(2) - 6. * value(3) + value(4)) /
               (12. * spacing);
      };
      const auto from_front = [&](const std::size_t i) { return values[i]; };
      const auto from_back  = [&](const std::size_t i) { return values[n - 1 - i]; };
      result[0]             = one_sided(from_front);
      result[1]             = skewed(from_front);
      result[n - 1]         = -one_sided(from_back);
      result[n - 2]         = -skewed(from_back);
      for (std::size_t i = 2; i + 2 < n; ++i)
        result[i] = (values[i - 2] - 8. * values[i - 1] + 8. * values[i + 1] - values[i + 2]) /
                    (12. * spacing);
      return result;
    }

    /** A cubic Hermite polynomial between the ends of a piece, and its slope. */
    template <class Value>
    std::pair<Value, Value> interpolate(const std::vector<Value> &values,
                                        const std::vector<Value> &slopes, const double spacing,
                                        const unsigned int piece, const double x)
    {
      const double y = 1. - x;
      return {y * y * (1. + 2. * x) * values[piece] + x * x * (1. + 2. * y) * values[piece + 1] +
                  spacing * x * y * (y * slopes[piece] - x * slopes[piece + 1]),
              6. * x * y / spacing * (values[piece + 1] - values[piece]) +
                  y * (y - 2. * x) * slopes[piece] + x * (x - 2. * y) * slopes[piece + 1]};
    }

    /** The spine at the ends of equal pieces. */
    struct Midline
    {
      Midline(const Gait &gait, double time);

      static constexpr unsigned int n_pieces = 400;

      double                    spacing; // [m]
      std::vector<double>       theta, curvature, theta_rate, curvature_rate;
      std::vector<Tensor<1, 2>> place, tangent, velocity, tangent_rate;
    };

    Tensor<1, 2> turn_left(const Tensor<1, 2> &v)
    {
      return Point<2>(-v[1], v[0]);
    }

    Midline::Midline(const Gait &gait, const double time)
        : spacing(gait.get_length() / n_pieces)
        , theta_rate(n_pieces + 1, 0.)
        , place(1)
        , velocity(1)
    {
      std::vector<double> ends;
      for (unsigned int i = 0; i <= n_pieces; ++i)
        ends.push_back(gait.get_length() * i / n_pieces);
      const double      rate   = gait.get_argument_rate(gait.get_frequencies()[0]);
      const GaitState   state  = gait.evaluate(rate * time);
      const SpineAngles angles = gait.compute_angles(ends, state.c);

      theta = angles.theta;
      for (unsigned int i = 0; i <= n_pieces; ++i)
        for (unsigned int k = 0; k < state.c.size(); ++k)
          theta_rate[i] += rate * state.rates[k] * angles.by_c[k][i];
      curvature      = differentiate(theta, spacing);
      curvature_rate = differentiate(theta_rate, spacing);
      std::vector<Tensor<1, 2>> bend, bend_rate; // d/ds of the tangent and of its rate
      for (unsigned int i = 0; i <= n_pieces; ++i)
      {
        tangent.push_back(Point<2>(std::cos(theta[i]), std::sin(theta[i])));
        const Tensor<1, 2> normal = turn_left(tangent[i]);
        tangent_rate.push_back(theta_rate[i] * normal);
        bend.push_back(curvature[i] * normal);
        bend_rate.push_back(curvature_rate[i] * normal - curvature[i] * theta_rate[i] * tangent[i]);
      }
      const auto integrate = [&](const auto &slopes, const auto &changes, auto &values) {
        for (unsigned int i = 1; i <= n_pieces; ++i)
          values.push_back(values[i - 1] + 0.5 * spacing * (slopes[i - 1] + slopes[i]) +
                           spacing * spacing / 12. * (changes[i - 1] - changes[i]));
      };
      integrate(tangent, bend, place);
      integrate(tangent_rate, bend_rate, velocity);
    }

    /** The piece of the spine in which s lies, and where in it, from 0 to 1. */
    std::pair<unsigned int, double> find_piece(const Midline &spine, const double s)
    {
      const auto piece =
          std::min(static_cast<unsigned int>(s / spine.spacing), Midline::n_pieces - 1);
      return {piece, s / spine.spacing - piece};
    }

    /** n of PrescribedMotion and its derivative by the curvature. */
    std::pair<double, double> bend_section(const double eta, const double right, const double left,
                                           const double kappa)
    {
      const double h_squared = 0.5 * (right * right + left * left);
      const double root      = 1. - 2. * kappa * eta + kappa * kappa * h_squared;
      AssertThrow(1. - kappa * left > 0. && 1. - kappa * right > 0. && root > 0.,
                  ExcMessage("Gait: the spine bends to a radius of " +
                             std::to_string(1. / std::abs(kappa)) +
                             " m, and the body is as wide there: its sections would meet. Bend it "
                             "less."));
      const double n = (2. * eta - kappa * h_squared) / (1. + std::sqrt(root));
      return {n, (n * n - h_squared) / (2. * (1. - kappa * n))};
    }
  } // namespace

  std::vector<GaitPoint> compute_gait_points(const Gait &gait, const std::vector<double> &s,
                                             const double time)
  {
    const Midline          spine(gait, time);
    std::vector<GaitPoint> points;
    for (const double place : s)
    {
      const auto [piece, x] = find_piece(spine, place);
      points.push_back(
          {Point<2>(interpolate(spine.place, spine.tangent, spine.spacing, piece, x).first),
           interpolate(spine.theta_rate, spine.curvature_rate, spine.spacing, piece, x).first});
    }
    return points;
  }

  template <int dim>
  PrescribedMotion<dim>::PrescribedMotion(const Gait                        &gait,
                                          const std::vector<BodyPoint<dim>> &points)
      : gait(gait)
      , points(points)
  {
    const std::size_t n = gait.get_frequencies().size();
    AssertThrow(n == 1, ExcMessage("Gait/Frequency: there are " + std::to_string(n) +
                                   " values. Give one: only in an ideal fluid several are "
                                   "simulated one after the other."));
  }

  template <int dim>
  typename PrescribedMotion<dim>::State
  PrescribedMotion<dim>::compute_shifted(const double time) const
  {
    std::vector<double> places;
    for (const auto &point : points)
      places.push_back(point.place[0]);
    const double rate   = gait.get_argument_rate(gait.get_frequencies()[0]);
    const auto   shifts = gait.compute_shifts(places, rate * time);
    State        motion;
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      motion.positions.push_back(points[p].place);
      motion.positions.back()[1] += shifts[p].value;
      motion.velocities.push_back(rate * shifts[p].rate * Point<dim>::unit_vector(1));
    }
    return motion;
  }

  template <int dim>
  typename PrescribedMotion<dim>::State PrescribedMotion<dim>::compute(const double time) const
  {
    Assert(time <= gait.get_end() * (1. + 1e-9), ExcMessage("The gait's table has ended."));
    if (gait.shifts_sections())
      return compute_shifted(time);
    const Midline spine(gait, time);
    State         motion;
    for (const auto &[point, right, left] : points)
    {
      const double inside   = std::clamp(point[0], 0., gait.get_length());
      const double beyond   = point[0] - inside;
      const auto [piece, x] = find_piece(spine, inside);
      const auto at_point   = [&, piece = piece, x = x](const auto &values, const auto &slopes) {
        return interpolate(values, slopes, spine.spacing, piece, x);
      };
      auto [theta, kappa]           = at_point(spine.theta, spine.curvature);
      auto [theta_rate, kappa_rate] = at_point(spine.theta_rate, spine.curvature_rate);
      if (beyond != 0.)
        kappa = kappa_rate = 0.;
      const Tensor<1, 2> T = Point<2>(std::cos(theta), std::sin(theta)), N = turn_left(T);
      const auto [n, n_by_kappa] = bend_section(point[1], right, left, kappa);
      const Tensor<1, 2> X       = at_point(spine.place, spine.tangent).first + n * N + beyond * T;
      const Tensor<1, 2> V       = at_point(spine.velocity, spine.tangent_rate).first +
                             (n_by_kappa * kappa_rate + theta_rate * beyond) * N -
                             theta_rate * n * T;
      motion.positions.push_back(point);
      motion.velocities.emplace_back();
      for (unsigned int d = 0; d < 2; ++d)
      {
        motion.positions.back()[d]  = X[d];
        motion.velocities.back()[d] = V[d];
      }
    }
    return motion;
  }

  template class PrescribedMotion<2>;
  template class PrescribedMotion<3>;
} // namespace caudal
