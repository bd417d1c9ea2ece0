#ifndef caudal_ideal_number_table_h
#define caudal_ideal_number_table_h

#include <string>
#include <vector>

namespace caudal::ideal
{
  /**
   * The rows of numbers in a text file, entries separated by commas or blanks, comments from
   * '#' on; a first row of words is skipped. Each row has @p n_columns numbers. @p entry is
   * the section and entry of the .prm that error messages name, together with file and line.
   */
  std::vector<std::vector<double>>
  read_number_table(const std::string &entry, const std::string &file_name, unsigned int n_columns);

  /** The same from a text in which ';' separates the rows. */
  std::vector<std::vector<double>>
  parse_number_table(const std::string &entry, const std::string &text, unsigned int n_columns);
} // namespace caudal::ideal

#endif
