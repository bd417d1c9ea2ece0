// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/safe_file.h>
#include <caudal/fish/number_table.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast.hpp>
#include <boost/tokenizer.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>

namespace caudal
{
  using namespace dealii;

  namespace
  {
    /** An entry without blanks and quotes around it. */
    std::string strip(const std::string &text)
    {
      const std::string field = Utilities::trim(text);
      return field.size() > 1 && field.front() == '"' && field.back() == '"'
                 ? Utilities::trim(field.substr(1, field.size() - 2))
                 : field;
    }

    /** The entries of a row without comment: separated by semicolons, commas or blanks. */
    std::vector<std::string> split_fields(const std::string &line, const std::string &place)
    {
      const bool              has_semicolons = line.find(';') != std::string::npos;
      const bool              has_commas     = line.find(',') != std::string::npos;
      static const std::regex decimal_comma(R"((^|[;\s"])[+-]?\d+,\d+($|[;\s"]))");
      AssertThrow(!(has_semicolons || line.find_first_of(" \t") != std::string::npos) ||
                      !std::regex_search(line, decimal_comma),
                  ExcMessage(place + "there is a comma within a number. Save the table with "
                                     "points, 0.5 and not 0,5."));
      std::vector<std::string> fields;
      // An entry that is missing between two separators is to be seen as such.
      if (has_semicolons || has_commas)
      {
        using Separator = boost::escaped_list_separator<char>; // but within quotes
        const boost::tokenizer<Separator> entries(line,
                                                  Separator("", has_semicolons ? ";" : ",", "\""));
        fields.assign(entries.begin(), entries.end());
      }
      else if (!line.empty())
        boost::split(fields, line, boost::is_space(), boost::token_compress_on);
      for (std::string &field : fields)
        field = strip(field);
      // Some programs end each row with a separator.
      if (fields.size() > 1 && fields.back().empty())
        fields.pop_back();
      return fields;
    }

    NumberTable::Row parse_row(const std::string &place, const std::vector<std::string> &fields,
                               const unsigned int n_columns)
    {
      AssertThrow(n_columns == 0 || fields.size() == n_columns,
                  ExcMessage(place + "there are " + std::to_string(fields.size()) +
                             " entries instead of " + std::to_string(n_columns) +
                             ". Complete the row or remove it."));
      NumberTable::Row row;
      row.place = place;
      for (const std::string &field : fields)
        row.values.push_back(parse_number(field, place));
      return row;
    }
  } // namespace

  bool is_number(const std::string &field)
  {
    double value = 0.;
    return boost::conversion::try_lexical_convert(field, value) && std::isfinite(value);
  }

  double parse_number(const std::string &field, const std::string &place)
  {
    static const std::regex decimal_comma(R"([+-]?[\d.]*\d,\d+)");
    AssertThrow(!std::regex_match(field, decimal_comma),
                ExcMessage(place + "there is a comma within the number <" + field +
                           ">. Save the table with points, 0.5 and not 0,5."));
    AssertThrow(
        is_number(field),
        ExcMessage(place + "<" + field + "> is not a finite number. Give one, or remove the row."));
    return boost::lexical_cast<double>(field);
  }

  TextTable read_text_table(const std::string &entry, const std::string &file_name)
  {
    std::string       text;
    const std::string reason = catch_file_error([&]() { text = read_text_file(file_name); });
    AssertThrow(reason.empty(), ExcMessage(entry + ": the table can't be read: " + reason +
                                           ". Give an existing table of numbers."));
    std::istringstream file(text);
    TextTable          table;
    unsigned int       number = 0;
    for (std::string line; std::getline(file, line);)
    {
      ++number;
      line = Utilities::trim(line.substr(0, line.find('#')));
      if (line.empty() || line.rfind("sep=", 0) == 0) // which tells spreadsheets the separator
        continue;
      const std::string place =
          entry + ": " + file_name + ", line " + std::to_string(number) + ": ";
      const std::vector<std::string> fields = split_fields(line, place);
      if (std::all_of(fields.begin(), fields.end(),
                      [](const std::string &field) { return field.empty(); }))
        continue; // as spreadsheets write empty rows
      double value;
      if (table.rows.empty() && table.header.empty() && !fields[0].empty() &&
          std::isalpha(static_cast<unsigned char>(fields[0][0])) &&
          !boost::conversion::try_lexical_convert(fields[0], value))
      {
        table.header       = fields;
        table.header_place = place;
      }
      else
        table.rows.push_back({fields, place});
    }
    return table;
  }

  NumberTable read_number_table(const std::string &entry, const std::string &file_name,
                                const unsigned int n_columns)
  {
    const TextTable texts = read_text_table(entry, file_name);
    NumberTable     table{texts.header, texts.header_place, {}};
    for (const TextTable::Row &row : texts.rows)
      table.rows.push_back(parse_row(row.place, row.fields, n_columns));
    return table;
  }

  NumberTable parse_number_table(const std::string &entry, const std::string &text,
                                 const unsigned int n_columns)
  {
    NumberTable table;
    for (const std::string &row : Utilities::split_string_list(text, ';'))
    {
      const std::string place = entry + ": row " + std::to_string(table.rows.size() + 1) + ": ";
      table.rows.push_back(parse_row(place, split_fields(row, place), n_columns));
    }
    return table;
  }

  void check_table_times(const std::string &path, const std::string &section, const double begin,
                         const double end, const double end_time)
  {
    AssertThrow(begin <= 1e-9 * end_time && end_time <= end * (1. + 1e-9),
                ExcMessage(path + "/" + section + "/Table/File: the table reaches from " +
                           Patterns::Tools::to_string(begin) + " s to " +
                           Patterns::Tools::to_string(end) + " s, and the run from 0 s to " +
                           Patterns::Tools::to_string(end_time) +
                           " s. Complete the table, end the run earlier (Time/End time), or set " +
                           section + "/Table/Periodic."));
  }
} // namespace caudal
