// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/number_table.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast.hpp>

#include <cctype>
#include <cmath>
#include <fstream>

namespace caudal
{
  using namespace dealii;

  namespace
  {
    /** The entries of a row without comment. */
    std::vector<std::string> split_fields(const std::string &line)
    {
      std::vector<std::string> fields;
      // An entry that is missing between two commas is to be seen as such.
      if (line.find(',') != std::string::npos)
        boost::split(fields, line, boost::is_any_of(","));
      else if (!line.empty())
        boost::split(fields, line, boost::is_space(), boost::token_compress_on);
      for (std::string &field : fields)
        boost::trim(field);
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

  double parse_number(const std::string &field, const std::string &place)
  {
    double value = 0.;
    AssertThrow(
        boost::conversion::try_lexical_convert(field, value) && std::isfinite(value),
        ExcMessage(place + "<" + field + "> is not a finite number. Give one, or remove the row."));
    return value;
  }

  NumberTable read_number_table(const std::string &entry, const std::string &file_name,
                                const unsigned int n_columns)
  {
    std::ifstream file(file_name);
    AssertThrow(file, ExcMessage(entry + ": the file <" + file_name +
                                 "> can't be read. Give an existing table of numbers."));
    NumberTable  table;
    unsigned int number = 0;
    for (std::string line; std::getline(file, line);)
    {
      ++number;
      line = Utilities::trim(line.substr(0, line.find('#')));
      if (line.empty())
        continue;
      const std::string place =
          entry + ": " + file_name + ", line " + std::to_string(number) + ": ";
      const std::vector<std::string> fields = split_fields(line);
      double                         value;
      if (table.rows.empty() && table.header.empty() && std::isalpha(line[0]) &&
          !boost::conversion::try_lexical_convert(fields[0], value))
      {
        table.header       = fields;
        table.header_place = place;
      }
      else
        table.rows.push_back(parse_row(place, fields, n_columns));
    }
    return table;
  }

  NumberTable parse_number_table(const std::string &entry, const std::string &text,
                                 const unsigned int n_columns)
  {
    NumberTable table;
    for (const std::string &row : Utilities::split_string_list(text, ';'))
      table.rows.push_back(
          parse_row(entry + ": row " + std::to_string(table.rows.size() + 1) + ": ",
                    split_fields(row), n_columns));
    return table;
  }
} // namespace caudal
