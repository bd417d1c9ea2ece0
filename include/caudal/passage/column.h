// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_column_h
#define caudal_passage_column_h

#include <caudal/fish/number_table.h>
#include <caudal/passage/units.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>

namespace caudal::passage
{
  /**
   * A column of a table from another program: the entries `Column of <quantity>` and `Unit of
   * <quantity>` of the section that it is in.
   */
  class Column
  {
  public:
    Column(const std::string &quantity, const std::string &name, const Units &units,
           const std::string &unit);

    void add_parameters(dealii::ParameterHandler &prm);

    /**
     * Number of the column in the table, or nothing if its header lacks it. A unit there, as in
     * "velocity [ft/s]", has to be that of the entry; @p path is the section's.
     */
    std::optional<std::size_t> find(const TextTable &table, const std::string &path) const;

    /**
     * find() of a column that may be missing: nothing if the entry is empty, or if it was left as
     * it is and there is no such column; one that was named has to be there.
     */
    std::optional<std::size_t> find_optional(const TextTable &table, const std::string &path) const;

    /** find() of a column that has to be there: else throws with the names that are. */
    std::size_t require(const TextTable &table, const std::string &path) const;

    /** The value of that column in a row, in SI units. */
    double read(const TextTable::Row &row, std::size_t column) const;

    /** The factor from its unit to SI. */
    double get_factor() const
    {
      return units.at(unit);
    }

    const std::string &get_quantity() const
    {
      return quantity;
    }

  private:
    const std::string quantity, preset_name;
    std::string       name;
    const Units      &units;
    std::string       unit;
  };

  /**
   * The rows of two columns of a table in SI units, sorted by the first. Throws a sentence unless
   * there is a row, all are positive, and each value of the first column stands there once. The
   * entry `File` of section @p path names the table.
   */
  std::vector<std::pair<double, double>> read_pairs(const std::string &path,
                                                    const std::string &file, const Column &first,
                                                    const Column &second);

  /** Moves a row of units in parentheses, which HEC-RAS puts below the header, into the header. */
  void move_units_to_header(TextTable &table);
} // namespace caudal::passage

#endif
