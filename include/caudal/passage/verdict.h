// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_verdict_h
#define caudal_passage_verdict_h

#include <caudal/passage/question.h>

namespace caudal::passage
{
  /** How able a fish of a band is. */
  struct Band
  {
    double      ability;
    double      share; // of the fish that are better [1]
    std::string name;  // "median"
  };

  /**
   * The median and the limits of the bands that hold 75 and 95 % of the fish, from the weakest to
   * the strongest.
   */
  const std::vector<Band> &get_bands();

  /** The number of the median in them. */
  constexpr std::size_t median_band = 2;

  /** The answer for a fish of the mean length and of a band. */
  struct BandAnswer
  {
    Ascent ascent;

    /** The factor on all velocities with which it just passes; 0: it does not with any. */
    double velocity_factor = 0.;

    /** The largest velocity that it passes, where that of the profile is [m/s]; NaN in still water.
     */
    double largest_velocity = 0.;

    /** The smallest length that passes [m]; NaN: none does. */
    double smallest_length = 0.;
  };

  /** The answer for the waterway at one discharge. */
  struct Verdict
  {
    Waterway                 waterway;
    double                   share = 0.; // of all fish that pass [1]
    std::vector<BandAnswer>  bands;
    std::string              sentence; // what happens, where, and why
    std::vector<std::string> marks;    // sentences on the limits of validity
  };

  /** "green", "amber" or "red": at least 87.5 %, at least half, or less of the fish pass. */
  std::string get_colour(double share);

  Verdict compute_verdict(const Question &question, const PowerCurve &power,
                          const Waterway &waterway);

  /** How a fish fares in words, to follow its name: "is exhausted at 31.2 m, ...". */
  std::string describe_ascent(const Ascent &ascent, const Waterway &waterway, const Needs &needs);

  /** Sentences on where fish of these lengths are beyond the data of the law. */
  std::vector<std::string> mark_lengths(const Question &question);
} // namespace caudal::passage

#endif
