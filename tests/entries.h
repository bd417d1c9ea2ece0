// SPDX-License-Identifier: LGPL-2.1-or-later
// Sets entries of a parameter file in tests.
#ifndef caudal_tests_entries_h
#define caudal_tests_entries_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <map>
#include <string>

// "Section/Entry" -> value
using Entries = std::map<std::string, std::string>;

inline void set_entries(dealii::ParameterHandler &prm, const Entries &entries)
{
  std::string text;
  for (const auto &[path, value] : entries)
  {
    const auto names = dealii::Utilities::split_string_list(path, '/');
    for (std::size_t i = 0; i + 1 < names.size(); ++i)
      text += "subsection " + names[i] + "\n";
    text += "set " + names.back() + " = " + value + "\n";
    for (std::size_t i = 0; i + 1 < names.size(); ++i)
      text += "end\n";
  }
  prm.parse_input_from_string(text);
}

// Sets entries of a struct that declares its own section.
template <class Parameters>
void set_entries(Parameters &parameters, const std::string &section, const Entries &entries)
{
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  Entries in_section;
  for (const auto &[path, value] : entries)
    in_section[section + "/" + path] = value;
  set_entries(prm, in_section);
}

#endif
