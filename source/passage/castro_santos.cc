// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/endurance_law.h>
#include <caudal/passage/names.h>

#include <sstream>

namespace caudal::passage
{
  namespace
  {
    /** ln T = intercept + slope U/l [lengths/s] of one mode of swimming. */
    struct Mode
    {
      double intercept, slope;

      void add_parameters(ParameterHandler &prm, const std::string &name)
      {
        prm.add_parameter(
            name + " intercept", intercept,
            "a in ln T = a + b U/l of the mode, T in s, U/l in lengths a second [1].");
        prm.add_parameter(name + " slope", slope, "b of it [s].");
      }

      void check(const std::string &path) const
      {
        check_value(slope < 0., path + " slope", slope,
                    "Give a negative one: faster fish tire sooner.");
        check_finite(path + " intercept", intercept);
      }

      EnduranceBranch make_branch(const double length, const double shift) const
      {
        return {intercept + shift, slope / length, true};
      }
    };

    /**
     * ln T = a + b U/l in two modes, prolonged and sprint, of which the one counts that lasts
     * longer (Castro-Santos 2005, J. Exp. Biol. 208, 421-432, doi:10.1242/jeb.01380). The preset
     * are the coefficients of the American shad.
     */
    class CastroSantos : public EnduranceLaw
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Species", species,
                          "Whose coefficients these are: the name that Fish/Species has to give.");
        prolonged.add_parameters(prm, "Prolonged");
        sprint.add_parameters(prm, "Sprint");
        prm.add_parameter("Spread", spread,
                          "Standard deviation of ln T among fish [1]; 0: not known, all bands are "
                          "that of the median.");
        durations.add_parameters(prm);
        lengths.add_parameters(prm);
      }

      void check(const std::string &path) const override
      {
        prolonged.check(path + "/Prolonged");
        sprint.check(path + "/Sprint");
        check_not_negative(path + "/Spread", spread);
        durations.check(path);
        lengths.check(path);
      }

      void check_species(const std::string &name, const std::string &entry) const override
      {
        AssertThrow(lower(name) == lower(species),
                    ExcMessage(entry + ": the value is <" + name +
                               ">, and the coefficients of the law Castro-Santos are those of <" +
                               species +
                               ">. Give that species, or other coefficients and "
                               "Endurance/Castro-Santos/Species."));
      }

      EnduranceCurve make_curve(const Fish &fish) const override
      {
        const double shift = spread * fish.ability;
        return {{prolonged.make_branch(fish.length, shift), sprint.make_branch(fish.length, shift)},
                durations.shortest,
                durations.longest};
      }

      std::pair<double, double> get_length_range(const std::string & /*species*/) const override
      {
        return lengths.get();
      }

      std::string describe(const std::string &name) const override
      {
        std::ostringstream text;
        text << "ln T = a + b U/l, " << name << ": prolonged a = " << prolonged.intercept
             << ", b = " << prolonged.slope << " s, sprint a = " << sprint.intercept
             << ", b = " << sprint.slope << " s; ln T with a standard deviation of " << spread
             << "; " << durations.describe() << " (Castro-Santos 2005, doi:10.1242/jeb.01380)";
        return text.str();
      }

    private:
      std::string   species = "American shad";
      Mode          prolonged{10.7, -1.0}, sprint{6.16, -0.33};
      double        spread = 0.;
      DurationRange durations{3., 1800.};
      LengthRange   lengths;
    };

    const Registration<EnduranceLaw, CastroSantos>
        registration("Castro-Santos",
                     "exponential in the speed in lengths a second, in a prolonged "
                     "and a sprint mode");
  } // namespace
} // namespace caudal::passage
