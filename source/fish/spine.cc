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
    for (const double place : places)
    {
      const double s = std::clamp(place, 0., length);
      // The ends of an interval belong to it, not to the next one.
      intervals.push_back(std::clamp<int>(static_cast<int>(std::ceil(s / interval - 1e-9)) - 1, 0,
                                          n_intervals - 1));
      add_piece(intervals.back() * interval, s);
      beyond.push_back(place - s);
    }
    for (unsigned int p = 0; p < places.size(); ++p)
      points.push_back(places[p] - beyond[p]);
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
      advance(result.back(), beyond[p]);
    }
    return result;
  }

  namespace
  {
    template <int dim>
    std::vector<double> get_arc_lengths(const std::vector<Point<dim>> &points)
    {
      std::vector<double> s;
      for (const Point<dim> &point : points)
        s.push_back(point[0]);
      return s;
    }
  } // namespace

  template <int dim>
  PrescribedMotion<dim>::PrescribedMotion(const Gait &gait, const std::vector<Point<dim>> &points)
      : gait(gait)
      , points(points)
      , spine(gait, get_arc_lengths(points))
  {
    const std::size_t n = gait.get_frequencies().size();
    AssertThrow(n == 1, ExcMessage("Gait/Frequency: there are " + std::to_string(n) +
                                   " values. Give one: only in an ideal fluid several are "
                                   "simulated one after the other."));
  }

  template <int dim>
  typename PrescribedMotion<dim>::State PrescribedMotion<dim>::compute(const double time) const
  {
    AssertThrow(time <= gait.get_end() * (1. + 1e-9),
                ExcMessage("Gait: its table ends after " + std::to_string(gait.get_end()) +
                           " s, before the time " + std::to_string(time) +
                           " s. Lengthen the table, shorten the run, or set "
                           "Gait/Table/Periodic."));
    const double rate  = gait.get_argument_rate(gait.get_frequencies()[0]);
    GaitState    state = gait.evaluate(rate * time);
    State        motion;
    const auto   bent = spine.bend(state.c);
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      const double y        = points[p][1];
      Tensor<1, 2> position = bent[p].position + y * bent[p].get_normal(), velocity;
      for (std::size_t i = 0; i < state.c.size(); ++i)
        velocity += rate * state.rates[i] *
                    (bent[p].position_by_c[i] - y * bent[p].turn_by_c[i] * bent[p].tangent);
      motion.positions.push_back(points[p]);
      motion.velocities.emplace_back();
      for (unsigned int d = 0; d < 2; ++d)
      {
        motion.positions[p][d]  = position[d];
        motion.velocities[p][d] = velocity[d];
      }
    }
    return motion;
  }

  template class PrescribedMotion<2>;
  template class PrescribedMotion<3>;
} // namespace caudal
