// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/resume.h>

#include <algorithm>
#include <regex>

namespace caudal
{
  namespace
  {
    std::string get_value(const ParameterValues &values, const std::string &path)
    {
      const auto found = values.find(path);
      return found == values.end() ? "not there" : "<" + found->second + ">";
    }
  } // namespace

  std::vector<std::string> compare_parameters(const ParameterValues &before,
                                              const ParameterValues &now, const std::string &fixed)
  {
    const std::regex fixed_entries(fixed);
    ParameterValues  all = now;
    all.insert(before.begin(), before.end());
    all.erase("Output/Folder"); // it may have been moved

    std::vector<std::string> changes, refused;
    for (const auto &entry : all)
    {
      const std::string &path      = entry.first;
      const std::string  old_value = get_value(before, path), new_value = get_value(now, path);
      if (old_value == new_value)
        continue;
      changes.push_back(path + ": " + old_value + " before, now " + new_value);
      if (std::regex_match(path, fixed_entries))
        refused.push_back(changes.back());
    }
    std::string list;
    for (const std::string &change : refused)
      list += "\n  " + change;
    AssertThrow(
        refused.empty(),
        ExcMessage("A run can't be resumed with another grid, other bodies, other gaits or another "
                   "scheme. Leave these as they were, or start a new run:" +
                   list));
    return changes;
  }
} // namespace caudal
