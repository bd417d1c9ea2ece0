// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/names.h>
#include <caudal/passage/swim_groups.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>

namespace caudal::passage
{
  using namespace dealii;

  namespace
  {
    struct Species
    {
      std::string  name;
      unsigned int group; // its number in get_swim_groups()
    };

    enum Group
    {
      salmon,
      eel,
      pike,
      herring,
      catfish,
      sturgeon
    };

    const std::vector<Species> &get_species()
    {
      static const std::vector<Species> species{
          {"Atlantic salmon", salmon},   {"Chinook salmon", salmon},
          {"coho salmon", salmon},       {"sockeye salmon", salmon},
          {"pink salmon", salmon},       {"chum salmon", salmon},
          {"rainbow trout", salmon},     {"steelhead", salmon},
          {"cutthroat trout", salmon},   {"brown trout", salmon},
          {"brook trout", salmon},       {"lake trout", salmon},
          {"bull trout", salmon},        {"Arctic char", salmon},
          {"Arctic grayling", salmon},   {"lake whitefish", salmon},
          {"walleye", salmon},           {"American eel", eel},
          {"European eel", eel},         {"northern pike", pike},
          {"alewife", herring},          {"American shad", herring},
          {"Atlantic herring", herring}, {"blueback herring", herring},
          {"channel catfish", catfish},  {"bluegill", catfish},
          {"pumpkinseed", catfish},      {"smallmouth bass", catfish},
          {"largemouth bass", catfish},  {"lake sturgeon", sturgeon},
          {"white sturgeon", sturgeon},  {"shortnose sturgeon", sturgeon}};
      return species;
    }
  } // namespace

  double SwimGroup::compute_spread() const
  {
    const boost::math::normal normal;
    return std::log(upper_k / lower_k) / (2. * quantile(normal, 0.975));
  }

  const std::vector<SwimGroup> &get_swim_groups()
  {
    static const std::vector<SwimGroup> groups{{"Salmon & Walleye", 4.004, -0.250, 2.070, 7.744},
                                               {"Eel", 3.722, -0.367, 2.201, 6.295},
                                               {"Pike", 3.811, -0.329, 2.437, 5.962},
                                               {"Herring", 10.119, -0.402, 8.123, 12.605},
                                               {"Catfish & Sunfish", 2.176, -0.202, 1.424, 3.326},
                                               {"Sturgeon", 0.756, -0.130, 0.562, 1.018}};
    return groups;
  }

  const SwimGroup &find_swim_group(const std::string &species, const std::string &entry)
  {
    const std::vector<SwimGroup> &groups = get_swim_groups();
    std::vector<std::string>      names, group_names;
    for (const SwimGroup &group : groups)
    {
      if (lower(group.name) == lower(species))
        return group;
      group_names.push_back(group.name);
    }
    for (const Species &known : get_species())
    {
      if (lower(known.name) == lower(species))
        return groups[known.group];
      names.push_back(known.name);
    }
    std::vector<std::string> all = group_names;
    all.insert(all.end(), names.begin(), names.end());
    const std::string nearest = find_nearest_name(species, all);
    AssertThrow(false, ExcMessage(entry + ": there is no species or group called <" + species +
                                  ">. The nearest name is <" + nearest + ">, of the group <" +
                                  find_swim_group(nearest, entry).name +
                                  ">. The groups are: " + list_names(group_names) +
                                  "; the species are: " + list_names(names) +
                                  ". Of others give the group that swims alike."));
    return groups[0];
  }
} // namespace caudal::passage
