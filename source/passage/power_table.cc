// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/column.h>
#include <caudal/passage/power_curve.h>

namespace caudal::passage
{
  namespace
  {
    /** Powers at some speeds from a file. */
    class PowerTable : public PowerCurve
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("File", file, "A table with a header and columns of speed and power.",
                          Patterns::FileName(Patterns::FileName::input));
        speed.add_parameters(prm);
        power.add_parameters(prm);
        prm.add_parameter("Meaning", meaning,
                          "What this power is, for reports: muscle power, oxygen uptake, of which "
                          "fish, from where.");
      }

      void check(const std::string &path) const override
      {
        AssertThrow(!meaning.empty(), ExcMessage(path + "/Meaning: it is empty. Say in some words "
                                                        "what this power is."));
        read(path);
      }

      Power make_power(const double /*length*/) const override
      {
        return {interpolate_power(read("Energy/Table")), 0.};
      }

      std::string describe() const override
      {
        return meaning + ", from the table " + file + " (beyond it in proportion to U^3)";
      }

    private:
      std::vector<PowerPoint> read(const std::string &path) const
      {
        std::vector<PowerPoint> points;
        for (const auto &[u, p] : read_pairs(path, file, speed, power))
          points.push_back({u, p});
        return points;
      }

      std::string file, meaning;
      Column      speed{"speed", "speed", speed_units, "m/s"};
      Column      power{"power", "power", power_units, "W"};
    };

    const Registration<PowerCurve, PowerTable> registration("table",
                                                            "powers at some speeds from a file");
  } // namespace
} // namespace caudal::passage
