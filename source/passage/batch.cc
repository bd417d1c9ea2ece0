// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/batch.h>
#include <caudal/passage/names.h>
#include <caudal/passage/verdict.h>

#include <algorithm>

namespace caudal::passage
{
  void BatchParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Batch");
    prm.add_parameter("File", file,
                      "A table of fish with a header: each of its rows is answered at each "
                      "discharge. Everything else is as for the fish of section Fish.",
                      Patterns::FileName(Patterns::FileName::input));
    prm.add_parameter("Column of species", species_column, "What the header calls the species.");
    length.add_parameters(prm);
    prm.leave_subsection();
  }

  void BatchParameters::check(const EnduranceLaw &law) const
  {
    if (is_asked_for())
      for (const BatchFish &fish : read())
        law.check_species(fish.species, fish.place + "species");
  }

  std::vector<BatchFish> BatchParameters::read() const
  {
    TextTable  table = read_text_table("Batch/File", file);
    const auto column =
        std::find_if(table.header.begin(), table.header.end(),
                     [&](const auto &name) { return lower(name) == lower(species_column); });
    AssertThrow(column != table.header.end(),
                ExcMessage("Batch/File: " + file + ": there is no column <" + species_column +
                           ">. The header has: " + list_names(table.header) +
                           ". Give Batch/Column of species."));
    const std::size_t s = column - table.header.begin();
    move_units_to_header(table);
    const std::size_t      l = length.require(table, "Batch");
    std::vector<BatchFish> fish;
    for (const TextTable::Row &row : table.rows)
    {
      AssertThrow(s < row.fields.size() && !row.fields[s].empty(),
                  ExcMessage(row.place + "the species is missing. Complete the row or remove it."));
      fish.push_back({row.fields[s], length.read(row, l), row.place});
      check_fish_length(row.place + "length", fish.back().length);
    }
    AssertThrow(!fish.empty(), ExcMessage("Batch/File: " + file +
                                          ": there is no fish in it. Give "
                                          "rows of species and length."));
    return fish;
  }

  std::vector<BatchAnswer> answer_batch(const BatchParameters &parameters, const Question &question,
                                        const std::vector<Waterway> &waterways)
  {
    std::vector<BatchAnswer> answers;
    for (const BatchFish &fish : parameters.read())
    {
      Population population = question.population;
      population.species    = fish.species;
      population.length     = fish.length;
      population.spread     = 0.;
      population.classes_text.clear();
      const Question    own{question.law, question.strategy, population};
      const auto        marks  = mark_lengths(own);
      const std::string remark = marks.empty() ? "" : marks[0];
      for (const Waterway &waterway : waterways)
      {
        const auto ascend = [&](const std::size_t band) {
          return own.ascend(waterway, fish.length, get_bands()[band].ability, {true, {}, 0.});
        };
        const Ascent  median = ascend(median_band), weak = ascend(median_band - 1);
        const Ascent &limiting = median.passes() ? weak : median;
        answers.push_back({fish, waterway.discharge, own.compute_share(waterway, fish.length),
                           median.fatigue, limiting.cause, limiting.place, remark});
      }
    }
    return answers;
  }
} // namespace caudal::passage
