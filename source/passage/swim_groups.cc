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
      std::string  name, scientific_name;
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
          {"Atlantic salmon", "Salmo salar", salmon},
          {"Chinook salmon", "Oncorhynchus tshawytscha", salmon},
          {"coho salmon", "Oncorhynchus kisutch", salmon},
          {"sockeye salmon", "Oncorhynchus nerka", salmon},
          {"pink salmon", "Oncorhynchus gorbuscha", salmon},
          {"chum salmon", "Oncorhynchus keta", salmon},
          {"rainbow trout", "Oncorhynchus mykiss", salmon},
          {"steelhead", "Oncorhynchus mykiss", salmon},
          {"cutthroat trout", "Oncorhynchus clarkii", salmon},
          {"brown trout", "Salmo trutta", salmon},
          {"brook trout", "Salvelinus fontinalis", salmon},
          {"lake trout", "Salvelinus namaycush", salmon},
          {"bull trout", "Salvelinus confluentus", salmon},
          {"Arctic char", "Salvelinus alpinus", salmon},
          {"Arctic grayling", "Thymallus arcticus", salmon},
          {"lake whitefish", "Coregonus clupeaformis", salmon},
          {"walleye", "Sander vitreus", salmon},
          {"American eel", "Anguilla rostrata", eel},
          {"European eel", "Anguilla anguilla", eel},
          {"northern pike", "Esox lucius", pike},
          {"alewife", "Alosa pseudoharengus", herring},
          {"American shad", "Alosa sapidissima", herring},
          {"Atlantic herring", "Clupea harengus", herring},
          {"blueback herring", "Alosa aestivalis", herring},
          {"channel catfish", "Ictalurus punctatus", catfish},
          {"bluegill", "Lepomis macrochirus", catfish},
          {"pumpkinseed", "Lepomis gibbosus", catfish},
          {"smallmouth bass", "Micropterus dolomieu", catfish},
          {"largemouth bass", "Micropterus salmoides", catfish},
          {"lake sturgeon", "Acipenser fulvescens", sturgeon},
          {"white sturgeon", "Acipenser transmontanus", sturgeon},
          {"shortnose sturgeon", "Acipenser brevirostrum", sturgeon}};
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
      if (lower(known.name) == lower(species) || lower(known.scientific_name) == lower(species))
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
