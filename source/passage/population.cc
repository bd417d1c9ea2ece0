// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/number_table.h>
#include <caudal/passage/population.h>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>

#include <cmath>

namespace caudal::passage
{
  using namespace dealii;

  namespace
  {
    // Of equal numbers of fish: the share that passes is right within half of 1/40 if all of a
    // length fare alike, and far better where they differ.
    const unsigned int n_classes = 40;
  } // namespace

  void check_fish_length(const std::string &entry, const double length)
  {
    check_positive(entry, length, "Give a positive length [m].");
    check_value(length <= largest_length, entry, length,
                "No fish that passes here is that long: lengths are in metres.");
  }

  void Population::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fish");
    prm.add_parameter("Species", species,
                      "The species, or its group, as the endurance law calls it.");
    prm.add_parameter("Length", length, "Fork length of the fish, or its mean [m].");
    prm.add_parameter("Standard deviation of length", spread,
                      "Of the lengths [m]; 0: all are "
                      "equal.");
    prm.add_parameter("Distribution of length", distribution, "Of the lengths about their mean.",
                      Patterns::Selection("normal|lognormal"));
    prm.add_parameter("Length classes", classes_text,
                      "Instead of length and distribution: rows of a length [m] and the number of "
                      "fish, separated by semicolons.",
                      Patterns::Anything());
    prm.add_parameter("Number", number, "How many fish arrive; 0: only shares are told [1].");
    prm.add_parameter("Minimum depth", needs.depth, "The least depth that they swim in [m].");
    prm.add_parameter("Largest drop", needs.largest_drop,
                      "The highest drop that is allowed [m]; 0: any that they can leap or swim.");
    prm.add_parameter("Leap speed", needs.leap_speed,
                      "The speed at which they leap [m/s]; 0: the one that they can hold for the "
                      "shortest duration of the endurance law.");
    prm.leave_subsection();
  }

  void Population::check() const
  {
    check_fish_length("Fish/Length", length);
    check_not_negative("Fish/Standard deviation of length", spread);
    check_value(spread < 0.4 * length, "Fish/Standard deviation of length", spread,
                "Give less than 0.4 of the length [m].");
    check_not_negative("Fish/Number", number);
    check_not_negative("Fish/Minimum depth", needs.depth, "Give a depth of 0 or more [m].");
    check_value(needs.depth < largest_length, "Fish/Minimum depth", needs.depth,
                "Depths are in metres.");
    check_not_negative("Fish/Largest drop", needs.largest_drop);
    check_not_negative("Fish/Leap speed", needs.leap_speed);
    make_classes();
  }

  std::vector<LengthClass> Population::make_classes() const
  {
    std::vector<LengthClass> classes;
    if (!classes_text.empty())
    {
      const NumberTable table = parse_number_table("Fish/Length classes", classes_text, 2);
      double            sum   = 0.;
      for (const NumberTable::Row &row : table.rows)
      {
        check_fish_length(row.place + "length", row.values[0]);
        check_not_negative(row.place + "number", row.values[1]);
        classes.push_back({row.values[0], row.values[1]});
        sum += row.values[1];
      }
      check_positive("Fish/Length classes: sum of the numbers", sum);
      for (LengthClass &length_class : classes)
        length_class.share /= sum;
    }
    else if (spread == 0.)
      classes.push_back({length, 1.});
    else
      for (unsigned int k = 0; k < n_classes; ++k)
      {
        const double level = (k + 0.5) / n_classes;
        // Mean and deviation of the lengths, not of their logarithms, are given.
        const double                 log_variance = std::log1p(spread * spread / (length * length));
        const boost::math::lognormal lognormal(std::log(length) - 0.5 * log_variance,
                                               std::sqrt(log_variance));
        classes.push_back({distribution == "normal"
                               ? quantile(boost::math::normal(length, spread), level)
                               : quantile(lognormal, level),
                           1. / n_classes});
        check_fish_length("Fish/Standard deviation of length: a length", classes.back().length);
      }
    return classes;
  }

  double Population::compute_mean_length() const
  {
    if (classes_text.empty())
      return length;
    double mean = 0.;
    for (const LengthClass &length_class : make_classes())
      mean += length_class.share * length_class.length;
    return mean;
  }
} // namespace caudal::passage
