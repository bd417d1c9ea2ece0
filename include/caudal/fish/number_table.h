// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_number_table_h
#define caudal_fish_number_table_h

#include <string>
#include <vector>

namespace caudal
{
  /** A table as texts, with the place where each row stands for messages about it. */
  struct TextTable
  {
    struct Row
    {
      std::vector<std::string> fields;
      std::string              place; ///< "Passage/Profile/File: culvert.csv, line 3: "
    };

    std::vector<std::string> header; ///< the words of a first row that begins with one
    std::string              header_place;
    std::vector<Row>         rows;
  };

  /** A table of numbers, with the place where each row stands for messages about it. */
  struct NumberTable
  {
    struct Row
    {
      std::vector<double> values;
      std::string         place; ///< "Gait/Table/File: angles.csv, line 3: "
    };

    std::vector<std::string> header; ///< the words of a first row that begins with one
    std::string              header_place;
    std::vector<Row>         rows;
  };

  /** Whether @p field says a finite number. */
  bool is_number(const std::string &field);

  /** The number that @p field says; throws a sentence, which begins with @p place, if it is none.
   */
  double parse_number(const std::string &field, const std::string &place);

  /**
   * The rows in a text file, as spreadsheets write it: entries separated by commas, semicolons or
   * blanks, perhaps in quotes, comments from '#' on, see read_text_file(). A first row that begins
   * with a word is the header. Throws a sentence if the file can't be read. @p entry is the section
   * and entry of the .prm that messages name, together with file and line.
   */
  TextTable read_text_table(const std::string &entry, const std::string &file_name);

  /**
   * The same of numbers. Throws a sentence about the first bad row, also unless each one has
   * @p n_columns numbers, of which 0 allows any number.
   */
  NumberTable read_number_table(const std::string &entry, const std::string &file_name,
                                unsigned int n_columns);

  /** Reads a table from a text in which ';' separates the rows. */
  NumberTable parse_number_table(const std::string &entry, const std::string &text,
                                 unsigned int n_columns);

  /**
   * Throws a sentence unless a table from @p begin to @p end [s] covers a run until @p end_time
   * [s]. It is that of the section @p section, "Gait" or "Muscle", of the body with the section @p
   * path.
   */
  void check_table_times(const std::string &path, const std::string &section, double begin,
                         double end, double end_time);
} // namespace caudal

#endif
