// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/parameter_text.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace caudal
{
  using dealii::Utilities::trim;

  std::string tidy_name(const std::string &text)
  {
    std::istringstream words(text);
    std::string        name, word;
    while (words >> word)
      name += (name.empty() ? "" : " ") + word;
    return name;
  }

  std::string join(const std::vector<std::string> &names, const std::string &separator)
  {
    return join(names, separator, separator);
  }

  std::string join(const std::vector<std::string> &names, const std::string &separator,
                   const std::string &last_separator)
  {
    std::string result;
    for (std::size_t i = 0; i < names.size(); ++i)
      result += (i == 0 ? "" : i + 1 == names.size() ? last_separator : separator) + names[i];
    return result;
  }

  std::size_t find_comment(const std::string &text)
  {
    std::size_t hash = text.find('#');
    while (hash != std::string::npos && hash > 0 && text[hash - 1] != ' ' && text[hash - 1] != '\t')
      hash = text.find('#', hash + 1);
    return hash;
  }

  bool read_line(std::istream &stream, std::string &line, unsigned int &number, unsigned int &next)
  {
    std::string raw_line;
    line.clear();
    while (line.empty() && std::getline(stream, raw_line))
    {
      number = next++;
      line   = trim(raw_line.substr(0, find_comment(raw_line)));
      while (!line.empty() && line.back() == '\\' && std::getline(stream, raw_line))
      {
        ++next;
        line.pop_back();
        line = trim(trim(line) + " " + trim(raw_line.substr(0, find_comment(raw_line))));
      }
    }
    return !line.empty();
  }

  bool is_whole_parameter_file(const std::string &text)
  {
    std::istringstream stream(text);
    std::string        line;
    unsigned int       number = 0, next_number = 1, n_entries = 0;
    int                depth = 0;
    while (depth >= 0 && read_line(stream, line, number, next_number))
      if (line.rfind("subsection ", 0) == 0)
        ++depth;
      else if (line == "end")
        --depth;
      else
        ++n_entries;
    return n_entries > 0 && depth == 0;
  }

  std::string write_out_whole_numbers(const std::string &text)
  {
    static const std::regex scientific(R"(\d+(\.\d*)?[eE]\+?\d+)");
    std::string             result;
    std::size_t             end = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), scientific), last; match != last;
         ++match)
    {
      const double number = std::stod(match->str());
      result += text.substr(end, match->position() - end);
      result += number == std::floor(number) && number < 1e15
                    ? std::to_string(static_cast<long long>(number))
                    : match->str();
      end = match->position() + match->length();
    }
    return result + text.substr(end);
  }
} // namespace caudal
