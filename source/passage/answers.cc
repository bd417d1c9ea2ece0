// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/json.h>
#include <caudal/base/print.h>
#include <caudal/passage/answers.h>

#include <iomanip>
#include <sstream>

namespace caudal::passage
{
  Answers compute_answers(const PassageParameters &parameters)
  {
    const Question question  = parameters.get_question();
    const auto     waterways = parameters.way.make_waterways();
    Answers        answers;
    for (const Waterway &waterway : waterways)
    {
      answers.verdicts.push_back(compute_verdict(question, parameters.power.get(), waterway));
      if (parameters.design.is_asked_for())
        answers.designs.push_back(
            solve_design(parameters.design, question, parameters.way, waterway));
    }
    if (parameters.batch.is_asked_for())
      answers.batch = answer_batch(parameters.batch, question, waterways);
    return answers;
  }

  const std::vector<std::string> &get_limits()
  {
    static const std::vector<std::string> limits{
        "Swimming ability only: whether fish find the entrance (attraction) and want to go "
        "(motivation) is left out.",
        "Endurance is that of the law's data: 3 to 1800 s unless it says otherwise, for the "
        "lengths "
        "that it names. Answers beyond are extrapolated, and marked.",
        "Temperature, oxygen, light, health and earlier efforts of the fish are not included.",
        "Fatigue is taken to add up linearly, whatever the order of fast and slow water.",
        "Turbulence, air and the route across the section are not included but by the velocity "
        "factor."};
    return limits;
  }

  namespace
  {
    std::string print_discharge(const double discharge)
    {
      return discharge > 0. ? "At " + print_rounded(discharge) + " m^3/s" : "On the way";
    }

    void print_bands(std::ostream &out, const Verdict &verdict)
    {
      out << "  fish                  better [%]  fatigue  cause                place [m]  time [s]"
             "  largest velocity [m/s]  smallest length [m]\n";
      for (std::size_t k = 0; k < verdict.bands.size(); ++k)
      {
        const BandAnswer &answer = verdict.bands[k];
        out << "  " << std::left << std::setw(20) << get_bands()[k].name << std::right
            << std::setw(12) << 100. * get_bands()[k].share << std::setw(9)
            << print_rounded(answer.ascent.fatigue) << "  " << std::left << std::setw(20)
            << (answer.ascent.passes() ? "passes" : describe(answer.ascent.cause)) << std::right
            << std::setw(10) << print_rounded(answer.ascent.place) << std::setw(10)
            << print_rounded(answer.ascent.time) << std::setw(24)
            << print_rounded(answer.largest_velocity) << std::setw(21)
            << (answer.smallest_length > 0. ? print_rounded(answer.smallest_length) : "none")
            << '\n';
      }
    }
  } // namespace

  std::string print_text(const PassageParameters &parameters, const Answers &answers)
  {
    const Population  &population = parameters.population;
    const std::string  energy     = parameters.power.get().describe();
    std::ostringstream out;
    out << "Can this fish pass? " << population.species << " of "
        << print_rounded(population.compute_mean_length()) << " m\n"
        << "  endurance  " << parameters.law.get().describe(population.species) << '\n'
        << "  way        " << parameters.way.source.get().describe() << '\n'
        << "  strategy   " << parameters.strategy.get().describe() << '\n';
    if (!energy.empty())
      out << "  energy     " << energy << '\n';
    for (std::size_t k = 0; k < answers.verdicts.size(); ++k)
    {
      const Verdict &verdict = answers.verdicts[k];
      out << '\n'
          << print_discharge(verdict.waterway.discharge) << ": " << verdict.sentence << '\n';
      print_bands(out, verdict);
      if (!energy.empty())
        out << "  The median fish spends "
            << print_rounded(verdict.bands[median_band].ascent.energy) << " J.\n";
      if (k < answers.designs.size())
        out << "  " << answers.designs[k].sentence << '\n';
      for (const std::string &mark : verdict.marks)
        out << "Warning: " << mark << '\n';
    }
    if (!answers.batch.empty())
      out << "\nBatch: " << answers.batch.size() << " answers in batch.csv.\n";
    if (parameters.turbine.is_asked_for())
    {
      out << "\nDown through the turbine (Franke et al. 1997), probability of a strike at r/R =";
      for (const auto &[place, strike] :
           list_strikes(parameters.turbine, population.compute_mean_length()))
        out << ' ' << place << ": " << print_rounded(strike) << (place < 1. ? "," : ".\n");
    }
    out << "\nLimits of validity\n";
    for (const std::string &limit : get_limits())
      out << "  " << limit << '\n';
    return out.str();
  }

  namespace
  {
    /** Writes rows with a common header, "name [unit]". */
    class Csv
    {
    public:
      Csv()
      {
        rows << std::setprecision(12);
      }

      template <class Value>
      void set(const std::string &header, const Value &value)
      {
        if (!has_headers)
          headers += (headers.empty() ? "" : ",") + header;
        rows << (is_first ? "" : ",") << value;
        is_first = false;
      }

      void end_row()
      {
        rows << '\n';
        has_headers = true;
        is_first    = true;
      }

      std::string print() const
      {
        return headers + '\n' + rows.str();
      }

    private:
      std::string        headers;
      std::ostringstream rows;
      bool               has_headers = false, is_first = true;
    };

    /** A text within quotes, as spreadsheets want it. */
    std::string quote(const std::string &text)
    {
      return '"' + text + '"';
    }
  } // namespace

  std::string print_summary(const PassageParameters &parameters, const Answers &answers)
  {
    Csv csv;
    for (std::size_t k = 0; k < answers.verdicts.size(); ++k)
    {
      const Verdict &verdict = answers.verdicts[k];
      csv.set("discharge [m^3/s]", verdict.waterway.discharge);
      csv.set("share that passes [1]", verdict.share);
      for (std::size_t b = 0; b < verdict.bands.size(); ++b)
      {
        const BandAnswer &answer = verdict.bands[b];
        const std::string fish   = " of the " + get_bands()[b].name;
        csv.set("passage" + fish + " [1]", answer.ascent.passes() ? 1 : 0);
        csv.set("fatigue" + fish + " [1]", answer.ascent.fatigue);
        csv.set("place" + fish + " [m]", answer.ascent.place);
        csv.set("time" + fish + " [s]", answer.ascent.time);
        csv.set("energy" + fish + " [J]", answer.ascent.energy);
        csv.set("velocity factor" + fish + " [1]", answer.velocity_factor);
        csv.set("largest velocity" + fish + " [m/s]", answer.largest_velocity);
        csv.set("smallest length" + fish + " [m]", answer.smallest_length);
      }
      csv.set("largest water velocity [m/s]", verdict.waterway.compute_largest_velocity());
      if (k < answers.designs.size())
        csv.set(get_design_column(parameters.design), answers.designs[k].value.value_or(0.));
      if (parameters.turbine.is_asked_for())
        csv.set("strike at the tip of the blades [1]",
                parameters.turbine.compute_strike(parameters.population.compute_mean_length(), 1.));
      csv.end_row();
    }
    return csv.print();
  }

  std::string print_ways(const Answers &answers)
  {
    Csv csv;
    for (const Verdict &verdict : answers.verdicts)
      for (std::size_t b = 0; b < verdict.bands.size(); ++b)
        for (const AscentPoint &point : verdict.bands[b].ascent.points)
        {
          csv.set("discharge [m^3/s]", verdict.waterway.discharge);
          csv.set("fish", quote(get_bands()[b].name));
          csv.set("distance [m]", point.water.distance);
          csv.set("time [s]", point.time);
          csv.set("water velocity [m/s]", point.water.velocity);
          csv.set("depth [m]", point.water.depth);
          csv.set("swimming speed [m/s]", point.speed);
          csv.set("fatigue [1]", point.fatigue);
          csv.set("energy [J]", point.energy);
          csv.end_row();
        }
    return csv.print();
  }

  std::string print_batch(const Answers &answers)
  {
    Csv csv;
    for (const BatchAnswer &answer : answers.batch)
    {
      csv.set("species", quote(answer.fish.species));
      csv.set("length [m]", answer.fish.length);
      csv.set("discharge [m^3/s]", answer.discharge);
      csv.set("share that passes [1]", answer.share);
      csv.set("verdict", get_colour(answer.share));
      csv.set("fatigue of the median [1]", answer.fatigue);
      csv.set("cause", describe(answer.cause));
      csv.set("place [m]", answer.place);
      csv.set("remark", quote(answer.remark));
      csv.end_row();
    }
    return csv.print();
  }

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
