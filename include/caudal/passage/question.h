// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_question_h
#define caudal_passage_question_h

#include <caudal/passage/endurance_law.h>
#include <caudal/passage/population.h>
#include <caudal/passage/power_curve.h>
#include <caudal/passage/strategy.h>

namespace caudal::passage
{
  /** Who wants to pass, and how: everything but the water. */
  struct Question
  {
    const EnduranceLaw &law;
    const Strategy     &strategy;
    const Population   &population;

    /** How a fish of this length [m] and ability (see Fish) fares. */
    Ascent ascend(const Waterway &waterway, double length, double ability,
                  const AscentOptions &options = {}) const;

    /** Whether it passes. */
    bool passes(const Waterway &waterway, double length, double ability) const;

    /** The share of fish of this length [m] that pass [1]. */
    double compute_share(const Waterway &waterway, double length) const;

    /** The share of all fish that pass [1]. */
    double compute_share(const Waterway &waterway) const;
  };
} // namespace caudal::passage

#endif
