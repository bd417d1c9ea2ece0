// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/print.h>
#include <caudal/passage/strategy.h>

namespace caudal::passage
{
  namespace
  {
    /**
     * The decisions of FishXing (Furniss et al. 2006, FishXing 3, USDA Forest Service), node by
     * node: the fish swims at its prolonged speed; where the water does not let it get on so, at
     * its burst speed; where that is not enough either, there is a velocity barrier. It is tired
     * after the time to exhaustion of the one or the other; the two times are counted apart. Ours
     * is that it changes to bursts as soon as it would get on at less than a smallest speed over
     * ground: FishXing, whose nodes are apart, needs no such limit.
     */
    class FishXingStrategy : public Strategy
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter(
            "Prolonged time", prolonged_time,
            "Time to exhaustion at the prolonged speed [s], which is the one that the "
            "endurance law has for it.");
        prm.add_parameter("Burst time", burst_time,
                          "Time to exhaustion at the burst speed [s], likewise.");
        prm.add_parameter("Smallest ground speed", smallest,
                          "The fish bursts where its prolonged speed would get it on at less than "
                          "this [m/s].");
      }

      void check(const std::string &path) const override
      {
        check_positive(path + "/Burst time", burst_time, "Give a positive time [s].");
        check_value(prolonged_time > burst_time, path + "/Prolonged time", prolonged_time,
                    "Give a longer time than the burst time [s].");
        check_positive(path + "/Smallest ground speed", smallest, "Give a positive speed [m/s].");
      }

      Ascent ascend(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
                    const AscentOptions &options) const override
      {
        const Effort prolonged{curve.compute_speed(prolonged_time), prolonged_time};
        const Effort burst{curve.compute_speed(burst_time), burst_time};
        const auto   behave = [&](const double velocity) -> std::optional<Action> {
          if (velocity <= prolonged.speed - smallest)
            return Action{prolonged, 0};
          if (velocity < burst.speed)
            return Action{burst, 1};
          return std::nullopt;
        };
        return compute_ascent(waterway, curve, needs, behave, options);
      }

      std::string describe() const override
      {
        return "that of FishXing: the prolonged speed of " + print_number(prolonged_time) +
               " s, the burst speed of " + print_number(burst_time) +
               " s where it is not enough, times counted apart (Furniss et al. 2006, FishXing 3)";
      }

    private:
      double prolonged_time = 1800., burst_time = 5., smallest = 0.05;
    };

    const Registration<Strategy, FishXingStrategy>
        registration("FishXing", "the prolonged speed, or the burst speed where it is not enough");
  } // namespace
} // namespace caudal::passage
