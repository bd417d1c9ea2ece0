// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/print.h>
#include <caudal/passage/strategy.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace caudal::passage
{
  namespace
  {
    /** The fish gets on at one speed W over ground: U = V + W. */
    class GroundSpeedStrategy : public Strategy
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Speed", given_speed,
                          "Speed over ground [m/s]; 0: the one that tires the fish least on the "
                          "whole way.");
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Speed", given_speed, "Give a speed, or 0 for the best [m/s].");
      }

      Ascent ascend(const Waterway &waterway, const EnduranceCurve &curve, const Needs &needs,
                    const AscentOptions &options) const override
      {
        const double speed = given_speed > 0. ? given_speed : compute_best(waterway, curve, needs);
        return ascend_at(speed, waterway, curve, needs, options);
      }

      std::string describe() const override
      {
        return given_speed > 0.
                   ? "a constant speed over ground of " + print_number(given_speed) + " m/s"
                   : std::string("the constant speed over ground that tires least");
      }

    private:
      static Ascent ascend_at(const double speed, const Waterway &waterway,
                              const EnduranceCurve &curve, const Needs &needs,
                              const AscentOptions &options)
      {
        const auto behave = [&](const double velocity) -> std::optional<Action> {
          const double swum      = velocity + speed;
          const double endurance = curve.compute_endurance(swum);
          if (velocity >= curve.get_fastest() || endurance == 0.)
            return std::nullopt;
          return Action{{swum, endurance}, 0};
        };
        return compute_ascent(waterway, curve, needs, behave, options);
      }

      /** The minimum of the fatigue: near the best of some speeds there is no other one. */
      static double compute_best(const Waterway &waterway, const EnduranceCurve &curve,
                                 const Needs &needs)
      {
        const int    n               = 24;
        const double first           = std::log(1e-3 * curve.get_fastest());
        const double reach           = ascend_at(std::exp(first), waterway, curve, needs, {}).reach;
        const auto   compute_fatigue = [&](const double log_speed) {
          const Ascent ascent = ascend_at(std::exp(log_speed), waterway, curve, needs, {});
          // A speed that is too much for some place is worse than all that are not. Where no speed
          // gets it on, at a barrier, the one counts that tires least up to there.
          return ascent.reach >= reach
                       ? std::log(std::max(ascent.fatigue, std::numeric_limits<double>::min()))
                       : 1e3 + log_speed;
        };
        const double step  = (std::log(2. * curve.get_fastest()) - first) / n;
        int          best  = 0;
        double       least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= n; ++k)
          if (const double value = compute_fatigue(first + k * step); value < least)
          {
            least = value;
            best  = k;
          }
        const auto minimum = boost::math::tools::brent_find_minima(
            compute_fatigue, first + (best - 1) * step, first + (best + 1) * step, 20);
        return std::exp(minimum.first);
      }

      double given_speed = 0.;
    };

    const Registration<Strategy, GroundSpeedStrategy>
        registration("constant ground speed", "one speed over ground on the whole way");
  } // namespace
} // namespace caudal::passage
