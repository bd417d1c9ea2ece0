// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/elliptic_body.h>
#include <caudal/fish/number_table.h>
#include <caudal/fish/spline.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** Half-axes at a place along the spine [m]. */
    struct Station
    {
      double s, a, b;
    };

    /** ln g through ln(a_i/E(s_i)) for one of the half-axes. */
    Spline make_profile(const std::vector<Station> &stations, const double length,
                        double Station::*axis, const Spline::Kind kind)
    {
      std::vector<double> s, values;
      for (const Station &station : stations)
      {
        s.push_back(station.s);
        values.push_back(std::log(station.*axis / EllipticBody::get_end_factor(station.s, length)));
      }
      return Spline(s, values, kind);
    }

    /**
     * A body through half-axes a_i, b_i at stations s_i: g_a = exp(p(s)) with p the Spline
     * through ln(a_i/E(s_i)), and g_b likewise. It has round ends, is positive and, if the
     * profile is limited, without bulges between the stations.
     */
    class StationBody : public EllipticBody
    {
    public:
      StationBody(const std::vector<Station> &stations, const double length,
                  const Spline::Kind kind)
          : EllipticBody(length)
          , log_ga(make_profile(stations, length, &Station::a, kind))
          , log_gb(make_profile(stations, length, &Station::b, kind))
      {}

    private:
      std::pair<double, double> get_scales(const double s) const override
      {
        return {std::exp(log_ga.evaluate(s).first), std::exp(log_gb.evaluate(s).first)};
      }

      const Spline log_ga, log_gb;
    };

    template <int dim>
    class StationsShape : public EllipticShape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Table", table,
                          "Rows `s/L, a, b` separated by ';': position along the spine from the "
                          "nose (0 < s/L < 1 [1]), half-width and half-height [m].",
                          Patterns::Anything());
        prm.add_parameter("Table length", table_length,
                          "Length of the fish that has these half-axes [m]: those of a fish of "
                          "another Shape/Length are in proportion. 0: they are as given, whatever "
                          "the length.");
        prm.add_parameter("File", file,
                          "A text file with these rows, instead of them; a row of names may come "
                          "first.",
                          Patterns::FileName(Patterns::FileName::input));
        prm.add_parameter("Interpolation", interpolation,
                          "Between the stations, of the logarithms of the half-axes over those of "
                          "a round body: 'spline', the natural cubic spline, which may overshoot; "
                          "'limited', the same without bulges or necks that no station has.",
                          Patterns::Selection("limited|spline"));
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Table length", table_length,
                           "Give the length of the fish that was measured [m], or 0.");
        read(path, 1.);
      }

      void check_lengths(const ShapeLengths &lengths, const std::string &path) const override
      {
        require_positive(lengths.length, path, "Length");
      }

      std::unique_ptr<StraightBody> make_straight_body(const ShapeLengths &lengths) const override
      {
        return std::make_unique<StationBody>(read("Shape/Stations", lengths.length), lengths.length,
                                             interpolation == "limited" ? Spline::Kind::limited
                                                                        : Spline::Kind::natural);
      }

    private:
      /** The stations of a body of this length. */
      std::vector<Station> read(const std::string &path, const double length) const
      {
        const std::string entry = path + (file.empty() ? "/Table" : "/File");
        AssertThrow(
            file.empty() != table.empty(),
            ExcMessage(path + "/Table: give the stations either here or in " + path + "/File."));
        const NumberTable numbers =
            file.empty() ? parse_number_table(entry, table, 3) : read_number_table(entry, file, 3);
        AssertThrow(numbers.rows.size() >= 3,
                    ExcMessage(entry + ": there are " + std::to_string(numbers.rows.size()) +
                               " stations. Give at least three."));
        std::vector<Station> stations;
        for (const auto &row : numbers.rows)
        {
          const double s = row.values[0], a = row.values[1], b = row.values[2];
          const auto   complain = [&](const std::string &text) {
            return ExcMessage(entry + ": station " + std::to_string(stations.size() + 1) + " " +
                                text);
          };
          AssertThrow(s > 0. && s < 1., complain("is at s/L = " + Patterns::Tools::to_string(s) +
                                                 ". Give positions between 0 and 1: the ends are "
                                                 "round."));
          AssertThrow(stations.empty() || s * length > stations.back().s,
                      complain("at s/L = " + Patterns::Tools::to_string(s) +
                               " does not lie behind the one before it. Sort the stations from "
                               "head to tail."));
          AssertThrow(a > 0. && b > 0.,
                      complain("has the half-axes " + Patterns::Tools::to_string(a) + " and " +
                               Patterns::Tools::to_string(b) + " m. Give positive ones."));
          const double scale = table_length > 0. ? length / table_length : 1.;
          stations.push_back({s * length, scale * a, scale * b});
        }
        return stations;
      }

      double      table_length = 0.;
      std::string table, file;
      std::string interpolation = "limited";
    };

    const DimensionalRegistration<Shape, StationsShape>
        registration("stations", "elliptic sections at stations along the spine (2D: the outline "
                                 "of their half-widths)");
  } // namespace
} // namespace caudal
