#include <caudal/base/declared_parameters.h>
#include <caudal/base/parameter_file.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

namespace caudal
{
  namespace
  {
    /** Removes a comment, the blanks at both ends and repeated ones within. */
    std::string tidy(const std::string &line)
    {
      std::istringstream words(line.substr(0, line.find('#')));
      std::string        result, word;
      while (words >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    /**
     * Reads the next line that is not empty, with its continuations, and counts
     * the lines: @p number is that of the first of them.
     */
    bool read_line(std::istream &stream, std::string &line, unsigned int &number,
                   unsigned int &next)
    {
      std::string raw_line;
      line.clear();
      while (line.empty() && std::getline(stream, raw_line))
      {
        number = next++;
        line   = tidy(raw_line);
        while (!line.empty() && line.back() == '\\' && std::getline(stream, raw_line))
        {
          ++next;
          line.back() = ' ';
          line        = tidy(line + raw_line);
        }
      }
      return !line.empty();
    }

    std::string join(const std::vector<std::string> &names, const std::string &separator)
    {
      std::string result;
      for (const std::string &name : names)
        result += (result.empty() ? "" : separator) + name;
      return result;
    }

    std::string get_path(const std::vector<std::string> &sections, const std::string &entry)
    {
      return sections.empty() ? entry : join(sections, "/") + "/" + entry;
    }

    template <class Named>
    std::vector<std::string> get_names(const std::vector<Named> &list)
    {
      std::vector<std::string> names;
      for (const Named &one : list)
        names.push_back(one.name);
      return names;
    }

    /** The number of letters to insert, remove or exchange to get from @p a to @p b. */
    unsigned int compute_edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        unsigned int diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
          const bool         same = std::tolower(a[i]) == std::tolower(b[j]);
          const unsigned int cost =
              std::min({diagonal + (same ? 0 : 1), row[j] + 1, row[j + 1] + 1});
          diagonal   = row[j + 1];
          row[j + 1] = cost;
        }
      }
      return row.back();
    }

    /** The known names, and before them the one that may have been meant. */
    std::string suggest(const std::string &name, const std::vector<std::string> &known)
    {
      if (known.empty())
        return "There are none there.";
      const auto nearest =
          std::min_element(known.begin(), known.end(), [&](const auto &a, const auto &b) {
            return compute_edit_distance(name, a) < compute_edit_distance(name, b);
          });
      const bool is_near = compute_edit_distance(name, *nearest) <= 1 + name.size() / 4;
      return (is_near ? "Did you mean <" + *nearest + ">? " : "") +
             "Known there: " + join(known, ", ") + ".";
    }

    /** The declared section of that path, or nullptr. */
    const DeclaredSection *find_section(const DeclaredSection          &declared,
                                        const std::vector<std::string> &sections)
    {
      const DeclaredSection *found = &declared;
      for (const std::string &name : sections)
        if (found != nullptr)
          found = found->find_section(name);
      return found;
    }

    /** Sets an entry that is known to be declared. Returns what is wrong, or nothing. */
    std::string set_entry(ParameterHandler &prm, const std::vector<std::string> &sections,
                          const DeclaredEntry &entry, const std::string &value)
    {
      std::string problem;
      for (const std::string &name : sections)
        prm.enter_subsection(name);
      try
      {
        prm.set(entry.name, value);
      }
      catch (const ExceptionBase &)
      {
        problem = get_path(sections, entry.name) + ": the value is <" + value + ">. Give " +
                  entry.allowed + ".";
      }
      for (unsigned int i = 0; i < sections.size(); ++i)
        prm.leave_subsection();
      return problem;
    }
  } // namespace

  ParameterFile::ParameterFile(const std::string &file, const std::vector<std::string> &overrides)
      : overrides(overrides)
  {
    std::set<std::string> open_files;
    read(file, "", {}, open_files);
    for (const std::string &text : overrides)
      read_override(text);
  }

  std::string ParameterFile::get(const std::string &path, const std::string &default_value) const
  {
    for (auto a = assignments.rbegin(); a != assignments.rend(); ++a)
      if (!a->entry.empty() && get_path(a->sections, a->entry) == path)
        return a->value;
    return default_value;
  }

  void ParameterFile::parse(ParameterHandler &prm) const
  {
    const DeclaredSection    declared = extract_declared_parameters(prm);
    std::vector<std::string> problems;

    for (const auto &[sections, entry, value, origin] : assignments)
    {
      const bool opens_section = entry.empty();
      Sections   around        = sections;
      if (opens_section)
        around.pop_back();

      const DeclaredSection *const section = find_section(declared, around);
      if (section == nullptr)
        continue; // reported where that section was opened

      const std::string place =
          around.empty() ? "outside all sections" : "in section <" + join(around, "/") + ">";
      if (opens_section)
      {
        if (section->find_section(sections.back()) == nullptr)
          problems.push_back(origin + ": there is no section <" + sections.back() + "> " + place +
                             ". " + suggest(sections.back(), get_names(section->sections)));
      }
      else if (const DeclaredEntry *const known = section->find_entry(entry))
      {
        const std::string problem = set_entry(prm, sections, *known, value);
        if (!problem.empty())
          problems.push_back(origin + ": " + problem);
      }
      else
        problems.push_back(origin + ": there is no entry <" + entry + "> " + place + ". " +
                           suggest(entry, get_names(section->entries)));
    }

    for (const std::string &path : extract_missing_entries(prm))
      problems.push_back(path + ": this entry is required and was not given. Set it.");

    AssertThrow(problems.empty(), ExcMessage(join(problems, "\n")));
  }

  void ParameterFile::read(const std::string &file, const std::string &included_from,
                           Sections sections, std::set<std::string> &open_files)
  {
    const std::string by = included_from.empty() ? "" : included_from + ": ";
    std::ifstream     stream(file);
    AssertThrow(
        stream && !std::filesystem::is_directory(file),
        ExcMessage(by + "the file <" + file + "> can't be read. Give an existing .prm file."));
    const std::string identity = std::filesystem::canonical(file);
    AssertThrow(open_files.insert(identity).second,
                ExcMessage(by + "the file <" + file + "> includes itself. Remove this line."));

    const std::size_t        outer_depth = sections.size();
    std::vector<std::string> openings; // where each open section of this file begins
    std::string              line;
    unsigned int             number = 0, next_number = 1;
    while (read_line(stream, line, number, next_number))
    {
      const std::string origin   = file + ":" + std::to_string(number);
      const std::size_t blank    = line.find(' ');
      const std::string keyword  = line.substr(0, blank);
      const std::string argument = blank == std::string::npos ? "" : line.substr(blank + 1);
      const std::size_t equals   = argument.find('=');

      if (keyword == "subsection" && !argument.empty())
      {
        openings.push_back(origin);
        sections.push_back(argument);
        assignments.push_back({sections, "", "", origin});
      }
      else if (line == "end")
      {
        AssertThrow(sections.size() > outer_depth,
                    ExcMessage(origin + ": this <end> belongs to no <subsection> of this file. "
                                        "Remove it."));
        openings.pop_back();
        sections.pop_back();
      }
      else if (keyword == "include" && !argument.empty())
        read(std::filesystem::path(file).parent_path() / argument, origin, sections, open_files);
      else if (keyword == "set" && equals != std::string::npos && equals > 0)
        assignments.push_back({sections, tidy(argument.substr(0, equals)),
                               tidy(argument.substr(equals + 1)), origin});
      else
        AssertThrow(false,
                    ExcMessage(origin + ": the line <" + line + "> can't be understood. Write " +
                               "<subsection Name>, <end>, <set Entry = value> or " +
                               "<include file.prm>."));
    }
    AssertThrow(openings.empty(),
                ExcMessage(openings.back() + ": the subsection <" + sections.back() +
                           "> has no <end> in this file. Add it."));
    open_files.erase(identity);
  }

  void ParameterFile::read_override(const std::string &text)
  {
    const std::string origin = "-D \"" + text + "\"";
    const std::size_t equals = text.find('=');
    Sections          names  = Utilities::split_string_list(text.substr(0, equals), '/');
    AssertThrow(equals != std::string::npos && !names.empty() &&
                    std::find(names.begin(), names.end(), "") == names.end(),
                ExcMessage(origin + ": an override is written <Section/Entry=value>."));

    const std::string entry = names.back();
    names.pop_back();
    for (unsigned int depth = 1; depth <= names.size(); ++depth)
      assignments.push_back({Sections(names.begin(), names.begin() + depth), "", "", origin});
    assignments.push_back({names, entry, tidy(text.substr(equals + 1)), origin});
  }
} // namespace caudal
