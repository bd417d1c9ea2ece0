// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/declared_parameters.h>
#include <caudal/base/parameter_file.h>
#include <caudal/base/parameter_text.h>
#include <caudal/base/plugin.h>
#include <caudal/base/safe_file.h>
#include <caudal/base/suggestions.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>

namespace caudal
{
  namespace
  {
    /** The deepest includes: more of them are a mistake. */
    constexpr std::size_t largest_depth = 50;

    std::string get_path(const std::vector<std::string> &sections, const std::string &entry)
    {
      return sections.empty() ? entry : join(sections, "/") + "/" + entry;
    }

    /** A pattern of the paths that are @p path with its `*`, or lead into this section. */
    std::regex make_pattern(const std::string &path)
    {
      static const std::regex special(R"([.+()\[\]{}^$|?\\])"), star(R"(\*)");
      const std::string       plain = std::regex_replace(path, special, R"(\$&)");
      return std::regex(std::regex_replace(plain, star, "([^/]*)") + "(/.*)?");
    }

    /** The present name of what once was @p path, if @p renamed is about it. */
    std::optional<std::string> find_new_path(const std::string &path, const RenamedEntry &renamed)
    {
      // Most names fail here, and making a pattern takes long.
      if (path.rfind(renamed.old_path.substr(0, renamed.old_path.find('*')), 0) != 0)
        return {};
      std::smatch match;
      if (!std::regex_match(path, match, make_pattern(renamed.old_path)))
        return {};
      std::string  new_path;
      unsigned int n_stars = 0;
      for (const char c : renamed.new_path)
        new_path += c == '*' ? match[++n_stars].str() : std::string(1, c);
      return new_path + match[match.size() - 1].str();
    }

    std::size_t count_names(const std::string &path)
    {
      return Utilities::split_string_list(path, '/').size();
    }

    /**
     * Whether something within the section @p sections was renamed. A section of a body, whose
     * name is the user's, is not one of a former version.
     */
    bool holds_former_names(const std::vector<std::string> &sections, const RenamedEntry &renamed)
    {
      std::vector<std::string> outer = Utilities::split_string_list(renamed.old_path, '/');
      if (outer.size() <= sections.size())
        return false;
      outer.resize(sections.size());
      return outer.back().find('*') == std::string::npos &&
             std::regex_match(join(sections, "/"), make_pattern(join(outer, "/")));
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

    /**
     * The plug-in that the entry @p choice can choose and whose parameters stand in the section
     * @p name within @p outer; empty if there is none.
     */
    std::string find_plugin(const std::string &name, const DeclaredSection &outer,
                            const DeclaredEntry &choice)
    {
      const auto &plugins   = choice.choices;
      const bool  is_prefix = std::any_of(plugins.begin(), plugins.end(), [&](const auto &plugin) {
        return outer.find_section(get_plugin_section(choice.name + " " + plugin)) != nullptr;
      });
      const auto  found     = std::find_if(plugins.begin(), plugins.end(), [&](const auto &plugin) {
        return name == get_plugin_section(is_prefix ? choice.name + " " + plugin : plugin);
      });
      return found == plugins.end() ? "" : *found;
    }

    /**
     * The name of an input file that was given at @p origin, "fish.prm:12": relative to that file's
     * folder if it is there, else, as it is, to the working directory.
     */
    std::string find_input_file(const std::string &name, const std::string &origin)
    {
      const auto folder = std::filesystem::path(origin.substr(0, origin.rfind(':'))).parent_path();
      const std::filesystem::path beside = (folder / name).lexically_normal();
      std::error_code             ignored;
      return !name.empty() && std::filesystem::exists(beside, ignored) ? beside.string() : name;
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
        const bool is_whole = entry.allowed.find("an integer") != std::string::npos;
        prm.set(entry.name, is_whole ? write_out_whole_numbers(value) : value);
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

  std::string ParameterFile::get_path(const Assignment &assignment)
  {
    return assignment.entry.empty() ? join(assignment.sections, "/")
                                    : caudal::get_path(assignment.sections, assignment.entry);
  }

  std::string ParameterFile::get(const std::string &path, const std::string &default_value) const
  {
    for (auto a = assignments.rbegin(); a != assignments.rend(); ++a)
      if (!a->entry.empty() && get_path(*a) == path)
        return a->value;
    return default_value;
  }

  void ParameterFile::rename(const std::vector<RenamedEntry> &renamed_entries)
  {
    const std::vector<Assignment> original = assignments;
    for (Assignment &assignment : assignments)
    {
      const auto fits = [&](const RenamedEntry &renamed) {
        // In a section that has the former name of an entry, which has moved there, names are new.
        if (renamed.new_path.rfind(renamed.old_path + "/", 0) == 0 &&
            (assignment.entry.empty() ||
             count_names(get_path(assignment)) != count_names(renamed.old_path)))
          return false;
        return find_new_path(get_path(assignment), renamed) &&
               (renamed.old_value.empty() || renamed.old_value == assignment.value);
      };
      const auto renamed = std::find_if(renamed_entries.begin(), renamed_entries.end(), fits);
      if (renamed != renamed_entries.end())
        rename(assignment, *renamed, original);
      else if (assignment.entry.empty())
        assignment.is_former =
            std::any_of(renamed_entries.begin(), renamed_entries.end(), [&](const auto &one) {
              return holds_former_names(assignment.sections, one);
            });
    }
  }

  void ParameterFile::rename(Assignment &assignment, const RenamedEntry &renamed,
                             const std::vector<Assignment> &original)
  {
    const bool        is_section = assignment.entry.empty();
    const std::string old_path   = get_path(assignment);
    const std::string new_path   = *find_new_path(old_path, renamed);
    const bool        has_value  = !renamed.old_value.empty();

    // A section is told once, where it is opened, and not with each of its entries.
    if (count_names(old_path) == count_names(renamed.old_path))
      hints.push_back(assignment.origin + ": " + (is_section ? "the section <" : "<") + old_path +
                      (has_value ? " = " + renamed.old_value : "") + "> is now called <" +
                      new_path + (has_value ? " = " + renamed.new_value : "") + ">.");

    for (const Assignment &other : original)
      AssertThrow(is_section || old_path == new_path || get_path(other) != new_path ||
                      other.is_override || assignment.is_override,
                  ExcMessage(assignment.origin + ": <" + old_path + "> is now called <" + new_path +
                             ">, which is set at " + other.origin + ", too. Leave one out."));

    assignment.sections = Utilities::split_string_list(new_path, '/');
    if (!is_section)
    {
      assignment.entry = assignment.sections.back();
      assignment.sections.pop_back();
    }
    if (has_value)
      assignment.value = renamed.new_value;
  }

  std::string ParameterFile::find_problem(const Assignment      &assignment,
                                          const DeclaredSection &declared,
                                          ParameterHandler      &prm) const
  {
    const bool        opens_section = assignment.entry.empty();
    const std::string name          = opens_section ? assignment.sections.back() : assignment.entry;
    Sections          around        = assignment.sections;
    if (opens_section)
      around.pop_back();
    const std::string sentence =
        std::string("there is no ") + (opens_section ? "section" : "entry") + " <" + name + "> " +
        (around.empty() ? "outside all sections" : "in section <" + join(around, "/") + ">") + ". ";

    const DeclaredSection *const section = find_section(declared, around);
    if (section == nullptr)
    {
      // Reported where the section was opened, unless it was one of a former version.
      const bool is_former =
          std::any_of(assignments.begin(), assignments.end(), [&](const Assignment &other) {
            return other.is_former && other.sections == around;
          });
      return is_former ? sentence + "Remove it." : "";
    }
    if (opens_section)
      return assignment.is_former || section->find_section(name) != nullptr
                 ? ""
                 : sentence + suggest_section(name, *section, declared);
    if (const DeclaredEntry *const known = section->find_entry(name))
      return set_entry(prm, assignment.sections, *known,
                       known->names_input_file && !assignment.is_override
                           ? find_input_file(assignment.value, assignment.origin)
                           : assignment.value);
    return sentence + suggest_entry(name, *section, declared);
  }

  void ParameterFile::parse(ParameterHandler &prm) const
  {
    const DeclaredSection    declared = extract_declared_parameters(prm);
    std::vector<std::string> problems;
    for (const Assignment &assignment : assignments)
    {
      const std::string problem = find_problem(assignment, declared, prm);
      if (!problem.empty())
        problems.push_back(assignment.origin + ": " + problem);
    }
    for (const std::string &path : extract_missing_entries(prm))
      problems.push_back(path + ": this entry is required and was not given. Set it.");

    AssertThrow(problems.empty(), ExcMessage(join(problems, "\n")));
  }

  std::vector<std::string> ParameterFile::find_idle_entries(const ParameterHandler &prm) const
  {
    const DeclaredSection    declared = extract_declared_parameters(prm);
    std::vector<std::string> sentences;
    for (const Assignment &assignment : assignments)
    {
      const DeclaredSection *const section = find_section(declared, assignment.sections);
      const DeclaredEntry         *entry =
          section == nullptr ? nullptr : section->find_entry(assignment.entry);
      if (entry == nullptr || entry->value == entry->default_value)
        continue;
      // Around the entry stands a section in whose place another one is chosen.
      for (std::size_t depth = 0; depth < assignment.sections.size(); ++depth)
      {
        const Sections outer(assignment.sections.begin(), assignment.sections.begin() + depth);
        const DeclaredSection &around = *find_section(declared, outer);
        for (const DeclaredEntry &choice : around.entries)
        {
          const std::string plugin = find_plugin(assignment.sections[depth], around, choice);
          if (!plugin.empty() && plugin != choice.value &&
              !is_set_beside(assignment, caudal::get_path(outer, choice.name), plugin))
            sentences.push_back(assignment.origin + ": <" + get_path(assignment) +
                                "> has no effect, since <" + caudal::get_path(outer, choice.name) +
                                "> is <" + choice.value + ">.");
        }
      }
    }
    return sentences;
  }

  bool ParameterFile::is_set_beside(const Assignment &assignment, const std::string &path,
                                    const std::string &value) const
  {
    const auto get_file = [](const Assignment &one) {
      return one.origin.substr(0, one.origin.rfind(':'));
    };
    return std::any_of(assignments.begin(), assignments.end(), [&](const Assignment &other) {
      return get_path(other) == path && other.value == value &&
             get_file(other) == get_file(assignment);
    });
  }

  std::vector<std::string> ParameterFile::get_remarks(const ParameterHandler &prm) const
  {
    std::vector<std::string> remarks;
    for (const std::string &hint : hints)
      remarks.push_back("Note: " + hint);
    for (const std::string &sentence : find_idle_entries(prm))
      remarks.push_back("Warning: " + sentence);
    return remarks;
  }

  void ParameterFile::read(const std::string &file, const std::string &included_from,
                           Sections sections, std::set<std::string> &open_files)
  {
    const std::string by = included_from.empty() ? "" : included_from + ": ";
    std::string       text;
    const std::string reason = catch_file_error([&]() { text = read_text_file(file); });
    AssertThrow(reason.empty(), ExcMessage(by + "the file <" + file + "> can't be read: " + reason +
                                           ". Give an existing .prm file."));
    const std::string identity = std::filesystem::canonical(file);
    AssertThrow(open_files.insert(identity).second,
                ExcMessage(by + "the file <" + file + "> includes itself. Remove this line."));
    AssertThrow(open_files.size() <= largest_depth,
                ExcMessage(by + "files include each other more than " +
                           std::to_string(largest_depth) + " deep. Include them side by side."));
    std::istringstream stream(text);

    const std::size_t        outer_depth = sections.size();
    std::vector<std::string> openings; // where each open section of this file begins
    std::string              line;
    unsigned int             number = 0, next_number = 1;
    while (read_line(stream, line, number, next_number))
    {
      const std::string origin  = file + ":" + std::to_string(number);
      const std::size_t blank   = line.find_first_of(" \t");
      const std::string keyword = line.substr(0, blank);
      const std::string argument =
          blank == std::string::npos ? "" : Utilities::trim(line.substr(blank));
      const std::size_t equals = argument.find('=');

      if (keyword == "subsection" && !argument.empty())
      {
        openings.push_back(origin);
        sections.push_back(tidy_name(argument));
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
        assignments.push_back({sections, tidy_name(argument.substr(0, equals)),
                               Utilities::trim(argument.substr(equals + 1)), origin});
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
    AssertThrow(find_invalid_utf8(text) == std::string::npos,
                ExcMessage(origin + ": it is no text in UTF-8. Give it in this encoding."));
    const std::size_t equals = text.find('=');
    Sections          names  = Utilities::split_string_list(text.substr(0, equals), '/');
    std::transform(names.begin(), names.end(), names.begin(), tidy_name);
    AssertThrow(equals != std::string::npos && !names.empty() &&
                    std::find(names.begin(), names.end(), "") == names.end(),
                ExcMessage(origin + ": an override is written <Section/Entry=value>."));

    const std::string entry = names.back();
    names.pop_back();
    for (unsigned int depth = 1; depth <= names.size(); ++depth)
      assignments.push_back({Sections(names.begin(), names.begin() + depth), "", "", origin, true});
    const std::string value = Utilities::trim(text.substr(equals + 1));
    // The run's parameters.prm could not say it.
    AssertThrow(find_comment(" " + value) == std::string::npos,
                ExcMessage(origin + ": a '#' behind a blank starts a comment in a parameter file. "
                                    "Leave the blank out."));
    assignments.push_back({names, entry, value, origin, true});
  }
} // namespace caudal
