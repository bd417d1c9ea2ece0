// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_swim_groups_h
#define caudal_passage_swim_groups_h

#include <string>
#include <vector>

namespace caudal::passage
{
  /**
   * A group of species that swim alike: U/sqrt(g l) = k (t/sqrt(l/g))^b for fish of length l. Of
   * the single fish k is lognormally distributed; the band holds 95 % of them. Katopodis and
   * Gervais 2016, Fish swimming performance database and analyses, DFO Can. Sci. Advis. Sec. Res.
   * Doc. 2016/002.
   */
  struct SwimGroup
  {
    std::string name;
    double      k, b;
    double      lower_k, upper_k; // the limits of the 95 % band

    /** The standard deviation of ln k. */
    double compute_spread() const;
  };

  const std::vector<SwimGroup> &get_swim_groups();

  /**
   * The group of a species, or of that name. The groups' species are assigned by their families:
   * the report of 2016 decides. Throws a sentence with the known names and the nearest one, which
   * begins with @p entry, if there is none.
   */
  const SwimGroup &find_swim_group(const std::string &species, const std::string &entry);
} // namespace caudal::passage

#endif
