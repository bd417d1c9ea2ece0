// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_design_h
#define caudal_passage_design_h

#include <caudal/passage/question.h>
#include <caudal/passage/water_source.h>

namespace caudal
{
  struct WayParameters;
}

namespace caudal::passage
{
  /** Section `Design`: what is to be found so that enough fish pass. */
  struct DesignParameters
  {
    std::string target = "none";
    double      share  = 0.875;

    void add_parameters(ParameterHandler &prm);
    void check(const WaterSource &source) const;

    bool is_asked_for() const
    {
      return target != "none";
    }
  };

  /** The answer at one discharge. */
  struct DesignAnswer
  {
    double                discharge; // [m^3/s]
    std::optional<double> value;     // slope [1] or distance [m]; nothing if there is none
    std::string           sentence;
  };

  /** "largest slope [1]" */
  std::string get_design_column(const DesignParameters &parameters);

  /**
   * The value at which just the share of fish that is asked for passes the @p waterway: the largest
   * slope of the channel, everything else as it is; the longest reach in water like the fastest
   * of the way; or the largest distance between places of whole rest, the way cut in equal parts.
   */
  DesignAnswer solve_design(const DesignParameters &parameters, const Question &question,
                            const WayParameters &way, const Waterway &waterway);
} // namespace caudal::passage

#endif
