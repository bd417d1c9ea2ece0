// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/json.h>
#include <caudal/ideal/swim_summary.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace caudal
{
  using namespace dealii;

  SwimSummary::SwimSummary(const SwimState &swim)
      : duration(swim.last.time)
      , distance(swim.get_distance())
      , n_strokes(swim.stroke_ends.empty() ? 0 : swim.stroke_ends.size() - 1)
      , energy(swim.energy)
  {
    for (unsigned int k = 0; k < n_strokes; ++k)
    {
      const StrokeEnd &begin = swim.stroke_ends[k], &end = swim.stroke_ends[k + 1];
      stroke += (end.centre - begin.centre).norm() / n_strokes;
      turn += std::remainder(end.heading - begin.heading, 2. * numbers::PI) / n_strokes;
    }
  }

  std::string get_ideal_fluid_statement()
  {
    return "The fluid is ideal: no viscous drag, no boundary layer, no wake, and so no\n"
           "thrust from shed vortices. The body moves by the exchange of momentum with the\n"
           "fluid that it displaces; work done in a part of the stroke is returned in\n"
           "another, and speed is proportional to frequency. Powers are those of the joints\n"
           "against this fluid: without Resistance they vanish on average, and no power or cost\n"
           "of a real fish follows from them. Resistance, where it is active, acts on each piece\n"
           "of the surface by itself: friction slows the fish down, but the cross-flow force\n"
           "also drives it, by its undulating sides. The figures of Yao et al. are not\n"
           "reproduced exactly, as their paper leaves units of the shape, phase lag and\n"
           "amplitude open: compare trends.\n";
  }

  namespace
  {
    /** A quantity of the summary, with the factor from SI units to those of the column. */
    struct Quantity
    {
      std::string name, unit;
      double      value;
    };

    bool has_strokes(const std::vector<SwimSummary> &summaries)
    {
      return std::any_of(summaries.begin(), summaries.end(),
                         [](const SwimSummary &summary) { return summary.n_strokes > 0; });
    }

    /** With @p strokes also what only whole strokes have; it is no number where there are none. */
    std::vector<Quantity> get_quantities(const SwimSummary &summary, const bool strokes)
    {
      const double          speed = summary.distance / summary.duration;
      std::vector<Quantity> quantities{
          {"frequency", "Hz", summary.frequency},
          {"duration", "s", summary.duration},
          {"distance", "cm", 100. * summary.distance},
          {"mean speed", "cm/s", 100. * speed},
          {"mean speed in body lengths", "1/s", speed / summary.length},
      };
      if (strokes)
      {
        const double unknown =
            summary.n_strokes > 0 ? 0. : std::numeric_limits<double>::quiet_NaN();
        // On which the centre of mass stands at the ends of the strokes.
        const double radius = std::abs(summary.turn) > 1e-6
                                  ? std::abs(0.5 * summary.stroke / std::sin(0.5 * summary.turn))
                                  : 0.;
        quantities.push_back({"whole strokes", "1", static_cast<double>(summary.n_strokes)});
        quantities.push_back({"displacement a stroke", "cm", 100. * summary.stroke + unknown});
        quantities.push_back(
            {"turn a stroke", "degrees", summary.turn * 180. / numbers::PI + unknown});
        quantities.push_back({"radius of the circle (0: straight)", "cm", 100. * radius + unknown});
      }
      quantities.push_back({"mean kinetic energy", "J", summary.energy.mean_energy()});
      quantities.push_back({"largest kinetic energy", "J", summary.energy.largest_energy});
      if (summary.has_torques)
      {
        const double gross = summary.energy.mean_gross_power();
        quantities.push_back({"mean positive power", "W", summary.energy.mean_positive_power()});
        quantities.push_back({"mean gross power", "W", gross});
        quantities.push_back({"cost of transport", "J/(kg m)",
                              summary.distance > 0. ? gross / (summary.mass * speed) : 0.});
        for (std::size_t i = 0; i < summary.energy.largest_torques.size(); ++i)
          quantities.push_back(
              {"largest torque of " + summary.coordinate + " " + std::to_string(i + 1), "N m",
               summary.energy.largest_torques[i]});
      }
      return quantities;
    }
  } // namespace

  std::string print_text(const std::vector<SwimSummary> &summaries)
  {
    std::ostringstream                 out;
    std::vector<std::vector<Quantity>> columns;
    for (const SwimSummary &summary : summaries)
      columns.push_back(get_quantities(summary, has_strokes(summaries)));
    for (std::size_t k = 0; k < columns[0].size(); ++k)
    {
      const Quantity &quantity = columns[0][k];
      out << std::left << std::setw(46) << quantity.name + " [" + quantity.unit + "]" << std::right;
      for (const auto &column : columns)
        if (std::isfinite(column[k].value))
          out << std::setw(14) << std::setprecision(6) << column[k].value;
        else
          out << std::setw(14) << "-";
      out << '\n';
    }
    out << '\n' << get_ideal_fluid_statement();
    return out.str();
  }

  std::string print_csv(const std::vector<SwimSummary> &summaries)
  {
    std::ostringstream header, rows;
    rows << std::setprecision(10);
    for (const SwimSummary &summary : summaries)
    {
      const char *separator = "";
      for (const Quantity &quantity : get_quantities(summary, has_strokes(summaries)))
      {
        if (&summary == &summaries[0])
          header << separator << quantity.name << " [" << quantity.unit << "]";
        rows << separator;
        if (std::isfinite(quantity.value))
          rows << quantity.value;
        separator = ",";
      }
      rows << '\n';
    }
    return header.str() + "\n" + rows.str();
  }

  std::string print_json(const std::vector<SwimSummary> &summaries)
  {
    const auto measure = [](const double value, const std::string &unit) {
      return Json::object().add("value", value).add("unit", unit);
    };
    std::string statement = get_ideal_fluid_statement();
    statement.pop_back();
    std::replace(statement.begin(), statement.end(), '\n', ' ');
    Json quantities = Json::object(), swims = Json::array();
    for (const Quantity &quantity : get_quantities(summaries[0], has_strokes(summaries)))
      quantities.add(quantity.name, Json::object().add("unit", quantity.unit));
    for (const SwimSummary &summary : summaries)
    {
      Json swim = Json::object();
      for (const Quantity &quantity : get_quantities(summary, has_strokes(summaries)))
        swim.add(quantity.name, quantity.value);
      swims.append(swim);
    }
    std::ostringstream out;
    Json::object()
        .add("note", statement)
        .add("constants", Json::object()
                              .add("length", measure(summaries[0].length, "m"))
                              .add("mass", measure(summaries[0].mass, "kg")))
        .add("quantities", quantities)
        .add("swims", swims)
        .write(out);
    out << '\n';
    return out.str();
  }
} // namespace caudal
