// SPDX-License-Identifier: LGPL-2.1-or-later
#define BOOST_BIND_GLOBAL_PLACEHOLDERS // property_tree's parser relies on them, noisily

#include <caudal/base/declared_parameters.h>
#include <caudal/base/safe_file.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <regex>
#include <sstream>

namespace caudal
{
  namespace
  {
    template <class Named>
    const Named *find_by_name(const std::vector<Named> &list, const std::string &name)
    {
      const auto found = std::find_if(list.begin(), list.end(),
                                      [&](const Named &one) { return one.name == name; });
      return found == list.end() ? nullptr : &*found;
    }

    std::string describe_range(const std::string &what, const std::string &lowest,
                               const std::string &highest)
    {
      const bool has_lowest  = lowest != "-MAX_DOUBLE" && lowest != "-2147483648";
      const bool has_highest = highest != "MAX_DOUBLE" && highest != "2147483647";
      if (has_lowest && has_highest)
        return what + " from " + lowest + " to " + highest;
      if (has_lowest)
        return what + " >= " + lowest;
      if (has_highest)
        return what + " <= " + highest;
      return what;
    }

    const std::string input_file = "[FileName (Type: input)]"; // as a pattern describes itself
    const std::regex  selection(R"(\[Selection (.*?) ?\])");

    /** The names that a pattern allows, if it is a selection. */
    std::vector<std::string> extract_choices(const std::string &pattern)
    {
      std::smatch match;
      return std::regex_match(pattern, match, selection)
                 ? Utilities::split_string_list(match[1].str(), '|')
                 : std::vector<std::string>();
    }

    /** Puts what a pattern says of itself, "[Double 0...1 (inclusive)]", into words. */
    std::string describe_pattern(const std::string &pattern)
    {
      static const std::regex range(R"(\[(Double|Integer range) (\S+)\.\.\.(\S+) \(inclusive\)\])");
      static const std::regex list(R"(\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\))"
                                   R"((?: separated by <(.*)>)?\])");
      static const std::regex pair(R"(\[Tuple of <2> elements <(.*)>, <\1>\])");

      std::smatch match;
      if (pattern == "[Bool]")
        return "true or false";
      if (pattern == "[Anything]")
        return "any text";
      if (pattern == input_file)
        return "the name of a file";
      if (std::regex_match(pattern, match, range))
        return describe_range(match[1] == "Double" ? "a number" : "an integer", match[2], match[3]);
      if (std::regex_match(pattern, match, selection))
        return "one of " + std::regex_replace(match[1].str(), std::regex(R"(\|)"), ", ");
      if (std::regex_match(pattern, match, list))
      {
        const std::string separator = match[4].length() > 0 ? match[4].str() : ",";
        const std::string length    = match[2] == match[3] ? match[2].str() + " values"
                                      : match[2] == "0"    ? "a list of values"
                                                           : match[2].str() + " or more values";
        return length + " separated by '" + separator + "', each " + describe_pattern(match[1]);
      }
      if (std::regex_match(pattern, match, pair))
        return "a pair separated by ':', each " + describe_pattern(match[1]);
      return pattern;
    }

    using Tree = boost::property_tree::ptree;

    /** The only complete view of the declarations that ParameterHandler offers. */
    Tree extract_tree(const ParameterHandler &prm)
    {
      std::stringstream json;
      prm.print_parameters(json, ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
      Tree tree;
      boost::property_tree::read_json(json, tree);
      return tree;
    }

    DeclaredSection extract_section(const std::string &name, const Tree &tree)
    {
      DeclaredSection section{name, {}, {}};
      for (const auto &[child_name, child] : tree)
        if (child.count("pattern_description") > 0)
        {
          const auto pattern = child.get<std::string>("pattern_description");
          section.entries.push_back(
              {child_name, child.get<std::string>("value"), child.get<std::string>("default_value"),
               describe_pattern(pattern), extract_choices(pattern),
               child.get<std::string>("documentation"), pattern == input_file});
        }
        else if (child.count("alias") == 0)
          section.sections.push_back(extract_section(child_name, child));
      return section;
    }

    void collect_values(const DeclaredSection &section, const std::string &path,
                        ParameterValues &values)
    {
      for (const DeclaredEntry &entry : section.entries)
      {
        values[path + entry.name] = entry.value;
        std::string contents;
        if (entry.names_input_file &&
            catch_file_error([&]() { contents = read_whole_file(entry.value); }).empty())
          values[path + entry.name + contents_ending] = compute_checksum(contents);
      }
      for (const DeclaredSection &inner : section.sections)
        collect_values(inner, path + inner.name + "/", values);
    }

    /** ParameterHandler's inner names separate sections by '.' and write ' ' as "_20". */
    std::string demangle(const std::string &path)
    {
      std::string result;
      for (std::size_t i = 0; i < path.size(); ++i)
        if (path[i] == '_' && i + 2 < path.size())
        {
          result += static_cast<char>(std::stoi(path.substr(i + 1, 2), nullptr, 16));
          i += 2;
        }
        else
          result += path[i] == '.' ? '/' : path[i];
      return result;
    }

    /** Makes a text fit into a cell of a table. */
    std::string make_cell(const std::string &text)
    {
      static const std::regex bar(R"(\|)"), blanks(R"(\s+)");
      return std::regex_replace(std::regex_replace(text, bar, "\\|"), blanks, " ");
    }

    void print_markdown(std::ostream &out, const DeclaredSection &section, const std::string &path)
    {
      if (!section.entries.empty())
      {
        if (!path.empty())
          out << "## " << path << "\n\n";
        out << "| Entry | Default | Allowed | Meaning |\n"
            << "|---|---|---|---|\n";
        for (const DeclaredEntry &entry : section.entries)
        {
          const std::string value = make_cell(entry.default_value);
          out << "| " << make_cell(entry.name) << " | " << (value.empty() ? "" : "`" + value + "`")
              << " | " << make_cell(entry.allowed) << " | " << make_cell(entry.documentation)
              << " |\n";
        }
        out << '\n';
      }
      for (const DeclaredSection &inner : section.sections)
        print_markdown(out, inner, path.empty() ? inner.name : path + "/" + inner.name);
    }
  } // namespace

  const DeclaredEntry *DeclaredSection::find_entry(const std::string &name) const
  {
    return find_by_name(entries, name);
  }

  const DeclaredSection *DeclaredSection::find_section(const std::string &name) const
  {
    return find_by_name(sections, name);
  }

  DeclaredSection extract_declared_parameters(const ParameterHandler &prm)
  {
    return extract_section("", extract_tree(prm));
  }

  ParameterValues extract_values(const ParameterHandler &prm)
  {
    ParameterValues values;
    collect_values(extract_declared_parameters(prm), "", values);
    return values;
  }

  std::vector<std::string> extract_missing_entries(const ParameterHandler &prm)
  {
    std::vector<std::string> missing;
    for (const std::string &path : prm.get_entries_wrongly_not_set())
      missing.push_back(demangle(path));
    return missing;
  }

  void print_parameters(std::ostream &out, const ParameterHandler &prm, const std::string &format)
  {
    AssertThrow(format == "prm" || format == "md",
                ExcMessage("Parameters are printed as prm or md, not as <" + format + ">."));
    if (format == "prm")
      prm.print_parameters(out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
    else
      print_markdown(out, extract_declared_parameters(prm), "");
  }
} // namespace caudal
