// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/column.h>
#include <caudal/passage/print.h>
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
                          "In which order the rows stand: 'upstream', as the fish "
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
        std::vector<Row> all = file.empty() ? parse(path) : read(path);
        if (rows == "downstream")
          std::reverse(all.begin(), all.end());
        std::map<double, Waterway> by_discharge;
        for (const Row &row : all)
        {
          Waterway &waterway  = by_discharge[row.discharge];
          waterway.discharge  = row.discharge;
          waterway.has_depths = row.has_depth;
          add(waterway.points, row);
        }
        check_ends(path, by_discharge);
        std::vector<Waterway> waterways;
        for (auto &named : by_discharge)
        {
          auto        &points = named.second.points;
          const double start  = points.front().distance;
          for (WaterPoint &point : points)
            point.distance = std::abs(point.distance - start);
          waterways.push_back(named.second);
        }
        return waterways;
      }

      std::string describe() const override
      {
        return file.empty() ? "given profile" : "profile from the file " + file;
      }

    private:
      /** A row of the table in SI units. */
      struct Row
      {
        WaterPoint  point;
        double      discharge;
        bool        has_depth;
        std::string place;
      };

      std::vector<Row> parse(const std::string &path) const
      {
        std::vector<Row> result;
        for (const auto &row : parse_number_table(path + "/Table", table_text, 3).rows)
          result.push_back({{row.values[0], row.values[1], row.values[2]}, 0., true, row.place});
        return result;
      }

      std::vector<Row> read(const std::string &path) const
      {
        TextTable table = read_text_table(path + "/File", file);
        AssertThrow(!table.header.empty() && !table.rows.empty(),
                    ExcMessage(path + "/File: " + file +
                               ": there is no header, or no row below it. The first row has to "
                               "name the columns."));
        move_units_to_header(table);
        const std::size_t s = distance.require(table, path), v = velocity.require(table, path);
        const auto        d = depth.find_optional(table, path);
        const auto        q = discharge.find_optional(table, path);
        std::vector<Row>  result;
        for (const TextTable::Row &row : table.rows)
        {
          result.push_back(
              {{distance.read(row, s), velocity.read(row, v), d ? depth.read(row, *d) : 0.},
               q ? discharge.read(row, *q) : 0.,
               d.has_value(),
               row.place});
          check_not_negative(row.place + "discharge [m^3/s]", result.back().discharge);
        }
        return result;
      }

      /** Each discharge has a way, and not only its part of one. */
      void check_ends(const std::string &path, const std::map<double, Waterway> &by_discharge) const
      {
        const std::string entry = path + (file.empty() ? "/Table" : "/File: " + file) + ": ";
        const auto       &first = *by_discharge.begin();
        const auto        print = [](const std::pair<const double, Waterway> &way) {
          return print_number(way.first) + " m^3/s reach from " +
                 print_number(way.second.points.front().distance) + " m to " +
                 print_number(way.second.points.back().distance) + " m";
        };
        for (const auto &way : by_discharge)
        {
          const double begin = way.second.points.front().distance,
                       end   = way.second.points.back().distance;
          AssertThrow(begin != end,
                      ExcMessage(entry +
                                 "a profile has a single place only. Give its velocities from "
                                 "the entrance to the exit, two rows or more for each discharge."));
          const auto [low, high]             = std::minmax(begin, end);
          const auto [first_low, first_high] = std::minmax(first.second.points.front().distance,
                                                           first.second.points.back().distance);
          AssertThrow(low < first_high && first_low < high,
                      ExcMessage(entry + "the rows of " + print(first) + " and those of " +
                                 print(way) +
                                 ": does the discharge change along the way? Give all places for "
                                 "each discharge, or an empty " +
                                 path + "/Column of discharge to take all rows as one way."));
        }
      }

      /**
       * Appends a point. Distances grow on the way of the fish, but those of rows that follow the
       * water may also count from its side.
       */
      void add(std::vector<WaterPoint> &points, const Row &row) const
      {
        check_water(row.place, row.point);
        if (!points.empty())
        {
          const double step      = row.point.distance - points.back().distance;
          const double direction = points.back().distance - points.front().distance;
          AssertThrow(rows == "upstream" ? step >= 0. : step * direction >= 0.,
                      ExcMessage(row.place + "the distance " +
                                 Patterns::Tools::to_string(row.point.distance) +
                                 " m comes next to " +
                                 Patterns::Tools::to_string(points.back().distance) +
                                 " m: the profile is out of order. Sort the rows by distance, or "
                                 "give Passage/Profile/Rows = downstream if they follow the "
                                 "water" +
                                 (file.empty() ? "."
                                               : ", or Passage/Profile/Column of discharge if "
                                                 "there are several.")));
        }
        points.push_back(row.point);
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
