// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/endurance_law.h>
#include <caudal/passage/swim_groups.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace caudal::passage
{
  namespace
  {
    /** U/sqrt(g l) = k (t/sqrt(l/g))^b, with coefficients of groups: see SwimGroup. */
    class KatopodisGervais : public EnduranceLaw
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        durations.add_parameters(prm);
        lengths.add_parameters(prm);
      }

      void check(const std::string &path) const override
      {
        durations.check(path);
        lengths.check(path);
      }

      void check_species(const std::string &species, const std::string &entry) const override
      {
        find_swim_group(species, entry);
      }

      EnduranceCurve make_curve(const Fish &fish) const override
      {
        const SwimGroup &group = find_swim_group(fish.species, "Fish/Species");
        const double     k     = group.k * std::exp(group.compute_spread() * fish.ability);
        const double     speed = std::sqrt(gravity * fish.length);
        const double     time  = std::sqrt(fish.length / gravity);
        // ln t = ln(time) + (ln U - ln(k speed))/b
        const EnduranceBranch branch{std::log(time) - std::log(k * speed) / group.b, 1. / group.b};
        return {{branch}, durations.shortest, durations.longest};
      }

      std::pair<double, double> get_length_range(const std::string & /*species*/) const override
      {
        return lengths.get();
      }

      std::string describe(const std::string &species) const override
      {
        const SwimGroup   &group = find_swim_group(species, "Fish/Species");
        std::ostringstream text;
        text << "U/sqrt(g l) = k (t/sqrt(l/g))^b, group " << group.name << ": k = " << group.k
             << ", b = " << group.b << ", ln k with a standard deviation of "
             << std::setprecision(3) << group.compute_spread() << "; " << durations.describe()
             << " (Katopodis and Gervais 2016, DFO Can. Sci. Advis. Sec. Res. Doc. 2016/002)";
        return text.str();
      }

    private:
      DurationRange durations{3., 1800.};
      // What the authors' online tool (SPOT) offers for all groups.
      LengthRange lengths{0.025, 1.};
    };

    const Registration<EnduranceLaw, KatopodisGervais>
        registration("Katopodis-Gervais", "a power law in dimensionless form for six groups of "
                                          "species, with the spread within the group");
  } // namespace
} // namespace caudal::passage
