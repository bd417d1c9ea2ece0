// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/parameter_text.h>
#include <caudal/base/suggestions.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace caudal
{
  namespace
  {
    using Names = std::vector<std::string>;

    /** More places of the same name than these are no help. */
    constexpr std::size_t most_places = 4;

    template <class Named>
    Names get_names(const std::vector<Named> &list)
    {
      Names names;
      for (const Named &one : list)
        names.push_back(one.name);
      return names;
    }

    bool is_same_letter(const char a, const char b)
    {
      return std::tolower(static_cast<unsigned char>(a)) ==
             std::tolower(static_cast<unsigned char>(b));
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
          const unsigned int cost = std::min(
              {diagonal + (is_same_letter(a[i], b[j]) ? 0 : 1), row[j] + 1, row[j + 1] + 1});
          diagonal   = row[j + 1];
          row[j + 1] = cost;
        }
      }
      return row.back();
    }

    /** How many letters may be wrong in a name that is still recognised. */
    std::size_t get_tolerance(const std::string &name)
    {
      return 1 + name.size() / 4;
    }

    /** The known name nearest to @p name; empty if none is near. */
    std::string find_near(const std::string &name, const Names &known)
    {
      const auto nearest =
          std::min_element(known.begin(), known.end(), [&](const auto &a, const auto &b) {
            return compute_edit_distance(name, a) < compute_edit_distance(name, b);
          });
      return nearest != known.end() && compute_edit_distance(name, *nearest) <= get_tolerance(name)
                 ? *nearest
                 : "";
    }

    /** The paths of all entries, or of all sections, within @p section. */
    Names collect_paths(const DeclaredSection &section, const bool of_entries,
                        const std::string &path = "")
    {
      Names paths;
      if (of_entries)
        for (const DeclaredEntry &entry : section.entries)
          paths.push_back(path + entry.name);
      for (const DeclaredSection &inner : section.sections)
      {
        if (!of_entries)
          paths.push_back(path + inner.name);
        const Names deeper = collect_paths(inner, of_entries, path + inner.name + "/");
        paths.insert(paths.end(), deeper.begin(), deeper.end());
      }
      return paths;
    }

    /** The last name of a path. */
    std::string get_last_name(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1); // all of it without a slash
    }

    /** Those of the paths that end with the name, or with the one nearest to it. */
    Names find_places(const std::string &name, const Names &paths)
    {
      Names last_names, places;
      for (const std::string &path : paths)
        last_names.push_back(get_last_name(path));
      const std::string meant = find_near(name, last_names);
      for (const std::string &path : paths)
        if (!meant.empty() && get_last_name(path) == meant)
          places.push_back(path);
      return places;
    }

    bool is_same(const std::string &a, const std::string &b)
    {
      return compute_edit_distance(a, b) == 0;
    }

    /** @p known here and the paths of all that there are. */
    std::string suggest(const std::string &name, const Names &known, const Names &paths)
    {
      const std::string near   = find_near(name, known);
      const Names       places = find_places(name, paths);
      const bool        is_elsewhere =
          !places.empty() && places.size() <= most_places &&
          (near.empty() || (is_same(get_last_name(places[0]), name) && !is_same(near, name)));
      Names meant;
      if (is_elsewhere)
        meant = places;
      else if (!near.empty())
        meant = {near};
      for (std::string &one : meant)
        one = "<" + one + ">";
      return (meant.empty() ? "" : "Did you mean " + join(meant, ", ", " or ") + "? ") +
             (known.empty() ? "There are none there." : "Known there: " + join(known, ", ") + ".");
    }
  } // namespace

  std::string suggest_entry(const std::string &name, const DeclaredSection &section,
                            const DeclaredSection &declared)
  {
    return suggest(name, get_names(section.entries), collect_paths(declared, true));
  }

  std::string suggest_section(const std::string &name, const DeclaredSection &section,
                              const DeclaredSection &declared)
  {
    return suggest(name, get_names(section.sections), collect_paths(declared, false));
  }
} // namespace caudal
