// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/body_function.h>
#include <caudal/fish/gait.h>

#include <memory>

namespace caudal
{
  namespace
  {
    /**
     * A given lateral displacement y(x,t) at fixed x, times the start-up ramp, as measured fish
     * and other programs' swimmers are described: sections stay where they are along the axis and
     * are shifted sideways as a whole. This keeps the volume of any body, while its midline gets
     * longer where it is inclined.
     */
    class DisplacementGait : public Gait
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Function", text,
                          "Lateral displacement y of the midline in the body's frame [m], whose x "
                          "axis points to the tail: a function of s, the distance from the nose "
                          "along the axis over the body length (0 nose, 1 tail), and of the time t "
                          "[s].");
        prm.add_parameter("Frequency", frequency,
                          "How often it repeats in a second [Hz]; 0: not, or not known.");
      }

      void check(const std::string &path) const override
      {
        BodyFunction(path + "/Function", "s,t", text).check_along();
        check_not_negative(path + "/Frequency", frequency, "Give a positive frequency [Hz], or 0.");
      }

      void set_up(const SharedGaitParameters &shared_parameters, const double length) override
      {
        Gait::set_up(shared_parameters, length);
        displacement = std::make_shared<BodyFunction>("Gait/Displacement/Function", "s,t", text);
      }

      std::vector<double> get_frequencies() const override
      {
        return {frequency};
      }

      bool shifts_sections() const override
      {
        return true;
      }

      std::vector<Motion> compute_shifts(const std::vector<double> &x,
                                         const double               argument) const override
      {
        const double        rate = get_argument_rate(frequency), time = argument / rate;
        const StartUpRamp  &ramp = shared.ramp;
        std::vector<Motion> shifts;
        for (const double place : x)
        {
          const double s = place / length, value = displacement->value(s, time);
          // At the phase of a periodic gait there is no start-up.
          const double growth = is_periodic() ? 1. : ramp.value(time);
          shifts.push_back(
              {growth * value,
               (growth * displacement->rate(s, time) + ramp.rate(time) * value) / rate});
        }
        return shifts;
      }

    protected:
      bool has_period() const override
      {
        return frequency > 0.;
      }

    private:
      std::string                         text      = "0";
      double                              frequency = 0.;
      std::shared_ptr<const BodyFunction> displacement;
    };

    const Registration<Gait, DisplacementGait>
        registration("displacement", "the lateral displacement at fixed x, a given function (in a "
                                     "viscous fluid)");
  } // namespace
} // namespace caudal
