// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/question.h>
#include <caudal/passage/threshold.h>

#include <boost/math/distributions/normal.hpp>

namespace caudal::passage
{
  namespace
  {
    const double largest_ability = 6.; // a fish in a thousand million is better
    const int    n_bits          = 30; // of it: the share is right to 1e-8
  }                                    // namespace

  Ascent Question::ascend(const Waterway &waterway, const double length, const double ability,
                          const AscentOptions &options) const
  {
    const EnduranceCurve curve = law.make_curve({population.species, length, ability});
    return strategy.ascend(waterway, curve, population.needs, options);
  }

  bool Question::passes(const Waterway &waterway, const double length, const double ability) const
  {
    return ascend(waterway, length, ability).passes();
  }

  double Question::compute_share(const Waterway &waterway, const double length) const
  {
    const auto ability = find_threshold([&](const double z) { return passes(waterway, length, z); },
                                        -largest_ability, largest_ability, n_bits);
    if (!ability)
      return 0.;
    if (*ability == -largest_ability)
      return 1.;
    return cdf(complement(boost::math::normal(), *ability));
  }

  double Question::compute_share(const Waterway &waterway) const
  {
    double share = 0.;
    for (const LengthClass &length_class : population.make_classes())
      share += length_class.share * compute_share(waterway, length_class.length);
    return share;
  }
} // namespace caudal::passage
