// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/column.h>
#include <caudal/passage/names.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <algorithm>

namespace caudal::passage
{
  using namespace dealii;

  namespace
  {
    /** "velocity [m/s]" as name and unit; the unit is empty if there is none. */
    std::pair<std::string, std::string> split_header(const std::string &header)
    {
      const auto open = header.find_last_of("[(");
      if (open == std::string::npos || header.find_last_of("])") != header.size() - 1)
        return {lower(Utilities::trim(header)), ""};
      return {lower(Utilities::trim(header.substr(0, open))),
              Utilities::trim(header.substr(open + 1, header.size() - open - 2))};
    }
  } // namespace

  Column::Column(const std::string &quantity, const std::string &name, const Units &units,
                 const std::string &unit)
      : quantity(quantity)
      , preset_name(name)
      , name(name)
      , units(units)
      , unit(unit)
  {}

  void Column::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Column of " + quantity, name,
                      "What the header of the table calls the " + quantity +
                          "; upper and lower case are the same.");
    prm.add_parameter("Unit of " + quantity, unit, "The unit of the " + quantity + " in the table.",
                      get_unit_pattern(units));
  }

  std::optional<std::size_t> Column::find(const TextTable &table, const std::string &path) const
  {
    for (std::size_t k = 0; k < table.header.size(); ++k)
    {
      const auto [header, header_unit] = split_header(table.header[k]);
      if (header != lower(name) && lower(table.header[k]) != lower(name))
        continue;
      if (header_unit.empty() || lower(table.header[k]) == lower(name))
        return k; // the entry of the unit decides
      std::vector<std::string> known;
      for (const auto &entry : units)
        known.push_back(entry.first);
      AssertThrow(units.count(header_unit) > 0,
                  ExcMessage(table.header_place + "the header gives the " + quantity +
                             " in the unit <" + header_unit + ">, which is none of " +
                             list_names(known) + ". Write one of them, or give " + path +
                             "/Column of " + quantity + " = " + table.header[k] +
                             " and its unit."));
      AssertThrow(units.at(header_unit) == units.at(unit),
                  ExcMessage(table.header_place + "the header gives the " + quantity + " in " +
                             header_unit + ", and " + path + "/Unit of " + quantity + " is " +
                             unit + ". Give the right one to the entry."));
      return k;
    }
    return std::nullopt;
  }

  std::optional<std::size_t> Column::find_optional(const TextTable   &table,
                                                   const std::string &path) const
  {
    if (name.empty())
      return std::nullopt;
    return name == preset_name ? find(table, path)
                               : std::optional<std::size_t>(require(table, path));
  }

  std::size_t Column::require(const TextTable &table, const std::string &path) const
  {
    const auto column = find(table, path);
    AssertThrow(column, ExcMessage(table.header_place + "there is no column <" + name +
                                   ">. The header has: " + list_names(table.header) + ". Give " +
                                   path + "/Column of " + quantity + "."));
    return *column;
  }

  double Column::read(const TextTable::Row &row, const std::size_t column) const
  {
    AssertThrow(
        column < row.fields.size() && !row.fields[column].empty(),
        ExcMessage(row.place + "the " + quantity + " is missing. Complete the row or remove it."));
    return parse_number(row.fields[column], row.place + quantity + ": ") * get_factor();
  }

  std::vector<std::pair<double, double>> read_pairs(const std::string &path,
                                                    const std::string &file, const Column &first,
                                                    const Column &second)
  {
    const std::string entry = path + "/File";
    AssertThrow(!file.empty(),
                ExcMessage(entry + ": there is none. Give a table of " + first.get_quantity() +
                           " and " + second.get_quantity() + "."));
    TextTable table = read_text_table(entry, file);
    move_units_to_header(table);
    const std::size_t x = first.require(table, path), y = second.require(table, path);
    std::vector<std::pair<double, double>> pairs;
    for (const TextTable::Row &row : table.rows)
    {
      pairs.emplace_back(first.read(row, x), second.read(row, y));
      check_positive(row.place + first.get_quantity(), pairs.back().first);
      check_positive(row.place + second.get_quantity(), pairs.back().second);
    }
    AssertThrow(!pairs.empty(), ExcMessage(entry + ": " + file + ": there is no row."));
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
      check_value(pairs[k].first < pairs[k + 1].first,
                  entry + ": " + file + ": " + first.get_quantity(), pairs[k + 1].first,
                  "It is there twice. Give each once.");
    return pairs;
  }

  void move_units_to_header(TextTable &table)
  {
    if (table.rows.empty())
      return;
    const auto &fields = table.rows[0].fields;
    if (!std::all_of(fields.begin(), fields.end(), [](const std::string &field) {
          return field.empty() || (field.front() == '(' && field.back() == ')');
        }))
      return;
    for (std::size_t k = 0; k < std::min(fields.size(), table.header.size()); ++k)
      if (!fields[k].empty() && split_header(table.header[k]).second.empty())
        table.header[k] += ' ' + fields[k];
    table.rows.erase(table.rows.begin());
  }
} // namespace caudal::passage
