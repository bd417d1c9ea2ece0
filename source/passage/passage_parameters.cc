// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/number_table.h>
#include <caudal/passage/passage_parameters.h>

#include <algorithm>

namespace caudal
{
  using namespace passage;

  namespace
  {
    /** Rows of an entry, sorted by distance, which is the first of their numbers. */
    std::vector<NumberTable::Row> parse_places(const std::string &entry, const std::string &text,
                                               const double length)
    {
      if (text.empty())
        return {};
      std::vector<NumberTable::Row> rows = parse_number_table(entry, text, 0).rows;
      for (const NumberTable::Row &row : rows)
        check_between(row.place + "distance", row.values[0], 0., length,
                      "Give a place on the way, which is " + Patterns::Tools::to_string(length) +
                          " m long.");
      std::stable_sort(rows.begin(), rows.end(),
                       [](const auto &a, const auto &b) { return a.values[0] < b.values[0]; });
      return rows;
    }

    void check_size(const NumberTable::Row &row, const std::size_t smallest,
                    const std::size_t largest, const std::string &wanted)
    {
      AssertThrow(smallest <= row.values.size() && row.values.size() <= largest,
                  ExcMessage(row.place + "there are " + std::to_string(row.values.size()) +
                             " numbers. Give " + wanted + "."));
    }
  } // namespace

  void WayParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Passage");
    source.add_parameters(prm);
    prm.add_parameter("Velocity factor", velocity_factor,
                      "Velocity in the part of the section that the fish use, over that of the "
                      "source [1]: 1 for the mean velocity, less if they keep to bed and walls.");
    prm.add_parameter(
        "Drops", drops_text,
        "Steps of the water surface: rows of distance [m] and height h [m], separated "
        "by semicolons. They are leapt; with a third number, the length of the jet "
        "[m], they are slots and swum through, against sqrt(2 g h).",
        Patterns::Anything());
    prm.add_parameter("Rests", rests_text,
                      "Pools where the fish rests: rows of distance [m] and the share of its "
                      "fatigue that it loses there [1], separated by semicolons.",
                      Patterns::Anything());
    prm.add_parameter("Rest spacing", rest_spacing,
                      "Distance between pools where the fish recovers wholly [m]; 0: there are "
                      "none.");
    prm.leave_subsection();
  }

  void WayParameters::check() const
  {
    source.check("Passage");
    check_value(0. < velocity_factor && velocity_factor <= 2., "Passage/Velocity factor",
                velocity_factor, "Give a number above 0 and up to 2, mostly below 1.");
    check_not_negative("Passage/Rest spacing", rest_spacing, "Give a distance, or 0 [m].");
    for (const Waterway &waterway : make_waterways())
      check_value(rest_spacing == 0. || waterway.get_length() < 1e4 * rest_spacing,
                  "Passage/Rest spacing", rest_spacing, "Give a longer one [m].");
  }

  Waterway WayParameters::complete(const Waterway &water) const
  {
    Waterway waterway = water.scale_velocities(velocity_factor);
    for (const auto &row : parse_places("Passage/Drops", drops_text, waterway.get_length()))
    {
      check_size(row, 2, 3, "distance, height and, for a slot, its length");
      check_positive(row.place + "height", row.values[1], "Give a positive height [m].");
      const double length = row.values.size() > 2 ? row.values[2] : 0.;
      check_not_negative(row.place + "length of the jet", length);
      waterway.drops.push_back({row.values[0], row.values[1], length});
    }
    for (const auto &row : parse_places("Passage/Rests", rests_text, waterway.get_length()))
    {
      check_size(row, 2, 2, "distance and recovery");
      check_between(row.place + "recovery", row.values[1], 0., 1.,
                    "Give the share of the fatigue that is lost, 0 to 1.");
      waterway.rests.push_back({row.values[0], row.values[1]});
    }
    return rest_spacing > 0. ? waterway.add_rests(rest_spacing) : waterway;
  }

  std::vector<Waterway> WayParameters::make_waterways() const
  {
    std::vector<Waterway> waterways;
    for (const Waterway &water : source.get().make_waterways(source.get_path("Passage")))
      waterways.push_back(complete(water));
    return waterways;
  }

  void PassageParameters::declare(ParameterHandler &prm)
  {
    prm.add_parameter("Model", model,
                      "The model: passage, whether a fish passes a culvert, slot or fishway (the "
                      "others, immersed and potential, have other parameters).",
                      Patterns::Selection("passage"));
    declare_libraries(prm);
    population.add_parameters(prm);
    prm.enter_subsection("Endurance");
    law.add_parameters(prm);
    prm.leave_subsection();
    way.add_parameters(prm);
    prm.enter_subsection("Strategy");
    strategy.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Energy");
    power.add_parameters(prm);
    prm.leave_subsection();
    design.add_parameters(prm);
    batch.add_parameters(prm);
    turbine.add_parameters(prm);
    output.add_folder_parameters(prm);
  }

  void PassageParameters::check() const
  {
    law.check("Endurance");
    population.check();
    law.get().check_species(population.species, "Fish/Species");
    way.check();
    for (const Waterway &waterway : way.make_waterways())
      AssertThrow(population.needs.depth == 0. || waterway.has_depths,
                  ExcMessage("Fish/Minimum depth: the profile has no depths. Give their column, "
                             "Passage/Profile/Column of depth, or a minimum depth of 0."));
    strategy.check("Strategy");
    power.check("Energy");
    design.check(way.source.get());
    batch.check(law.get());
    turbine.check();
    output.check();
  }
} // namespace caudal
