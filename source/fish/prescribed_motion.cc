// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/prescribed_motion.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** The spine at the ends of equal pieces. */
    struct Midline
    {
      Midline(const Gait &gait, double time);

      static constexpr unsigned int n_pieces = 400;

      double                    spacing; // [m]
      std::vector<double>       theta, theta_rate;
      std::vector<Tensor<1, 2>> place, tangent, velocity, tangent_rate;

      /** Within a piece, at the share @p x of its length. */
      static double interpolate(const std::vector<double> &values, const unsigned int piece,
                                const double x)
      {
        return (1. - x) * values[piece] + x * values[piece + 1];
      }

      Tensor<1, 2> interpolate(const std::vector<Tensor<1, 2>> &values,
                               const std::vector<Tensor<1, 2>> &slopes, const unsigned int piece,
                               const double x) const
      {
        const double y = 1. - x;
        return y * y * (1. + 2. * x) * values[piece] + x * x * (1. + 2. * y) * values[piece + 1] +
               spacing * x * y * (y * slopes[piece] - x * slopes[piece + 1]);
      }
    };

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
      {
        for (unsigned int k = 0; k < state.c.size(); ++k)
          theta_rate[i] += rate * state.rates[k] * angles.by_c[k][i];
        tangent.push_back(Point<2>(std::cos(theta[i]), std::sin(theta[i])));
        tangent_rate.push_back(theta_rate[i] * Point<2>(-tangent[i][1], tangent[i][0]));
        if (i > 0)
        {
          place.push_back(place[i - 1] + 0.5 * spacing * (tangent[i - 1] + tangent[i]));
          velocity.push_back(velocity[i - 1] +
                             0.5 * spacing * (tangent_rate[i - 1] + tangent_rate[i]));
        }
      }
    }
  } // namespace

  template <int dim>
  PrescribedMotion<dim>::PrescribedMotion(const Gait &gait, const std::vector<Point<dim>> &points)
      : gait(gait)
      , points(points)
  {
    const std::size_t n = gait.get_frequencies().size();
    AssertThrow(n == 1, ExcMessage("Gait/Frequency: there are " + std::to_string(n) +
                                   " values. Give one: only in an ideal fluid several are "
                                   "simulated one after the other."));
  }

  template <int dim>
  typename PrescribedMotion<dim>::State PrescribedMotion<dim>::compute(const double time) const
  {
    Assert(time <= gait.get_end() * (1. + 1e-9), ExcMessage("The gait's table has ended."));
    const Midline spine(gait, time);
    State         motion{points, std::vector<Tensor<1, dim>>(points.size())};
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      const double inside = std::clamp(points[p][0], 0., gait.get_length());
      const double beyond = points[p][0] - inside, y = points[p][1];
      const auto   piece =
          std::min(static_cast<unsigned int>(inside / spine.spacing), Midline::n_pieces - 1);
      const double       x     = inside / spine.spacing - piece;
      const double       angle = Midline::interpolate(spine.theta, piece, x);
      const double       rate  = Midline::interpolate(spine.theta_rate, piece, x);
      const Tensor<1, 2> T     = Point<2>(std::cos(angle), std::sin(angle));
      const Tensor<1, 2> N     = Point<2>(-T[1], T[0]);
      const Tensor<1, 2> X =
          spine.interpolate(spine.place, spine.tangent, piece, x) + y * N + beyond * T;
      const Tensor<1, 2> V = spine.interpolate(spine.velocity, spine.tangent_rate, piece, x) +
                             rate * (beyond * N - y * T);
      for (unsigned int d = 0; d < 2; ++d)
      {
        motion.positions[p][d]  = X[d];
        motion.velocities[p][d] = V[d];
      }
    }
    return motion;
  }

  template class PrescribedMotion<2>;
  template class PrescribedMotion<3>;
} // namespace caudal
