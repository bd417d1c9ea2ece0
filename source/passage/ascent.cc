// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/ascent.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace caudal::passage
{
  namespace
  {
    /** A fish on its way. */
    class Walker
    {
    public:
      Walker(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
             const Behaviour &behaviour, const AscentOptions &options)
          : waterway(waterway)
          , curve(curve)
          , needs(needs)
          , behaviour(behaviour)
          , options(options)
          , longest_step(waterway.get_length() / 200.)
      {}

      Ascent walk()
      {
        const auto &points = waterway.points;
        note(points[0]);
        for (std::size_t k = 0; k + 1 < points.size() && !is_stopped; ++k)
        {
          WaterPoint here = points[k];
          // What stands at the end of a stretch is met there, before the next one begins.
          while (!is_stopped && get_event_distance() < points[k + 1].distance)
          {
            const WaterPoint next = interpolate(here, points[k + 1], get_event_distance());
            cross(here, next);
            if (!is_stopped)
              meet_event(next);
            here = next;
          }
          if (!is_stopped)
            cross(here, points[k + 1]);
        }
        while (!is_stopped && get_event_distance() <= waterway.get_length())
          meet_event(points.back());
        if (!is_stopped)
          ascent.reach = waterway.get_length();
        if (ascent.cause == Cause::none)
          set_place(hardest);
        return ascent;
      }

    private:
      const Waterway       &waterway;
      const EnduranceCurve &curve;
      const Needs          &needs;
      const Behaviour      &behaviour;
      const AscentOptions  &options;
      const double          longest_step; // between the points of the way [m]

      Ascent                ascent;
      std::array<double, 2> fatigue{{0., 0.}};  // of the stores
      double                effort_time  = 0.;  // since the last rest [s]
      double                largest_rate = -1.; // of fatigue [1/m]
      double                last_speed   = 0.;  // [m/s]
      WaterPoint            hardest{0., 0., 0.};
      std::size_t           next_drop = 0, next_rest = 0;
      bool                  is_stopped = false;

      /** Where the next drop or rest is; infinity if there is none. */
      double get_event_distance() const
      {
        const double far = std::numeric_limits<double>::infinity();
        const double drop =
            next_drop < waterway.drops.size() ? waterway.drops[next_drop].distance : far;
        const double rest =
            next_rest < waterway.rests.size() ? waterway.rests[next_rest].distance : far;
        return std::min(drop, rest);
      }

      static WaterPoint interpolate(const WaterPoint &a, const WaterPoint &b, const double distance)
      {
        if (b.distance == a.distance)
          return a;
        const double share = (distance - a.distance) / (b.distance - a.distance);
        return {distance, a.velocity + share * (b.velocity - a.velocity),
                a.depth + share * (b.depth - a.depth)};
      }

      void set_place(const WaterPoint &point)
      {
        ascent.place    = point.distance;
        ascent.velocity = point.velocity;
      }

      /** The first cause counts. */
      void fail(const Cause cause, const WaterPoint &point)
      {
        if (ascent.cause != Cause::none)
          return;
        ascent.cause = cause;
        set_place(point);
      }

      void stop(const Cause cause, const WaterPoint &point)
      {
        fail(cause, point);
        ascent.reach = point.distance;
        is_stopped   = true;
      }

      void meet_event(const WaterPoint &point)
      {
        const double distance = get_event_distance();
        // Pools lie above their drops.
        if (next_drop < waterway.drops.size() && waterway.drops[next_drop].distance == distance)
          pass_drop(waterway.drops[next_drop++], point);
        else
        {
          const double rest = 1. - waterway.rests[next_rest++].recovery;
          fatigue           = {{fatigue[0] * rest, fatigue[1] * rest}};
          effort_time       = 0.;
          last_speed        = 0.;
        }
        note(point);
      }

      void pass_drop(const Drop &drop, const WaterPoint &point)
      {
        const double     velocity = std::sqrt(2. * gravity * drop.height);
        const WaterPoint jet{point.distance, velocity, point.depth};
        if (needs.largest_drop > 0. && drop.height > needs.largest_drop)
          stop(Cause::drop, jet);
        else if (drop.length == 0.)
        {
          const double speed = needs.leap_speed > 0. ? needs.leap_speed : curve.get_fastest();
          if (velocity > speed)
            stop(Cause::leap, jet);
        }
        else if (!behaviour(velocity))
          stop(Cause::velocity, jet);
        else
        {
          note(jet);
          swim(jet, jet, drop.length);
          note(jet);
        }
      }

      /** The places before and behind which @p holds, that does at the beginning, ends to do so. */
      template <class Condition>
      static std::pair<WaterPoint, WaterPoint> find_end(const WaterPoint &a, const WaterPoint &b,
                                                        const Condition &holds)
      {
        double before = 0., behind = 1.;
        for (int k = 0; k < std::numeric_limits<double>::digits; ++k)
        {
          const double middle                            = 0.5 * (before + behind);
          (holds(blend(a, b, middle)) ? before : behind) = middle;
        }
        return {blend(a, b, before), blend(a, b, behind)};
      }

      static WaterPoint blend(const WaterPoint &a, const WaterPoint &b, const double share)
      {
        // Beyond b, by rounding, there may be no way.
        if (share == 1.)
          return b;
        return interpolate(a, b, a.distance + share * (b.distance - a.distance));
      }

      /** Swims along a stretch as far as there is a way. */
      void cross(const WaterPoint &begin, WaterPoint end)
      {
        if (begin.distance == end.distance)
          return;
        const auto is_deep = [&](const WaterPoint &p) { return p.depth >= needs.depth; };
        const auto gets_on = [&](const WaterPoint &p) { return behaviour(p.velocity).has_value(); };
        Cause      cause   = Cause::none;
        if (waterway.has_depths && !is_deep(begin))
          return stop(Cause::depth, begin);
        if (!gets_on(begin))
          return stop(Cause::velocity, begin);
        if (waterway.has_depths && !is_deep(end))
        {
          end   = find_end(begin, end, is_deep).first;
          cause = Cause::depth;
        }
        if (!gets_on(end))
        {
          end   = find_end(begin, end, gets_on).first;
          cause = Cause::velocity;
        }
        cross_passable(begin, end);
        if (cause != Cause::none)
          stop(cause, end);
      }

      /** Swims along a stretch that offers a way; behaviour may change once on it. */
      void cross_passable(const WaterPoint &begin, const WaterPoint &end)
      {
        const unsigned int store = behaviour(begin.velocity)->store;
        if (store == behaviour(end.velocity)->store)
          return cross_in_steps(begin, end);
        const auto is_same = [&](const WaterPoint &p) {
          return behaviour(p.velocity)->store == store;
        };
        const auto [before, behind] = find_end(begin, end, is_same);
        cross_in_steps(begin, before);
        cross_in_steps(behind, end);
      }

      void cross_in_steps(const WaterPoint &begin, const WaterPoint &end)
      {
        const double length = end.distance - begin.distance;
        const int n = options.is_detailed ? static_cast<int>(std::ceil(length / longest_step)) : 1;
        note(begin);
        for (int k = 0; k < n; ++k)
        {
          const WaterPoint a = blend(begin, end, double(k) / n),
                           b = blend(begin, end, (k + 1.) / n);
          swim(a, b, b.distance - a.distance);
          note(b);
        }
      }

      /** The integral over the length of what is a function of the velocity, linear in between. */
      template <class Integrand>
      static double integrate(const Integrand &integrand, const WaterPoint &a, const WaterPoint &b,
                              const double length)
      {
        if (length == 0.)
          return 0.;
        if (std::abs(b.velocity - a.velocity) <= 1e-14 * std::abs(a.velocity))
          return length * integrand(0.5 * (a.velocity + b.velocity));
        using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;
        return length * Quadrature::integrate(
                            [&](const double share) {
                              return integrand(a.velocity + share * (b.velocity - a.velocity));
                            },
                            0., 1., 12, 1e-11);
      }

      double compute_rate(const double velocity) const
      {
        const auto action = behaviour(velocity);
        return 1. / ((action->effort.speed - velocity) * action->effort.endurance);
      }

      /** Swims from a to b, where behaviour is of one kind, and gets tired. */
      void swim(const WaterPoint &a, const WaterPoint &b, const double length)
      {
        const auto   rate  = [this](const double velocity) { return compute_rate(velocity); };
        const Action start = *behaviour(a.velocity);
        const double added = integrate(rate, a, b, length);
        double      &sum   = fatigue[start.store];
        if (sum + added > 1. && ascent.cause == Cause::none)
          fail(start.store == 0 ? Cause::exhaustion : Cause::burst,
               options.is_detailed ? find_exhaustion(a, b, length, 1. - sum, added) : b);
        sum += added;
        ascent.fatigue = std::max(ascent.fatigue, sum);
        if (options.is_detailed)
          note_details(a, b, length);
      }

      /** Where the fatigue that is left is used up. */
      WaterPoint find_exhaustion(const WaterPoint &a, const WaterPoint &b, const double length,
                                 const double left, const double added) const
      {
        if (left <= 0.)
          return a;
        const auto rate   = [this](const double velocity) { return compute_rate(velocity); };
        const auto excess = [&](const double share) {
          const WaterPoint end = blend(a, b, share);
          return integrate(rate, a, end, share * length) - left;
        };
        if (excess(1.) <= 0. || added <= left)
          return b;
        boost::uintmax_t iterations = 100;
        const auto       bracket    = boost::math::tools::toms748_solve(
                     excess, 0., 1., -left, added - left, boost::math::tools::eps_tolerance<double>(40),
                     iterations);
        return blend(a, b, bracket.second);
      }

      void note_details(const WaterPoint &a, const WaterPoint &b, const double length)
      {
        const auto pace = [this](const double v) { return 1. / (behaviour(v)->effort.speed - v); };
        const double duration = integrate(pace, a, b, length);
        ascent.time += duration;
        effort_time += duration;
        ascent.longest_effort = std::max(ascent.longest_effort, effort_time);
        if (options.power)
          ascent.energy += integrate(
              [&](const double v) { return pace(v) * options.power(behaviour(v)->effort.speed); },
              a, b, length);
        for (const WaterPoint &point : {a, b})
        {
          const auto [speed, endurance] = behaviour(point.velocity)->effort;
          ascent.shortest_endurance     = std::min(ascent.shortest_endurance, endurance);
          ascent.longest_endurance      = std::max(ascent.longest_endurance, endurance);
          // What it gains in kinetic energy is lost when it slows down.
          ascent.energy +=
              0.5 * options.moving_mass * std::max(speed * speed - last_speed * last_speed, 0.);
          last_speed = speed;
          if (const double rate = compute_rate(point.velocity); rate > largest_rate)
          {
            largest_rate = rate;
            hardest      = point;
          }
        }
      }

      void note(const WaterPoint &point)
      {
        if (!options.is_detailed || is_stopped)
          return;
        const auto action = behaviour(point.velocity);
        ascent.points.push_back({point, ascent.time, action ? action->effort.speed : 0.,
                                 std::max(fatigue[0], fatigue[1]), ascent.energy});
      }
    };
  } // namespace

  std::string describe(const Cause cause)
  {
    switch (cause)
    {
    case Cause::velocity:
      return "velocity";
    case Cause::exhaustion:
      return "exhaustion";
    case Cause::burst:
      return "exhaustion at burst";
    case Cause::depth:
      return "depth";
    case Cause::leap:
      return "leap";
    case Cause::drop:
      return "drop";
    default:
      return "none";
    }
  }

  Ascent compute_ascent(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
                        const Behaviour &behaviour, const AscentOptions &options)
  {
    return Walker(waterway, curve, needs, behaviour, options).walk();
  }
} // namespace caudal::passage
