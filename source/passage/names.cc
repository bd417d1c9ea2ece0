// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/names.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <numeric>

namespace caudal::passage
{
  namespace
  {
    /** The number of letters to change, insert or remove. */
    std::size_t compute_edits(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0u);
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        std::size_t diagonal = row[0];
        row[0]               = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
          const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
          diagonal                  = row[j + 1];
          row[j + 1]                = std::min({row[j] + 1, row[j + 1] + 1, changed});
        }
      }
      return row.back();
    }
  } // namespace

  std::string lower(const std::string &text)
  {
    return boost::to_lower_copy(text);
  }

  std::string find_nearest_name(const std::string &name, const std::vector<std::string> &names)
  {
    return *std::min_element(
        names.begin(), names.end(), [&](const std::string &a, const std::string &b) {
          return compute_edits(lower(name), lower(a)) < compute_edits(lower(name), lower(b));
        });
  }

  std::string list_names(const std::vector<std::string> &names)
  {
    return boost::join(names, ", ");
  }
} // namespace caudal::passage
