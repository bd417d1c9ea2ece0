// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/number_table.h>
#include <caudal/passage/power_curve.h>
#include <caudal/passage/print.h>

#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <filesystem>

namespace caudal::passage
{
  namespace
  {
    /**
     * The power of a fish that Caudal has swum: of the immersed model the muscle power at the speed
     * of its steady beats (swim.json), of the ideal one the mean positive power of the joints at
     * each frequency (summary.csv).
     */
    class PowerOfRun : public PowerCurve
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Power curve", folder,
                          "Folder of the results of a run of Caudal: output/salmon.",
                          Patterns::Anything());
        prm.add_parameter("Height", height,
                          "Height of the fish's body [m], by which the power of a run in two "
                          "dimensions, which is that of a metre, is multiplied.");
      }

      void check(const std::string &path) const override
      {
        AssertThrow(!folder.empty(), ExcMessage(path + "/Power curve: there is none. Give the "
                                                       "folder of the results of a run."));
        check_not_negative(path + "/Height", height, "Give a height [m].");
        read(path);
      }

      Power make_power(const double /*length*/) const override
      {
        return {interpolate_power(read("Energy/Run").points), 0.};
      }

      std::string describe() const override
      {
        const Data  data = read("Energy/Run");
        std::string text = data.meaning + " of the run in " + folder + ", a fish of " +
                           print_number(data.length) + " m at ";
        for (const PowerPoint &point : data.points)
          text += (&point == &data.points[0] ? "" : ", ") + print_number(point.speed);
        return text + " m/s; beyond in proportion to U^3, and not scaled to other lengths";
      }

    private:
      struct Data
      {
        std::vector<PowerPoint> points;
        double                  length; // of the fish [m]
        std::string             meaning;
      };

      Data read(const std::string &path) const
      {
        const std::string entry = path + "/Power curve";
        Data              data;
        if (std::filesystem::exists(folder + "/swim.json"))
          data = read_immersed(entry, path);
        else
        {
          AssertThrow(std::filesystem::exists(folder + "/summary.csv"),
                      ExcMessage(entry + ": the folder <" + folder +
                                 "> has neither swim.json nor summary.csv. Give the folder of a "
                                 "run of one fish that has come to its end."));
          data = read_ideal(entry);
        }
        for (const PowerPoint &point : data.points)
          AssertThrow(point.speed > 0. && point.power > 0.,
                      ExcMessage(entry + ": in the run in <" + folder + "> the speed is " +
                                 print_number(point.speed) + " m/s and the power " +
                                 print_number(point.power) +
                                 " W. Give a run whose fish swims, and with power."));
        return data;
      }

      boost::property_tree::ptree read_json(const std::string &entry, const std::string &name) const
      {
        boost::property_tree::ptree tree;
        std::string                 error;
        try
        {
          boost::property_tree::read_json(folder + "/" + name, tree);
        }
        catch (const std::exception &exception)
        {
          error = exception.what();
        }
        AssertThrow(error.empty(), ExcMessage(entry + ": " + error +
                                              ". Give the folder of a run that has come to its "
                                              "end."));
        return tree;
      }

      /** A number in a tree, by the names that lead to it, which may have points and blanks. */
      static double get(const boost::property_tree::ptree &tree, const std::string &names,
                        const std::string &entry)
      {
        const auto value =
            tree.get_optional<double>(boost::property_tree::ptree::path_type(names, '/'));
        AssertThrow(value, ExcMessage(entry + ": the run's results have no <" + names +
                                      ">. Give the folder of a run that has come to its end."));
        return *value;
      }

      Data read_immersed(const std::string &entry, const std::string &path) const
      {
        const auto tree  = read_json(entry, "swim.json");
        const auto beats = tree.get_child_optional("beats");
        AssertThrow(beats && !beats->empty(),
                    ExcMessage(entry + ": the fish in <" + folder +
                               "> has made no whole beat. Let it swim longer."));
        const auto  steady    = tree.get_child_optional("mean of steady beats");
        const bool  is_steady = steady && !steady->empty();
        const auto &beat      = is_steady ? *steady : beats->back().second;
        const bool  is_plane  = tree.get("per metre of span", true);
        AssertThrow(!is_plane || height > 0.,
                    ExcMessage(path + "/Height: the run in <" + folder +
                               "> is in two dimensions: its power is that of a metre. Give the "
                               "height of the fish's body [m]."));
        return {{{get(beat, "speed", entry), (is_plane ? height : 1.) * get(beat, "power", entry)}},
                get(tree, "constants/length/value", entry),
                std::string("muscle power against an elastic, viscous model of the fish") +
                    (is_plane ? " in two dimensions" : "") +
                    (is_steady ? "" : ", whose beats are not steady yet")};
      }

      Data read_ideal(const std::string &entry) const
      {
        const TextTable table = read_text_table(entry, folder + "/summary.csv");
        const auto      find  = [&](const std::string &name) {
          const auto found = std::find(table.header.begin(), table.header.end(), name);
          AssertThrow(found != table.header.end(),
                            ExcMessage(entry + ": summary.csv in <" + folder + "> has no column <" +
                                       name + ">. Give a run with Integration/Torques = true."));
          return static_cast<std::size_t>(found - table.header.begin());
        };
        const std::size_t u = find("mean speed [cm/s]"), p = find("mean positive power [W]");
        const auto        tree = read_json(entry, "summary.json");
        Data              data{{},
                  get(tree, "constants/length/value", entry),
                  "mean positive power of the joints in an ideal fluid, without drag and wake,"};
        for (const TextTable::Row &row : table.rows)
          data.points.push_back({0.01 * parse_number(row.fields.at(u), row.place),
                                 parse_number(row.fields.at(p), row.place)});
        std::sort(data.points.begin(), data.points.end(),
                  [](const PowerPoint &a, const PowerPoint &b) { return a.speed < b.speed; });
        return data;
      }

      std::string folder;
      double      height = 0.;
    };

    const Registration<PowerCurve, PowerOfRun> registration("run",
                                                            "of a fish that Caudal has swum");
  } // namespace
} // namespace caudal::passage
