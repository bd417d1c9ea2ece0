// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/print.h>
#include <caudal/passage/water_source.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <sstream>

namespace caudal::passage
{
  namespace
  {
    /** What flows through a section that is filled up to a depth. */
    struct Section
    {
      double area;      // [m^2]
      double perimeter; // that is wet [m]
    };

    /**
     * Uniform flow in a straight culvert: the normal depth h of each discharge Q by Manning's
     * formula, Q = A (A/P)^(2/3) sqrt(S)/n (Manning 1891), A the wet area, P the wet perimeter, and
     * the mean velocity Q/A. Inlet, outlet and backwater are left out.
     */
    class ChannelSource : public WaterSource
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Section", section, "The shape of the cross-section.",
                          Patterns::Selection("rectangular|circular"));
        prm.add_parameter("Width", width,
                          "Width of a rectangular section, diameter of a circular "
                          "one [m].");
        prm.add_parameter("Length", length, "Length along the bed [m].");
        prm.add_parameter("Slope", slope, "Fall of the bed over its length [1].");
        prm.add_parameter("Manning's n", roughness,
                          "Roughness n [s/m^(1/3)]: concrete 0.012 to 0.015, corrugated metal "
                          "0.022 to 0.027, natural bed 0.03 to 0.05.");
        prm.add_parameter("Discharges", discharges, "Discharges Q, separated by commas [m^3/s].");
      }

      void check(const std::string &path) const override
      {
        check_positive(path + "/Width", width, "Give a positive width or diameter [m].");
        check_positive(path + "/Length", length, "Give a positive length [m].");
        check_value(0. < slope && slope <= 1., path + "/Slope", slope,
                    "Give a number between 0 and 1: 2 % are 0.02.");
        check_between(path + "/Manning's n", roughness, 0.005, 0.5,
                      "Give a roughness between 0.005 and 0.5 s/m^(1/3).");
        AssertThrow(!discharges.empty(),
                    ExcMessage(path + "/Discharges: there is none. Give one or more [m^3/s]."));
        for (const double discharge : discharges)
          check_positive(path + "/Discharges", discharge, "Give positive discharges [m^3/s].");
        make_waterways(path);
      }

      std::vector<Waterway> make_waterways(const std::string &path) const override
      {
        std::vector<Waterway> waterways;
        for (const double discharge : discharges)
        {
          const auto waterway = compute_at_slope(slope, discharge);
          AssertThrow(waterway,
                      ExcMessage(path + "/Discharges: " + print_number(discharge) +
                                 " m^3/s are more than this section carries with a free surface, " +
                                 print_number(compute_discharge(get_fullest(), slope)) +
                                 " m^3/s. Give a smaller discharge, or a profile that was computed "
                                 "elsewhere."));
          for (const WaterPoint &point : waterway->points)
            check_water(path + ": at " + print_number(discharge) + " m^3/s: ", point);
          waterways.push_back(*waterway);
        }
        return waterways;
      }

      bool has_slope() const override
      {
        return true;
      }

      std::optional<Waterway> compute_at_slope(const double new_slope,
                                               const double discharge) const override
      {
        if (discharge > compute_discharge(get_fullest(), new_slope))
          return std::nullopt;
        const double depth    = compute_depth(discharge, new_slope);
        const double velocity = discharge / compute_section(depth).area;
        Waterway     waterway;
        waterway.discharge = discharge;
        waterway.points    = {{0., velocity, depth}, {length, velocity, depth}};
        return waterway;
      }

      std::string describe() const override
      {
        std::ostringstream text;
        text << "uniform flow in a " << section << " culvert of " << width << " m "
             << (is_circular() ? "diameter" : "width") << ", " << length << " m long, slope "
             << slope << ", Manning's n = " << roughness
             << " s/m^(1/3): normal depth by Q = A (A/P)^(2/3) sqrt(S)/n, mean velocity Q/A; no "
                "backwater, no losses at inlet and outlet";
        return text.str();
      }

    private:
      bool is_circular() const
      {
        return section == "circular";
      }

      Section compute_section(const double depth) const
      {
        if (!is_circular())
          return {width * depth, width + 2. * depth};
        const double angle = 2. * std::acos(1. - 2. * depth / width);
        return {width * width / 8. * (angle - std::sin(angle)), 0.5 * angle * width};
      }

      double compute_discharge(const double depth, const double its_slope) const
      {
        const Section wet = compute_section(depth);
        return wet.area * std::pow(wet.area / wet.perimeter, 2. / 3.) * std::sqrt(its_slope) /
               roughness;
      }

      /**
       * The largest depth with a free surface [m]. A pipe carries the most when it is not quite
       * full; from there on the formula has two depths for one discharge.
       */
      double get_fullest() const
      {
        return is_circular() ? 0.938 * width : 1e3 * width;
      }

      double compute_depth(const double discharge, const double its_slope) const
      {
        const auto excess = [&](const double depth) {
          return compute_discharge(depth, its_slope) - discharge;
        };
        boost::uintmax_t iterations = 200;
        const auto       bracket    = boost::math::tools::toms748_solve(
                     excess, 1e-9 * width, get_fullest(), boost::math::tools::eps_tolerance<double>(),
                     iterations);
        return 0.5 * (bracket.first + bracket.second);
      }

      std::string         section = "circular";
      double              width = 1., length = 20., slope = 0.01, roughness = 0.024;
      std::vector<double> discharges{0.1};
    };

    const Registration<WaterSource, ChannelSource>
        registration("channel", "uniform flow in a culvert by Manning's formula, from its drawing");
  } // namespace
} // namespace caudal::passage
