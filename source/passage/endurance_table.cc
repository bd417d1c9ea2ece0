// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/column.h>
#include <caudal/passage/endurance_law.h>

#include <cmath>

namespace caudal::passage
{
  namespace
  {
    /**
     * A table of speeds U and endurances T of one's own: ln T is linear in ln U between its rows.
     * Faster than its fastest row there is nothing, slower than its slowest one the endurance is
     * that of this row.
     */
    class EnduranceTable : public EnduranceLaw
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("File", file, "A table with a header and columns of speed and endurance.",
                          Patterns::FileName(Patterns::FileName::input));
        speed.add_parameters(prm);
        endurance.add_parameters(prm);
        prm.add_parameter("Speeds in lengths", in_lengths,
                          "Whether the speeds are in lengths a second; then their unit does not "
                          "matter.");
        prm.add_parameter("Source", source, "Where the table is from, for reports.");
        prm.add_parameter("Spread", spread,
                          "Standard deviation of ln U among fish [1]; 0: not known, all bands are "
                          "that of the median.");
        lengths.add_parameters(prm);
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Spread", spread);
        lengths.check(path);
        read(path);
      }

      EnduranceCurve make_curve(const Fish &fish) const override
      {
        if (rows.empty())
          rows = read("Endurance/Table");
        const double scale = (in_lengths ? fish.length : 1.) * std::exp(spread * fish.ability);
        std::vector<EnduranceBranch> branches;
        for (std::size_t k = 0; k + 1 < rows.size(); ++k)
        {
          const auto  &slow = rows[k], &fast = rows[k + 1];
          const double slope =
              std::log(fast.endurance / slow.endurance) / std::log(fast.speed / slow.speed);
          branches.push_back({std::log(slow.endurance) - slope * std::log(slow.speed * scale),
                              slope, false, slow.speed * scale, fast.speed * scale});
        }
        branches.push_back({std::log(rows[0].endurance), 0., false, 0., rows[0].speed * scale});
        return {branches, rows.back().endurance, rows[0].endurance};
      }

      std::pair<double, double> get_length_range(const std::string & /*species*/) const override
      {
        return lengths.get();
      }

      std::string describe(const std::string &species) const override
      {
        return "table of speeds and endurances of " + species + ", " + file +
               (source.empty() ? "" : " (" + source + ")");
      }

    private:
      /** The rows from slow to fast. */
      std::vector<Effort> read(const std::string &path) const
      {
        std::vector<Effort> efforts;
        for (const auto &[u, t] : read_pairs(path, file, speed, endurance))
          efforts.push_back({in_lengths ? u / speed.get_factor() : u, t});
        AssertThrow(efforts.size() >= 2,
                    ExcMessage(path + "/File: " + file + ": there are " +
                               std::to_string(efforts.size()) + " rows. Give two or more."));
        for (std::size_t k = 0; k + 1 < efforts.size(); ++k)
          check_value(efforts[k + 1].endurance < efforts[k].endurance,
                      path + "/File: " + file + ": endurance at " +
                          Patterns::Tools::to_string(efforts[k + 1].speed),
                      efforts[k + 1].endurance, "Give shorter endurances to higher speeds.");
        return efforts;
      }

      std::string file, source;
      Column      speed{"speed", "speed", speed_units, "m/s"};
      Column      endurance{"endurance", "endurance", time_units, "s"};
      bool        in_lengths = false;
      double      spread     = 0.;
      LengthRange lengths;

      mutable std::vector<Effort> rows; // once they were read
    };

    const Registration<EnduranceLaw, EnduranceTable>
        registration("table", "endurances at some speeds from a file");
  } // namespace
} // namespace caudal::passage
