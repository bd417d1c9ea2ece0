// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/endurance_law.h>
#include <caudal/passage/names.h>
#include <caudal/passage/print.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace caudal::passage
{
  namespace
  {
    /** U = a L^b t^-c in m and s; a of 0: there is none. */
    struct Regression
    {
      double a, b, c;

      bool exists() const
      {
        return a > 0.;
      }

      EnduranceBranch make_branch(const double length, const double shift) const
      {
        return {(std::log(a) + b * std::log(length) + shift) / c, -1. / c};
      }

      void add_parameters(ParameterHandler &prm, const std::string &name)
      {
        const std::string of_mode = " of the " + lower(name) + " mode";
        prm.add_parameter(name + " coefficient", a,
                          "a in U = a L^b t^-c" + of_mode +
                              ", in m and s, of a species that is not "
                              "known; 0: there is no such mode.");
        prm.add_parameter(name + " exponent of length", b, "b of it [1].");
        prm.add_parameter(name + " exponent of time", c, "c of it [1].");
      }

      void check(const std::string &path) const
      {
        check_not_negative(path + " coefficient", a);
        check_finite(path + " exponent of length", b);
        if (exists())
          check_value(0. < c && c < 1., path + " exponent of time", c,
                      "Give a number between 0 and 1.");
      }

      std::string describe() const
      {
        std::ostringstream text;
        text << "a = " << a << ", b = " << b << ", c = " << c;
        return text.str();
      }
    };

    /** Regressions of a species; lengths in m. */
    struct SpeciesData
    {
      std::string name;
      Regression  burst, prolonged;
      LengthRange lengths;
    };

    const Regression none{0., 0., 0.};

    const std::vector<SpeciesData> &get_species()
    {
      static const std::vector<SpeciesData> species{
          {"rainbow trout", {7.16, 0.77, 0.46}, none, {}},
          {"steelhead", {12.81, 1.07, 0.48}, none, {0.10, 0.81}},
          {"large steelhead", {12.30, 0.62, 0.51}, none, {0.61, 0.81}},
          {"coho salmon", {13.3, 0.52, 0.65}, {3.02, 0.52, 0.1}, {}},
          {"sockeye salmon", none, {5.47, 0.89, 0.07}, {}},
          {"pink salmon", none, {4.08, 0.55, 0.08}, {}}};
      return species;
    }

    /** U = a L^b t^-c (Hunter and Mayor 1986), with the species that FishXing 3 lists. */
    class HunterMayor : public EnduranceLaw
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Species", own.name,
                          "Whose coefficients the next six are: the name that Fish/Species gives. "
                          "Empty: of none, only the known species are there.");
        own.burst.add_parameters(prm, "Burst");
        own.prolonged.add_parameters(prm, "Prolonged");
        prm.add_parameter("Spread", spread,
                          "Standard deviation of ln U among fish [1]; 0: not known, all bands are "
                          "that of the median.");
        durations.add_parameters(prm);
        own.lengths.add_parameters(prm);
      }

      void check(const std::string &path) const override
      {
        own.burst.check(path + "/Burst");
        own.prolonged.check(path + "/Prolonged");
        AssertThrow(own.name.empty() || own.burst.exists() || own.prolonged.exists(),
                    ExcMessage(path + "/Species: <" + own.name +
                               "> has no coefficients. Give Burst coefficient, Prolonged "
                               "coefficient, or both."));
        check_not_negative(path + "/Spread", spread);
        durations.check(path);
        own.lengths.check(path);
      }

      void check_species(const std::string &name, const std::string &entry) const override
      {
        find(name, entry);
      }

      EnduranceCurve make_curve(const Fish &fish) const override
      {
        const SpeciesData           &data = find(fish.species);
        std::vector<EnduranceBranch> branches;
        for (const Regression *regression : {&data.prolonged, &data.burst})
          if (regression->exists())
            branches.push_back(regression->make_branch(fish.length, spread * fish.ability));
        return {branches, durations.shortest, durations.longest};
      }

      std::pair<double, double> get_length_range(const std::string &name) const override
      {
        return find(name).lengths.get();
      }

      std::string describe(const std::string &name) const override
      {
        const SpeciesData &data = find(name);
        std::string        text = "U = a L^b t^-c [m, s], " + data.name;
        if (data.burst.exists())
          text += ", burst: " + data.burst.describe();
        if (data.prolonged.exists())
          text += ", prolonged: " + data.prolonged.describe();
        return text + "; ln U with a standard deviation of " + print_number(spread) + "; " +
               durations.describe() +
               " (Hunter and Mayor 1986, Analysis of fish swimming performance data; species of "
               "FishXing 3, Furniss et al. 2006)";
      }

    private:
      const SpeciesData &find(const std::string &name,
                              const std::string &entry = "Fish/Species") const
      {
        if (!own.name.empty() && lower(own.name) == lower(name))
          return own;
        std::vector<std::string> names;
        for (const SpeciesData &data : get_species())
        {
          if (lower(data.name) == lower(name))
            return data;
          names.push_back(data.name);
        }
        if (!own.name.empty())
          names.push_back(own.name);
        AssertThrow(
            false, ExcMessage(entry + ": the law Hunter-Mayor does not know <" + name +
                              ">. The nearest name is <" + find_nearest_name(name, names) +
                              ">; it knows: " + list_names(names) +
                              ". Of others give coefficients and Endurance/Hunter-Mayor/Species."));
        return own;
      }

      SpeciesData   own{"", none, none, {}};
      double        spread = 0.;
      DurationRange durations{3., 1800.};
    };

    const Registration<EnduranceLaw, HunterMayor>
        registration("Hunter-Mayor", "a power law of length and time for some species, in a "
                                     "prolonged and a burst mode, as FishXing has it");
  } // namespace
} // namespace caudal::passage
