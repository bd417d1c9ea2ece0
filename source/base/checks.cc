// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

using namespace dealii;

namespace caudal
{
  void check_value(const bool is_right, const std::string &path, const double value,
                   const std::string &remedy)
  {
    if (is_right && std::isfinite(value))
      return;
    std::ostringstream text;
    text << std::setprecision(std::numeric_limits<double>::digits10) << path << ": the value is "
         << value << ". " << remedy;
    AssertThrow(false, ExcMessage(text.str()));
  }

  std::optional<double> read_unless_automatic(const std::string &path, const std::string &text,
                                              const std::string &remedy)
  {
    if (text == "automatic")
      return {};
    AssertThrow(Patterns::Double().match(text),
                ExcMessage(path + ": the value is <" + text + ">. " + remedy));
    return Utilities::string_to_double(text);
  }

  void check_finite(const std::string &path, const double value, const std::string &remedy)
  {
    check_value(true, path, value, remedy);
  }

  void check_positive(const std::string &path, const double value, const std::string &remedy)
  {
    check_value(value > 0, path, value, remedy);
  }

  void check_not_negative(const std::string &path, const double value, const std::string &remedy)
  {
    check_value(value >= 0, path, value, remedy);
  }

  void check_name(const std::string &path, const std::string &name)
  {
    const auto is_allowed = [](const char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte >= 0x80 || std::isalnum(byte) || c == '_' || c == '-' || c == '+' || c == ' ';
    };
    AssertThrow(!name.empty() && std::all_of(name.begin(), name.end(), is_allowed),
                ExcMessage(path + ": the name <" + name +
                           "> can't be part of the names of files. Use letters, digits, blanks, "
                           "'_', '-' and '+' only."));
  }

  void check_between(const std::string &path, const double value, const double lowest,
                     const double highest, const std::string &remedy)
  {
    check_value(lowest <= value && value <= highest, path, value, remedy);
  }
} // namespace caudal
