// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/print.h>
#include <caudal/passage/threshold.h>
#include <caudal/passage/verdict.h>

#include <boost/math/distributions/normal.hpp>

#include <cmath>
#include <limits>

namespace caudal::passage
{
  const std::vector<Band> &get_bands()
  {
    static const std::vector<Band> bands = []() {
      std::vector<Band> result;
      for (const auto &[share, name] :
           {std::make_pair(0.975, "lower limit of 95 %"),
            std::make_pair(0.875, "lower limit of 75 %"), std::make_pair(0.5, "median"),
            std::make_pair(0.125, "upper limit of 75 %"),
            std::make_pair(0.025, "upper limit of 95 %")})
        result.push_back({quantile(complement(boost::math::normal(), share)), share, name});
      return result;
    }();
    return bands;
  }

  std::string get_colour(const double share)
  {
    return share >= 0.875 ? "green" : share >= 0.5 ? "amber" : "red";
  }

  namespace
  {
    std::string print_place(const Ascent &ascent)
    {
      return print_number(ascent.place) + " m, in water of " + print_number(ascent.velocity) +
             " m/s";
    }

    std::string print_percent(const double share)
    {
      return 0. < share && share < 1e-3 ? "less than 0.1 %" : print_number(100. * share) + " %";
    }

    /** The largest factor on the velocities that lets it pass, from a hundredth on. */
    double find_velocity_factor(const Question &question, const Waterway &waterway,
                                const double length, const double ability)
    {
      // Towards slower water: minus the logarithm grows.
      const double velocity = waterway.compute_largest_velocity();
      const double limit    = std::log(velocity > 0. ? std::max(100., 20. / velocity) : 100.);
      const auto   factor   = find_threshold(
          [&](const double x) {
            return question.passes(waterway.scale_velocities(std::exp(-x)), length, ability);
          },
          -limit, std::log(100.));
      return factor ? std::exp(-*factor) : 0.;
    }

    BandAnswer answer_for(const Question &question, const Waterway &waterway, const double length,
                          const Band &band, const AscentOptions &options)
    {
      BandAnswer answer;
      answer.ascent           = question.ascend(waterway, length, band.ability, options);
      answer.velocity_factor  = find_velocity_factor(question, waterway, length, band.ability);
      const double unknown    = std::numeric_limits<double>::quiet_NaN();
      const double velocity   = waterway.compute_largest_velocity();
      answer.largest_velocity = velocity > 0. ? answer.velocity_factor * velocity : unknown;
      const auto smallest     = find_threshold(
          [&](const double l) { return question.passes(waterway, std::exp(l), band.ability); },
          std::log(1e-3), std::log(largest_length));
      answer.smallest_length = smallest ? std::exp(*smallest) : unknown;
      return answer;
    }

    /** What the ways of the fish tell of the law's limits. */
    std::vector<std::string> mark_durations(const Question &question, const Verdict &verdict,
                                            const double length)
    {
      std::vector<std::string> marks;
      std::string              short_bands, slow_bands, long_bands;
      const auto               add = [](std::string &bands, const std::string &name) {
        bands += (bands.empty() ? "" : ", ") + name;
      };
      double shortest = 0., longest = 0.;
      for (std::size_t k = 0; k < verdict.bands.size(); ++k)
      {
        const Band          &band = get_bands()[k];
        const EnduranceCurve curve =
            question.law.make_curve({question.population.species, length, band.ability});
        const Ascent &ascent = verdict.bands[k].ascent;
        shortest             = curve.get_shortest_duration();
        longest              = curve.get_longest_duration();
        if (ascent.shortest_endurance < shortest * (1. - 1e-9))
          add(short_bands, band.name);
        if (ascent.longest_endurance > longest * (1. + 1e-9))
          add(slow_bands, band.name);
        if (ascent.longest_effort > longest)
          add(long_bands, band.name);
      }
      if (!short_bands.empty())
        marks.push_back(
            "Some speeds on the way can be held for less than the " + print_number(shortest) +
            " s from which on there are data, and are extrapolated (" + short_bands + ").");
      if (!slow_bands.empty())
        marks.push_back("Some speeds on the way can be held for more than the " +
                        Patterns::Tools::to_string(longest) +
                        " s up to which there are data, and are extrapolated (" + slow_bands +
                        ").");
      if (!long_bands.empty())
        marks.push_back("The way takes longer than the " + Patterns::Tools::to_string(longest) +
                        " s up to which there are data (" + long_bands + ").");
      return marks;
    }

    /** Whether weak and strong fish of the law are the same. */
    std::vector<std::string> mark_spread(const Question &question, const double length)
    {
      const auto get_speed = [&](const double ability) {
        return question.law.make_curve({question.population.species, length, ability})
            .get_fastest();
      };
      if (get_speed(1.) != get_speed(-1.))
        return {};
      return {"The spread of the endurance among fish is not known: all bands are that of the "
              "median."};
    }

    std::string make_sentence(const Question &question, const Verdict &verdict)
    {
      const auto &bands = verdict.bands;
      const auto  needs = question.population.needs;
      std::string text  = print_percent(verdict.share) + " of the fish pass";
      if (question.population.number > 0.)
        text += ", " + std::to_string(std::lround(verdict.share * question.population.number)) +
                " of " + std::to_string(std::lround(question.population.number));
      text += ". The median fish " +
              describe_ascent(bands[median_band].ascent, verdict.waterway, needs) + ".";
      // If the median passes, the best of those that fail tells what to mend.
      for (std::size_t k = median_band; k-- > 0;)
        if (bands[median_band].ascent.passes() && !bands[k].ascent.passes())
        {
          text += " One that " + print_percent(get_bands()[k].share) + " of the fish exceed " +
                  describe_ascent(bands[k].ascent, verdict.waterway, needs) + ".";
          break;
        }
      return text;
    }
  } // namespace

  std::string describe_ascent(const Ascent &ascent, const Waterway &waterway, const Needs &needs)
  {
    const std::string place = print_place(ascent);
    switch (ascent.cause)
    {
    case Cause::none:
      return "passes the " + print_number(waterway.get_length()) + " m in " +
             print_number(ascent.time) + " s with " + print_percent(1. - ascent.fatigue) +
             " of its endurance left; the most tiring place is at " + place;
    case Cause::velocity:
      return "can't get on at " + place + ": that is as fast as it can swim";
    case Cause::exhaustion:
      return "is exhausted at " + place + "; the whole way would take " +
             print_number(ascent.fatigue) + " times its endurance";
    case Cause::burst:
      return "is exhausted by bursts at " + place;
    case Cause::depth:
      return "finds the water too shallow at " + print_number(ascent.place) + " m, for it needs " +
             print_number(needs.depth) + " m";
    case Cause::leap:
      return "can't leap the drop at " + print_number(ascent.place) + " m, which asks for " +
             print_number(ascent.velocity) + " m/s";
    default:
      return "is stopped by the drop at " + print_number(ascent.place) +
             " m, which is higher than the " + print_number(needs.largest_drop) +
             " m that are allowed";
    }
  }

  std::vector<std::string> mark_lengths(const Question &question)
  {
    const auto [shortest, longest] = question.law.get_length_range(question.population.species);
    double outside                 = 0.;
    for (const LengthClass &length_class : question.population.make_classes())
      if (length_class.length < shortest || length_class.length > longest)
        outside += length_class.share;
    if (outside == 0.)
      return {};
    return {print_percent(outside) + " of the fish are shorter or longer than those of the data (" +
            print_number(shortest) + " to " + print_number(longest) +
            " m): their answers are extrapolated."};
  }

  Verdict compute_verdict(const Question &question, const PowerCurve &power,
                          const Waterway &waterway)
  {
    const double length   = question.population.compute_mean_length();
    const Power  spending = power.make_power(length);
    Verdict      verdict;
    verdict.waterway = waterway;
    verdict.share    = question.compute_share(waterway);
    for (const Band &band : get_bands())
      verdict.bands.push_back(answer_for(question, waterway, length, band,
                                         {true, spending.at_speed, spending.moving_mass}));
    verdict.sentence = make_sentence(question, verdict);
    verdict.marks    = mark_lengths(question);
    for (const auto &marks :
         {mark_spread(question, length), mark_durations(question, verdict, length)})
      verdict.marks.insert(verdict.marks.end(), marks.begin(), marks.end());
    return verdict;
  }
} // namespace caudal::passage
