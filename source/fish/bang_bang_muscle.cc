// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/lateral_force.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace caudal
{
  namespace
  {
    const double never = std::numeric_limits<double>::max();

    /** The integral from 0 to @p x of a sign that turns smoothly from -1 to 1 from 0 on. */
    double sign_integral(const double x, const double duration)
    {
      if (x <= 0.)
        return -x;
      if (x >= duration)
        return x - duration;
      return -duration / numbers::PI * std::sin(numbers::PI * x / duration);
    }

    /**
     * A lateral force density +-F_max g(s,y) e_y that reverses whenever the monitored point has
     * been driven to the switching position on either side (doi:10.1155/2014/489683, section 5).
     * Memory: the direction (1 or -1) and the time of the last switching. Decision: the time of
     * the next one.
     *
     * A force that jumps inside a step is averaged over one step length centred
     * at the time asked for. Schemes that evaluate it in the middle of the step
     * or at its end then see the impulse of the jump at second order, wherever in
     * the step it falls. The time of the crossing is extrapolated linearly from
     * the beginning of the step; one that was missed counts from there.
     *
     * The sign can switch once a step, and again only after the point has been
     * driven across to the other side.
     */
    template <int dim>
    class BangBangMuscle : public LateralForce<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Maximum force density", maximum,
                          "Force per reference volume where the force distribution is 1 [N/m^3].");
        prm.add_parameter("Switching position", switching_position,
                          "Lateral distance of the monitored point from its reference place at "
                          "which the force that drove it there reverses [m].");
        prm.add_parameter("Switching duration", switching_duration,
                          "Time [s] that the force takes to reverse, along a cosine; to be short "
                          "against half a beat. 0 reverses at once.");
        prm.add_parameter("Initial direction", initial_direction,
                          "Direction of the first force: 1 towards +y, -1 towards -y.");
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Maximum force density", maximum,
                           "Give a density that is not negative [N/m^3]; the initial direction "
                           "sets the sign.");
        check_positive(path + "/Switching position", switching_position,
                       "Give a positive distance [m].");
        check_not_negative(path + "/Switching duration", switching_duration,
                           "Give a duration that is not negative [s].");
        check_value(std::abs(initial_direction) == 1, path + "/Initial direction",
                    initial_direction, "Give 1 or -1.");
      }

      MuscleMemory get_initial_memory() const override
      {
        return {static_cast<double>(initial_direction), -switching_duration};
      }

      Contraction contract(const MuscleMemory &memory, const SwimmerState &state,
                           const MuscleCommand &command) const override
      {
        Contraction  contraction = Muscle<dim>::contract(memory, state, command);
        const double direction   = memory[0];
        const double distance    = switching_position - direction * state.lateral_position;
        const double velocity    = direction * state.lateral_velocity;
        const double next        = distance <= 0.  ? state.time
                                   : velocity > 0. ? state.time + distance / velocity
                                                   : never;
        contraction.decision     = {next};
        if (next <= state.time + state.step)
          contraction.after = {-direction, next};
        return contraction;
      }

      double activation(const Contraction &contraction) const override
      {
        return activation_at(contraction, contraction.get_middle());
      }

    protected:
      double amplitude(const Contraction &contraction, const double,
                       const double       time) const override
      {
        return maximum * activation_at(contraction, time);
      }

    private:
      double activation_at(const Contraction &contraction, const double time) const
      {
        const double mean =
            mean_sign(contraction, time - 0.5 * contraction.step, time + 0.5 * contraction.step);
        return this->ramp.value(time) *
               (contraction.command.gain * mean + contraction.command.bias);
      }

      double mean_sign(const Contraction &contraction, const double begin, const double end) const
      {
        const double direction = contraction.before[0], last = contraction.before[1];
        const double next     = contraction.decision[0];
        const auto   integral = [this](const double x) {
          return sign_integral(x, switching_duration);
        };
        double sum = integral(std::min(end, next) - last) - integral(std::min(begin, next) - last);
        if (end > next)
          sum -= integral(end - next) - integral(std::max(0., begin - next));
        return direction * sum / (end - begin);
      }

      double maximum            = 1.5e6;
      double switching_position = 0.05;
      double switching_duration = 0.;
      int    initial_direction  = 1;
    };

    const DimensionalRegistration<Muscle, BangBangMuscle>
        registration("bang-bang", "a lateral force that reverses when the tail has reached a "
                                  "position");
  } // namespace
} // namespace caudal
