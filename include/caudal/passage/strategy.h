// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_strategy_h
#define caudal_passage_strategy_h

#include <caudal/base/plugin.h>
#include <caudal/passage/ascent.h>

namespace caudal::passage
{
  /** Which speeds a fish chooses on its way. */
  class Strategy : public Plugin
  {
  public:
    /** How a fish of this endurance fares that chooses its speeds so. */
    virtual Ascent ascend(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
                          const AscentOptions &options = {}) const = 0;

    /** The rule in words, for reports. */
    virtual std::string describe() const = 0;
  };
} // namespace caudal::passage

#endif
