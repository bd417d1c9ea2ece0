// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_names_h
#define caudal_passage_names_h

#include <string>
#include <vector>

namespace caudal::passage
{
  /** The text in lower case, which names are compared in. */
  std::string lower(const std::string &text);

  /**
   * The name of @p names that is nearest to @p name: by the number of letters to change, insert or
   * remove (Levenshtein 1966).
   */
  std::string find_nearest_name(const std::string &name, const std::vector<std::string> &names);

  /** "a, b, c" */
  std::string list_names(const std::vector<std::string> &names);
} // namespace caudal::passage

#endif
