// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/column.h>
#include <caudal/passage/water_source.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace caudal::passage
{
  namespace
  {
    /**
     * A longitudinal profile from a table, as HEC-RAS and others export it, or from the entry
     * `Table`. It may hold several discharges.
     */
    class ProfileSource : public WaterSource
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("File", file,
                          "A table with a header, as spreadsheets and HEC-RAS export it; columns "
                          "that are not named here are ignored.",
                          Patterns::FileName(Patterns::FileName::input));
        prm.add_parameter("Table", table_text,
                          "Instead of a file: rows of distance [m], velocity [m/s] and depth [m], "
                          "separated by semicolons. A second row at the same distance is a jump.",
                          Patterns::Anything());
        distance.add_parameters(prm);
        velocity.add_parameters(prm);
        depth.add_parameters(prm);
        discharge.add_parameters(prm);
        prm.add_parameter("Rows", rows,
                          "In which order the rows of a file stand: 'upstream', as the fish "
                          "swims, with distances that grow; 'downstream', as the water flows.",
                          Patterns::Selection("upstream|downstream"));
      }

      void check(const std::string &path) const override
      {
        AssertThrow(file.empty() != table_text.empty(),
                    ExcMessage(path + "/File, Table: " + (file.empty() ? "none" : "both") +
                               " of them is given. Give one."));
        make_waterways(path);
      }

      std::vector<Waterway> make_waterways(const std::string &path) const override
      {
        std::vector<Waterway> waterways = file.empty() ? parse(path) : read(path);
        for (const Waterway &waterway : waterways)
          AssertThrow(waterway.points.size() > 1 && waterway.get_length() > 0.,
                      ExcMessage(path + (file.empty() ? "/Table" : "/File: " + file) +
                                 ": a profile has a single place only. Give its velocities from "
                                 "the entrance to the exit, two rows or more for each discharge."));
        return waterways;
      }

      std::string describe() const override
      {
        return file.empty() ? "given profile" : "profile from the file " + file;
      }

    private:
      std::vector<Waterway> parse(const std::string &path) const
      {
        const NumberTable table = parse_number_table(path + "/Table", table_text, 3);
        Waterway          waterway;
        for (const NumberTable::Row &row : table.rows)
          add(waterway, {row.values[0], row.values[1], row.values[2]}, row.place);
        shift_to_start(waterway);
        return {waterway};
      }

      std::vector<Waterway> read(const std::string &path) const
      {
        TextTable table = read_text_table(path + "/File", file);
        AssertThrow(!table.header.empty() && !table.rows.empty(),
                    ExcMessage(path + "/File: " + file +
                               ": there is no header, or no row below it. The first row has to "
                               "name the columns."));
        remove_row_of_units(table);
        const std::size_t s = distance.require(table, path), v = velocity.require(table, path);
        const auto        d = depth.find(table, path), q = discharge.find(table, path);
        if (rows == "downstream")
          std::reverse(table.rows.begin(), table.rows.end());

        std::map<double, Waterway> by_discharge;
        for (const TextTable::Row &row : table.rows)
        {
          const double flow      = q ? discharge.read(row, *q) : 0.;
          Waterway    &waterway  = by_discharge[flow];
          waterway.discharge     = flow;
          waterway.has_depths    = d.has_value();
          const WaterPoint point = {distance.read(row, s), velocity.read(row, v),
                                    d ? depth.read(row, *d) : 0.};
          add(waterway, point, row.place);
        }
        std::vector<Waterway> waterways;
        for (auto &[flow, waterway] : by_discharge)
        {
          check_not_negative(path + "/File: " + file + ": discharge [m^3/s]", flow);
          shift_to_start(waterway);
          waterways.push_back(waterway);
        }
        return waterways;
      }

      /** Appends a point; distances grow, or fall in all rows. */
      void add(Waterway &waterway, const WaterPoint &point, const std::string &place) const
      {
        check_water(place, point);
        auto &points = waterway.points;
        if (points.size() > 1)
        {
          const double direction = points.back().distance - points.front().distance;
          const bool   turns     = direction * (point.distance - points.back().distance) < 0.;
          AssertThrow(!turns && (rows == "downstream" || direction >= 0.),
                      ExcMessage(place + "the distance " +
                                 Patterns::Tools::to_string(point.distance) + " m comes after " +
                                 Patterns::Tools::to_string(points.back().distance) +
                                 " m: the profile is out of order. Sort the rows by distance, or "
                                 "give Passage/Profile/Rows = downstream if they follow the "
                                 "water."));
        }
        points.push_back(point);
      }

      /** Counts distances from the first point. */
      void shift_to_start(Waterway &waterway) const
      {
        const double start = waterway.points.front().distance;
        AssertThrow(
            rows == "downstream" || waterway.points.back().distance >= start,
            ExcMessage("Passage/Profile: the distances fall from row to row: the profile is "
                       "out of order. Give Passage/Profile/Rows = downstream if the rows "
                       "follow the water."));
        for (WaterPoint &point : waterway.points)
          point.distance = std::abs(point.distance - start);
      }

      std::string file, table_text, rows = "upstream";
      Column      distance{"distance", "distance", length_units, "m"};
      Column      velocity{"velocity", "velocity", speed_units, "m/s"};
      Column      depth{"depth", "depth", length_units, "m"};
      Column      discharge{"discharge", "discharge", discharge_units, "m^3/s"};
    };

    const Registration<WaterSource, ProfileSource>
        registration("profile", "velocities and depths at distances along the way");
  } // namespace
} // namespace caudal::passage
