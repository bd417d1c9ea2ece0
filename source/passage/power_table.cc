// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/column.h>
#include <caudal/passage/power_curve.h>

#include <algorithm>

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
        AssertThrow(!file.empty(),
                    ExcMessage(path + "/File: there is none. Give a table of speeds and powers."));
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
        TextTable table = read_text_table(path + "/File", file);
        remove_row_of_units(table);
        const std::size_t       u = speed.require(table, path), p = power.require(table, path);
        std::vector<PowerPoint> points;
        for (const TextTable::Row &row : table.rows)
        {
          points.push_back({speed.read(row, u), power.read(row, p)});
          check_positive(row.place + "speed", points.back().speed);
          check_positive(row.place + "power", points.back().power);
        }
        AssertThrow(!points.empty(), ExcMessage(path + "/File: " + file + ": there is no row."));
        std::sort(points.begin(), points.end(),
                  [](const PowerPoint &a, const PowerPoint &b) { return a.speed < b.speed; });
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
          check_value(points[k].speed < points[k + 1].speed, path + "/File: " + file + ": speed",
                      points[k + 1].speed, "It is there twice. Give each speed once.");
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
