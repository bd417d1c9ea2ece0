#include <caudal/ideal/number_table.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace caudal::ideal
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string> split_fields(std::string line)
    {
      for (char &c : line)
        if (c == '\t' || c == '\r')
          c = ' ';
      if (line.find(',') != std::string::npos)
      {
        // An entry that is missing between two commas is to be seen as such.
        std::vector<std::string> fields;
        std::istringstream       stream(line);
        for (std::string field; std::getline(stream, field, ',');)
          fields.push_back(Utilities::trim(field));
        if (Utilities::trim(line).back() == ',')
          fields.emplace_back();
        return fields;
      }
      std::istringstream       stream(line);
      std::vector<std::string> fields;
      for (std::string field; stream >> field;)
        fields.push_back(field);
      return fields;
    }

    bool is_number(const std::string &field, double &value)
    {
      char *end = nullptr;
      value     = std::strtod(field.c_str(), &end);
      return !field.empty() && *end == '\0';
    }

    std::vector<double> parse_row(const std::string &place, const std::vector<std::string> &fields,
                                  const unsigned int n_columns)
    {
      AssertThrow(fields.size() == n_columns,
                  ExcMessage(place + "there are " + std::to_string(fields.size()) +
                             " entries instead of " + std::to_string(n_columns) +
                             ". Complete the row or remove it."));
      std::vector<double> row;
      for (const std::string &field : fields)
      {
        double     value = 0.;
        const bool ok    = is_number(field, value) && std::isfinite(value);
        AssertThrow(ok, ExcMessage(place + "<" + field +
                                   "> is not a finite number. Give one, or remove the row."));
        row.push_back(value);
      }
      return row;
    }
  } // namespace

  std::vector<std::vector<double>> read_number_table(const std::string &entry,
                                                     const std::string &file_name,
                                                     const unsigned int n_columns)
  {
    std::ifstream file(file_name);
    AssertThrow(file, ExcMessage(entry + ": the file <" + file_name +
                                 "> can't be read. Give an existing table of numbers."));
    std::vector<std::vector<double>> rows;
    unsigned int                     number   = 0;
    bool                             is_first = true;
    for (std::string line; std::getline(file, line);)
    {
      ++number;
      line = Utilities::trim(line.substr(0, line.find('#')));
      if (line.empty())
        continue;
      const std::vector<std::string> fields = split_fields(line);
      double                         value;
      const bool is_header = is_first && std::isalpha(fields[0][0]) && !is_number(fields[0], value);
      is_first             = false;
      if (!is_header)
        rows.push_back(
            parse_row(entry + ": " + file_name + ", line " + std::to_string(number) + ": ", fields,
                      n_columns));
    }
    return rows;
  }

  std::vector<std::vector<double>> parse_number_table(const std::string &entry,
                                                      const std::string &text,
                                                      const unsigned int n_columns)
  {
    std::vector<std::vector<double>> rows;
    for (const std::string &row : Utilities::split_string_list(text, ';'))
      rows.push_back(parse_row(entry + ": row " + std::to_string(rows.size() + 1) + ": ",
                               split_fields(row), n_columns));
    return rows;
  }
} // namespace caudal::ideal
