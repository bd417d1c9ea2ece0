// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_declared_parameters_h
#define caudal_base_declared_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** An entry as it was declared to a ParameterHandler. */
  struct DeclaredEntry
  {
    std::string              name;
    std::string              value; // at present
    std::string              default_value;
    std::string              allowed; // in words: "a number >= 0"
    std::vector<std::string> choices; // if one of some names is allowed
    std::string              documentation;
    bool                     names_input_file = false;
  };

  /** What was declared in a section of a ParameterHandler, in that order. */
  struct DeclaredSection
  {
    std::string                  name;
    std::vector<DeclaredEntry>   entries;
    std::vector<DeclaredSection> sections;

    /** The entry of that name, or nullptr. */
    const DeclaredEntry *find_entry(const std::string &name) const;

    /** The section of that name, or nullptr. */
    const DeclaredSection *find_section(const std::string &name) const;
  };

  /** The values of all entries, by "Section/Entry", and the checksums of input files. */
  using ParameterValues = std::map<std::string, std::string>;

  /** Ends the path under which the checksum of a file stands beside the entry that names it. */
  const std::string contents_ending = " (contents)";

  ParameterValues extract_values(const ParameterHandler &prm);

  /** Everything that was declared, as the nameless section around it. */
  DeclaredSection extract_declared_parameters(const ParameterHandler &prm);

  /** The entries that were declared as to be set and are not, as "Section/Entry". */
  std::vector<std::string> extract_missing_entries(const ParameterHandler &prm);

  /**
   * Prints the declared parameters with their documentation: as a parameter
   * file ("prm"), or as a reference in Markdown with one table for each
   * section ("md").
   */
  void print_parameters(std::ostream &out, const ParameterHandler &prm, const std::string &format);
} // namespace caudal

#endif
