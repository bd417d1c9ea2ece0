// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/endurance_law.h>
#include <caudal/passage/print.h>

#include <limits>

namespace caudal::passage
{
  void DurationRange::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Shortest duration", shortest,
                      "The shortest endurance of the data [s]. Water that is faster than the speed "
                      "which can be held for that long is a velocity barrier.");
    prm.add_parameter("Longest duration", longest,
                      "The longest endurance of the data [s]. No fish chooses to be slower than "
                      "the speed which it can hold for that long.");
  }

  void DurationRange::check(const std::string &path) const
  {
    check_positive(path + "/Shortest duration", shortest, "Give a positive time [s].");
    check_value(longest > shortest, path + "/Longest duration", longest,
                "Give a longer time than the shortest duration [s].");
  }

  std::string DurationRange::describe() const
  {
    return "endurances of " + print_number(shortest) + " to " + print_number(longest) + " s";
  }

  void LengthRange::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Shortest length", shortest,
                      "Length of the shortest fish of the data [m]; shorter ones are answered, but "
                      "marked.");
    prm.add_parameter("Longest length", longest,
                      "Length of the longest fish of the data [m]; 0: not known. Longer ones are "
                      "answered, but marked.");
  }

  void LengthRange::check(const std::string &path) const
  {
    check_not_negative(path + "/Shortest length", shortest, "Give a length, or 0 [m].");
    check_value(longest == 0. || longest > shortest, path + "/Longest length", longest,
                "Give a longer one than the shortest length, or 0 [m].");
  }

  std::pair<double, double> LengthRange::get() const
  {
    return {shortest, longest > 0. ? longest : std::numeric_limits<double>::infinity()};
  }
} // namespace caudal::passage
