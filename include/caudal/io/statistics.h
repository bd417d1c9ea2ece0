// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_statistics_h
#define caudal_io_statistics_h

#include <deal.II/base/exceptions.h>

#include <fstream>
#include <string>
#include <vector>

namespace caudal
{
  /** The unit of an extensive quantity: in two dimensions it is per metre of span. */
  template <int dim>
  std::string get_extensive_unit(const std::string &unit)
  {
    return dim == 2 ? unit + "/m" : unit;
  }

  /**
   * Writes the rows of @p table, a file of Statistics, to @p csv, separated by commas and below one
   * row of the columns' names and units.
   */
  void write_csv(const std::string &table, const std::string &csv);

  /**
   * A table with a row per time step and a column per quantity, as a text file
   * for gnuplot, numpy.loadtxt and the eye: headers "# n: name [unit]", then
   * rows of numbers with ten significant digits, each row flushed.
   *
   * The first row decides which columns there are; later ones are set in the same order. The
   * first quantity that is set has to be the time. If the first row of a resumed run has other
   * columns than those before, the old table is kept under another name, and a new one begins.
   */
  class Statistics
  {
  public:
    DeclException1(ExcColumn, std::string,
                   << "The statistics' column <" << arg1
                   << "> is missing in this row, is set twice in it, or was not in the first row.");

    /**
     * Empties @p file, or keeps the rows of an earlier run up to the time @p kept_time [s]
     * to append new ones. Without a name (on all ranks but 0) nothing is written.
     */
    explicit Statistics(const std::string &file, double kept_time = -1);

    /** The value of a quantity in the coming row. A value that is not finite throws. */
    void set(const std::string &name, const std::string &unit, double value);

    void write_row();

    /** Whether the last row that was kept is that of this time [s]. */
    bool has_row_at(double time) const;

    /** The name of the file that has the rows of before the columns changed, or nothing. */
    const std::string &get_earlier_file() const
    {
      return earlier_file;
    }

    /** The name of the file that has the damaged lines of the earlier run, or nothing. */
    const std::string &get_damaged_file() const
    {
      return damaged_file;
    }

    /** Sentences about what was wrong with the rows of the earlier run. */
    const std::vector<std::string> &get_damages() const
    {
      return damages;
    }

  private:
    const std::string        file_name;
    std::ofstream            file;
    std::vector<std::string> headers; // name [unit]
    std::vector<double>      row;     // what is set of the coming one
    bool                     has_rows;
    std::vector<std::string> old_headers; // of the earlier run, until the first row is written
    std::string              earlier_file, damaged_file;
    double                   last_time = -1; // [s] of the rows that were kept
    std::size_t              size      = 0;  // of the file [bytes]
    std::vector<std::string> damages;

    std::string read_rows(double time);
    std::string find_earlier_name() const;
    void        begin_new_table();
  };
} // namespace caudal

#endif
