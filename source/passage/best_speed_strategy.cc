// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/strategy.h>

namespace caudal::passage
{
  namespace
  {
    /**
     * At each place the speed that takes the fish furthest in such water, so that D = int ds/X(V):
     * the least fatigue of all choices (Castro-Santos 2005, doi:10.1242/jeb.01380).
     */
    class BestSpeedStrategy : public Strategy
    {
    public:
      Ascent ascend(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
                    const AscentOptions &options) const override
      {
        const auto behave = [&curve](const double velocity) -> std::optional<Action> {
          const auto best =
              velocity < curve.get_fastest() ? curve.compute_best_effort(velocity) : std::nullopt;
          return best ? std::optional<Action>({*best, 0}) : std::nullopt;
        };
        return compute_ascent(waterway, curve, needs, behave, options);
      }

      std::string describe() const override
      {
        return "the best speed everywhere: max (U - V) T(U), fatigue D = int ds/X(V(s)) "
               "(Castro-Santos 2005, doi:10.1242/jeb.01380)";
      }
    };

    const Registration<Strategy, BestSpeedStrategy>
        registration("best speed", "at each place the speed that tires least on the way");
  } // namespace
} // namespace caudal::passage
