// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_population_h
#define caudal_passage_population_h

#include <caudal/passage/ascent.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace caudal::passage
{
  /** Fish of about the same length. */
  struct LengthClass
  {
    double length; // [m]
    double share;  // of all fish [1]
  };

  /** Section `Fish`: who is to pass. */
  struct Population
  {
    std::string species      = "Atlantic salmon";
    double      length       = 0.5; // [m]
    double      spread       = 0.;  // standard deviation of the length [m]
    std::string distribution = "normal";
    std::string classes_text; // instead of them
    double      number = 0.;  // of fish; 0: not asked for
    Needs       needs;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /** The classes; their shares add up to 1. One class if all fish have one length. */
    std::vector<LengthClass> make_classes() const;

    /** The mean length [m]. */
    double compute_mean_length() const;
  };

  /** The largest length [m] that is believed. */
  constexpr double largest_length = 5.;

  /** Throws a sentence, which begins with @p entry, if no fish has that length [m]. */
  void check_fish_length(const std::string &entry, double length);
} // namespace caudal::passage

#endif
