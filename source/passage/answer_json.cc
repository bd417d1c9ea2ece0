// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/json.h>
#include <caudal/passage/answer_output.h>

#include <sstream>

namespace caudal::passage
{
  namespace
  {
    Json list(const std::vector<std::string> &texts)
    {
      Json array = Json::array();
      for (const std::string &text : texts)
        array.append(text);
      return array;
    }

    Json describe_verdict(const Verdict &verdict, const DesignAnswer *design)
    {
      Json bands = Json::array();
      for (std::size_t k = 0; k < verdict.bands.size(); ++k)
      {
        const BandAnswer &answer = verdict.bands[k];
        bands.append(Json::object()
                         .add("name", get_bands()[k].name)
                         .add("better", get_bands()[k].share)
                         .add("passes", answer.ascent.passes())
                         .add("cause", describe(answer.ascent.cause))
                         .add("place", answer.ascent.place)
                         .add("fatigue", answer.ascent.fatigue)
                         .add("time", answer.ascent.time)
                         .add("energy", answer.ascent.energy)
                         .add("velocity factor", answer.velocity_factor)
                         .add("largest velocity", answer.largest_velocity)
                         .add("smallest length", answer.smallest_length));
      }
      Json json = Json::object();
      json.add("discharge", verdict.waterway.discharge)
          .add("length of the way", verdict.waterway.get_length())
          .add("largest water velocity", verdict.waterway.compute_largest_velocity())
          .add("share", verdict.share)
          .add("colour", get_colour(verdict.share))
          .add("sentence", verdict.sentence)
          .add("marks", list(verdict.marks))
          .add("bands", bands);
      if (design)
        json.add("design", design->sentence);
      return json;
    }
  } // namespace

  std::string print_json(const PassageParameters &parameters, const Answers &answers)
  {
    const Population &population = parameters.population;
    Json              verdicts = Json::array(), strikes = Json::array();
    for (std::size_t k = 0; k < answers.verdicts.size(); ++k)
      verdicts.append(describe_verdict(answers.verdicts[k],
                                       k < answers.designs.size() ? &answers.designs[k] : nullptr));
    if (parameters.turbine.is_asked_for())
      for (const auto &[place, strike] :
           list_strikes(parameters.turbine, population.compute_mean_length()))
        strikes.append(Json::object().add("r/R", place).add("probability", strike));
    std::ostringstream out;
    Json::object()
        .add("note", "SI units; bands from the weakest fish to the strongest")
        .add("species", population.species)
        .add("mean length", population.compute_mean_length())
        .add("minimum depth", population.needs.depth)
        .add("velocity factor", parameters.way.velocity_factor)
        .add("endurance", parameters.law.get().describe(population.species))
        .add("way", parameters.way.source.get().describe())
        .add("strategy", parameters.strategy.get().describe())
        .add("energy", parameters.power.get().describe())
        .add("limits", list(get_limits()))
        .add("strikes", strikes)
        .add("verdicts", verdicts)
        .write(out);
    out << '\n';
    return out.str();
  }
} // namespace caudal::passage
