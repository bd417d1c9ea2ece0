// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/answer_output.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace caudal::passage
{
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
        begin_field(header);
        rows << value;
      }

      /** A number; nothing where it is not known. */
      void set(const std::string &header, const double value)
      {
        begin_field(header);
        if (std::isfinite(value))
          rows << value;
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

      void begin_field(const std::string &header)
      {
        if (!has_headers)
          headers += (headers.empty() ? "" : ",") + header;
        rows << (is_first ? "" : ",");
        is_first = false;
      }
    };

    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /** A text within quotes, as spreadsheets want it. */
    std::string quote(const std::string &text)
    {
      return '"' + dealii::Utilities::replace_in_string(text, "\"", "\"\"") + '"';
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
        csv.set(get_design_column(parameters.design), answers.designs[k].value.value_or(unknown));
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
          csv.set("depth [m]", verdict.waterway.has_depths ? point.water.depth : unknown);
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
} // namespace caudal::passage
