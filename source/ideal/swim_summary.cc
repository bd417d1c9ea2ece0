#include <caudal/ideal/swim_summary.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace caudal
{
  using namespace dealii;

  double SwimSummary::get_speed() const
  {
    return distance / duration;
  }

  double SwimSummary::get_radius() const
  {
    return std::abs(turn) > 1e-6 ? std::abs(0.5 * stroke / std::sin(0.5 * turn)) : 0.;
  }

  double SwimSummary::get_cost_of_transport() const
  {
    return distance > 0. ? energy.mean_gross_power() / (mass * get_speed()) : 0.;
  }

  std::string get_ideal_fluid_statement()
  {
    return "The fluid is ideal: no viscous drag, no boundary layer, no wake, and so no\n"
           "thrust from shed vortices. The body moves by the exchange of momentum with the\n"
           "fluid that it displaces; work done in a part of the stroke is returned in\n"
           "another, and speed is proportional to frequency. The figures of the paper are\n"
           "not reproduced exactly, as it leaves units of the shape, phase lag and amplitude\n"
           "open: compare trends.\n";
  }

  namespace
  {
    /** A quantity of the summary, with the factor from SI units to those of the column. */
    struct Quantity
    {
      std::string name, unit;
      double      value;
    };

    std::vector<Quantity> get_quantities(const SwimSummary &summary)
    {
      const double          speed = summary.get_speed();
      std::vector<Quantity> quantities{
          {"frequency", "Hz", summary.frequency},
          {"duration", "s", summary.duration},
          {"distance", "cm", 100. * summary.distance},
          {"mean speed", "cm/s", 100. * speed},
          {"mean speed in body lengths", "1/s", speed / summary.length},
      };
      if (summary.n_strokes > 0)
      {
        quantities.push_back({"whole strokes", "1", static_cast<double>(summary.n_strokes)});
        quantities.push_back({"displacement a stroke", "cm", 100. * summary.stroke});
        quantities.push_back({"turn a stroke", "degrees", summary.turn * 180. / numbers::PI});
        quantities.push_back(
            {"radius of the circle (0: straight)", "cm", 100. * summary.get_radius()});
      }
      quantities.push_back({"mean kinetic energy", "J", summary.energy.mean_energy()});
      quantities.push_back({"largest kinetic energy", "J", summary.energy.largest_energy});
      if (summary.has_torques)
      {
        quantities.push_back({"mean positive power", "W", summary.energy.mean_positive_power()});
        quantities.push_back({"mean gross power", "W", summary.energy.mean_gross_power()});
        quantities.push_back({"cost of transport", "J/(kg m)", summary.get_cost_of_transport()});
        for (std::size_t i = 0; i < summary.energy.largest_torques.size(); ++i)
          quantities.push_back({"largest torque of mode " + std::to_string(i + 1), "N m",
                                summary.energy.largest_torques[i]});
      }
      return quantities;
    }

    /** Calls @p print for each quantity, with the separator between them. */
    template <class Print>
    void print_joined(std::ostream &out, const SwimSummary &summary, const std::string &separator,
                      const Print &print)
    {
      bool is_first = true;
      for (const Quantity &quantity : get_quantities(summary))
      {
        if (!is_first)
          out << separator;
        print(quantity);
        is_first = false;
      }
    }

    /** Of the direction R e_1 in the plane [rad]. */
    double get_heading(const ideal::BodyState &body)
    {
      const Tensor<1, 3> direction = body.rotate(Point<3>(1., 0., 0.));
      return std::atan2(direction[1], direction[0]);
    }
  } // namespace

  void print_summaries(std::ostream &out, const std::vector<SwimSummary> &summaries)
  {
    const auto         flags = out.flags();
    std::ostringstream names;
    for (std::size_t k = 0; k < get_quantities(summaries[0]).size(); ++k)
    {
      const Quantity quantity = get_quantities(summaries[0])[k];
      out << std::left << std::setw(46) << quantity.name + " [" + quantity.unit + "]" << std::right;
      for (const SwimSummary &summary : summaries)
        out << std::setw(14) << std::setprecision(6) << get_quantities(summary)[k].value;
      out << '\n';
    }
    out << '\n' << get_ideal_fluid_statement();
    out.flags(flags);
  }

  void print_csv(std::ostream &out, const std::vector<SwimSummary> &summaries)
  {
    out << std::setprecision(10);
    print_joined(out, summaries[0], ",",
                 [&](const Quantity &q) { out << q.name << " [" << q.unit << "]"; });
    out << '\n';
    for (const SwimSummary &summary : summaries)
    {
      print_joined(out, summary, ",", [&](const Quantity &q) { out << q.value; });
      out << '\n';
    }
  }

  void print_json(std::ostream &out, const std::vector<SwimSummary> &summaries)
  {
    std::string statement = get_ideal_fluid_statement();
    statement.pop_back();
    std::replace(statement.begin(), statement.end(), '\n', ' ');
    out << std::setprecision(10) << "{\n  \"note\": \"" << statement
        << "\",\n  \"constants\": {\n    \"length\": {\"value\": " << summaries[0].length
        << ", \"unit\": \"m\"},\n    \"mass\": {\"value\": " << summaries[0].mass
        << ", \"unit\": \"kg\"}\n  },\n  \"quantities\": {\n    ";
    print_joined(out, summaries[0], ",\n    ", [&](const Quantity &q) {
      out << '"' << q.name << "\": {\"unit\": \"" << q.unit << "\"}";
    });
    out << "\n  },\n  \"swims\": [";
    const char *separator = "\n    {";
    for (const SwimSummary &summary : summaries)
    {
      out << separator;
      print_joined(out, summary, ", ",
                   [&](const Quantity &q) { out << '"' << q.name << "\": " << q.value; });
      separator = "},\n    {";
    }
    out << "}\n  ]\n}\n";
  }

  void StrokeCounter::add(const ideal::MotionSample &sample)
  {
    ends.push_back({sample.centre, get_heading(sample.body)});
  }

  void StrokeCounter::fill(SwimSummary &summary) const
  {
    summary.n_strokes = ends.empty() ? 0 : ends.size() - 1;
    for (std::size_t k = 1; k < ends.size(); ++k)
    {
      summary.stroke += (ends[k].centre - ends[k - 1].centre).norm() / summary.n_strokes;
      const double turn = ends[k].heading - ends[k - 1].heading;
      summary.turn += std::remainder(turn, 2. * numbers::PI) / summary.n_strokes;
    }
  }
} // namespace caudal
