// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_parameter_text_h
#define caudal_base_parameter_text_h

#include <istream>
#include <string>
#include <vector>

namespace caudal
{
  /** A name, in which repeated blanks count as one. */
  std::string tidy_name(const std::string &text);

  /** The names with the separator between them, and another one, if given, before the last. */
  std::string join(const std::vector<std::string> &names, const std::string &separator);
  std::string join(const std::vector<std::string> &names, const std::string &separator,
                   const std::string &last_separator);

  /** Where a comment begins in @p text: at a '#' at its start or behind a blank. */
  std::size_t find_comment(const std::string &text);

  /**
   * Reads the next line that is not empty, with its continuations and without comments, and
   * counts the lines: @p number is that of the first of them.
   */
  bool read_line(std::istream &stream, std::string &line, unsigned int &number, unsigned int &next);

  /** Whether @p text has entries, and each subsection has its end. */
  bool is_whole_parameter_file(const std::string &text);

  /** The text with whole numbers like 1e5 or 2.5e3 written out. */
  std::string write_out_whole_numbers(const std::string &text);
} // namespace caudal

#endif
