// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_checks_h
#define caudal_base_checks_h

#include <optional>
#include <string>

namespace caudal
{
  /**
   * Checks of values that the user gives. Each throws, if @p value is not as it should be, the
   * sentences "<path>: the value is <value>. <remedy>"; the remedy is an order, "Give a positive
   * length [m].".
   */
  void check_value(bool is_right, const std::string &path, double value, const std::string &remedy);

  void check_finite(const std::string &path, double value,
                    const std::string &remedy = "Give a finite number.");

  void check_positive(const std::string &path, double value,
                      const std::string &remedy = "Give a positive number.");

  void check_not_negative(const std::string &path, double value,
                          const std::string &remedy = "Give 0 or a positive number.");

  /**
   * The number that an entry gives, or nothing if it says `automatic`; throws a sentence with
   * @p remedy, "Give automatic or a number [m^2/s].", if it is neither.
   */
  std::optional<double> read_unless_automatic(const std::string &path, const std::string &text,
                                              const std::string &remedy);

  /**
   * Checks a @p name that the user gives, which becomes part of the names of files, sections and
   * columns: letters (of any alphabet), digits, '_', '-', '+' and blanks within.
   */
  void check_name(const std::string &path, const std::string &name);

  /** Both bounds are allowed. */
  void check_between(const std::string &path, double value, double lowest, double highest,
                     const std::string &remedy);
} // namespace caudal

#endif
