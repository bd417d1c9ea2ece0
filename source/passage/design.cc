// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/passage_parameters.h>
#include <caudal/passage/print.h>
#include <caudal/passage/threshold.h>

#include <cmath>

namespace caudal::passage
{
  namespace
  {
    const double steepest = 1., flattest = 1e-5;
    const double longest = 1e5, shortest = 1e-2; // [m]
    const int    n_bits       = 24;              // of the logarithm of the range: to 1e-6
    const int    most_reaches = 1000;

    /** The largest x between two, both positive, at which enough fish pass. */
    template <class Condition>
    std::optional<double> find_largest(const Condition &is_passed, const double low,
                                       const double high)
    {
      const auto x = find_threshold([&](const double y) { return is_passed(std::exp(-y)); },
                                    -std::log(high), -std::log(low), n_bits);
      return x ? std::optional<double>(std::exp(-*x)) : std::nullopt;
    }

    /** Slopes that are too flat to carry the discharge are no answer: the flattest that does. */
    double find_flattest(const WaterSource &source, const double discharge)
    {
      const auto slope = find_threshold(
          [&](const double y) {
            return source.compute_at_slope(std::exp(y), discharge).has_value();
          },
          std::log(flattest), std::log(steepest));
      return slope ? std::exp(*slope) : steepest;
    }

    std::optional<double> find_slope(const WayParameters &way, const Waterway &waterway,
                                     const std::function<bool(const Waterway &)> &is_passed)
    {
      const WaterSource &source = way.source.get();
      const double       q      = waterway.discharge;
      return find_largest(
          [&](const double slope) {
            const auto water = source.compute_at_slope(slope, q);
            return water && is_passed(way.complete(*water));
          },
          find_flattest(source, q), steepest);
    }

    std::optional<double> find_reach(const Waterway                              &waterway,
                                     const std::function<bool(const Waterway &)> &is_passed)
    {
      WaterPoint fastest = waterway.points[0];
      for (const WaterPoint &point : waterway.points)
        if (point.velocity > fastest.velocity)
          fastest = point;
      return find_largest(
          [&](const double length) {
            Waterway reach;
            reach.has_depths = waterway.has_depths;
            reach.points     = {{0., fastest.velocity, fastest.depth},
                                {length, fastest.velocity, fastest.depth}};
            return is_passed(reach);
          },
          shortest, longest);
    }

    std::optional<double> find_spacing(const Waterway                              &waterway,
                                       const std::function<bool(const Waterway &)> &is_passed)
    {
      for (int n = 1; n <= most_reaches; ++n)
        if (const double spacing = waterway.get_length() / n;
            is_passed(waterway.add_rests(spacing)))
          return spacing;
      return std::nullopt;
    }
  } // namespace

  void DesignParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Design");
    prm.add_parameter("Solve for", target,
                      "What is looked for so that the share of fish passes: 'largest slope' of the "
                      "channel; 'longest reach' without a rest in water like the fastest of the "
                      "way; 'resting distance', the largest distance between places of whole rest "
                      "that cut the way in equal parts.",
                      Patterns::Selection("none|largest slope|longest reach|resting distance"));
    prm.add_parameter("Share of fish", share, "That has to pass [1].");
    prm.leave_subsection();
  }

  void DesignParameters::check(const WaterSource &source) const
  {
    check_value(0. < share && share < 1., "Design/Share of fish", share,
                "Give a number between 0 and 1.");
    AssertThrow(target != "largest slope" || source.has_slope(),
                ExcMessage("Design/Solve for: a profile has no slope that could be changed, as its "
                           "depths would change, too. Give Passage/Type = channel, or solve for "
                           "something else."));
  }

  std::string get_design_column(const DesignParameters &parameters)
  {
    return parameters.target + (parameters.target == "largest slope" ? " [1]" : " [m]");
  }

  DesignAnswer solve_design(const DesignParameters &parameters, const Question &question,
                            const WayParameters &way, const Waterway &waterway)
  {
    const auto is_passed = [&](const Waterway &water) {
      return question.compute_share(water) >= parameters.share;
    };
    DesignAnswer answer{waterway.discharge, std::nullopt, ""};
    const bool   is_slope = parameters.target == "largest slope";
    if (is_slope)
      answer.value = find_slope(way, waterway, is_passed);
    else if (parameters.target == "longest reach")
      answer.value = find_reach(waterway, is_passed);
    else
      answer.value = find_spacing(waterway, is_passed);
    const std::string share = print_number(100. * parameters.share) + " % of the fish";
    answer.sentence         = !answer.value
                                  ? "There is no " + parameters.target + " with which " + share + " pass."
                              : is_slope && *answer.value >= steepest
                                  ? share + " pass at any slope."
                                  : "The " + parameters.target + " with which " + share + " pass is " +
                                print_number(*answer.value) + (is_slope ? "." : " m.");
    return answer;
  }
} // namespace caudal::passage
