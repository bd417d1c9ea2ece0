// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/time_stepping.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /**
     * Sums of steps are wrong by less than this part of a step. Steps that differ by it only would
     * make solvers take matrices for new ones.
     */
    constexpr double round_off = 1e-9;
  } // namespace

  void TimeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter(
        "Scheme", scheme,
        "semi-implicit: BDF2, convection and body forces linearised about the extrapolated state; "
        "explicit: midpoint body forces, Crank-Nicolson viscosity, Adams-Bashforth convection.",
        Patterns::Selection("semi-implicit|explicit"));
    prm.add_parameter("End time", end_time, "Simulated time [s].");
    prm.add_parameter("Step", step,
                      "Size of the time step, or of the first one if it is adapted [s].");
    prm.add_parameter("Adaptive", adaptive, "Adapt the step's size to the limits below.");
    prm.add_parameter("Largest step", largest_step, "Upper limit of an adapted step [s].");
    prm.add_parameter("Smallest step", smallest_step,
                      "A step that has to be smaller than this ends the run [s].");
    prm.add_parameter(
        "Body CFL", body_cfl,
        "Adapted steps: largest displacement of the body in a step, in fluid spacings [1].");
    prm.add_parameter(
        "Convective CFL", convective_cfl,
        "Adapted steps: largest |u| dt / h, h the spacing of the velocity nodes [1].");
    prm.add_parameter("Error tolerance", error_tolerance,
                      "Adapted steps: largest difference between the predicted and the computed "
                      "position of the body, in fluid spacings [1].");
    prm.add_parameter("Largest number of retries", largest_number_of_retries,
                      "How often in a row a failed step is tried again with half its size [1].",
                      Patterns::Integer(0));
    prm.leave_subsection();
  }

  void TimeParameters::check() const
  {
    check_positive("Time/End time", end_time);
    check_positive("Time/Step", step);
    check_positive("Time/Largest step", largest_step);
    check_positive("Time/Smallest step", smallest_step);
    check_positive("Time/Body CFL", body_cfl);
    check_positive("Time/Convective CFL", convective_cfl);
    check_positive("Time/Error tolerance", error_tolerance);
    AssertThrow(!adaptive || smallest_step <= largest_step,
                ExcMessage("Time/Largest step: it is less than Time/Smallest step. Make it "
                           "larger."));
    AssertThrow(smallest_step <= step,
                ExcMessage("Time/Smallest step: " + std::to_string(smallest_step) +
                           " s is larger than Time/Step. Make it smaller."));
  }

  bool TimeParameters::is_explicit() const
  {
    return scheme == "explicit";
  }

  TimeWeights TimeWeights::backward_differentiation(const double step, const double previous_step,
                                                    const double older_step, const double curvature)
  {
    if (previous_step == 0)
      return {{1 / step, -1 / step, 0}, {1, 0}, {1, 0, 0}};
    const double ratio = step / previous_step;
    TimeWeights  weights{{(1 + 2 * ratio) / (1 + ratio) / step, -(1 + ratio) / step,
                          ratio * ratio / (1 + ratio) / step},
                        {1 + ratio, -ratio},
                        {1 + ratio, -ratio, 0}};
    if (older_step > 0)
    {
      // Newton's form: the parabola adds (y[n, n-1] - y[n-1, n-2]) factor to the line.
      const double factor =
          curvature * step * (step + previous_step) / (previous_step + older_step);
      weights.transport[0] += factor / previous_step;
      weights.transport[1] -= factor / previous_step + factor / older_step;
      weights.transport[2] += factor / older_step;
    }
    return weights;
  }

  TimeStepper::TimeStepper(const TimeParameters &parameters)
      : parameters(&parameters)
      , step(parameters.step)
      , regular_step(parameters.step)
  {
    choose_step();
  }

  bool TimeStepper::is_at_end() const
  {
    return time >= parameters->end_time * (1 - 1e-12);
  }

  TimeWeights TimeStepper::get_weights(const double step) const
  {
    // Steps that lead to a steady flow in few large leaps would only swing with a parabola.
    constexpr double largest_cfl = 25;
    const double     curvature =
        2. / 3. * std::clamp(2. - convective_rate * step / largest_cfl, 0., 1.);
    return TimeWeights::backward_differentiation(step, previous_step, older_step, curvature);
  }

  void TimeStepper::accept(const double step, const Indicators &indicators)
  {
    // Predicted and computed positions of BDF2 differ by a term of third order in the step.
    const double order = parameters->is_explicit() || previous_step == 0 ? 2 : 3;
    time += step;
    if (std::abs(parameters->end_time - time) < round_off * step)
      time = parameters->end_time;
    older_step      = previous_step;
    previous_step   = step;
    convective_rate = indicators.convective_cfl / step;
    ++step_number;
    if (parameters->adaptive)
    {
      const auto get_growth = [](const double limit, const double value, const double power) {
        return std::pow(limit / std::max(value, 1e-10 * limit), 1 / power);
      };
      const double growth =
          std::min({get_growth(parameters->body_cfl, indicators.body_cfl, 1),
                    get_growth(parameters->convective_cfl, indicators.convective_cfl, 1),
                    get_growth(parameters->error_tolerance, indicators.error, order)});
      regular_step =
          std::min(parameters->largest_step, previous_step * std::clamp(0.9 * growth, 0.5, 1.2));
    }
    choose_step();
  }

  void TimeStepper::check_step() const
  {
    std::ostringstream text;
    text << "Time/Smallest step: at t = " << time << " s the limits of adapted steps ask for "
         << regular_step << " s, which is less than " << parameters->smallest_step
         << " s. Relax Body CFL, Convective CFL or Error tolerance, or look what becomes so fast.";
    AssertThrow(!parameters->adaptive || regular_step >= parameters->smallest_step,
                ExcMessage(text.str()));
  }

  void TimeStepper::resume()
  {
    if (!parameters->adaptive)
      regular_step = parameters->step;
    choose_step();
  }

  void TimeStepper::choose_step()
  {
    // After a rejection the step grows back to its regular size gently: BDF2
    // with variable step is stable up to a ratio of 1 + sqrt(2).
    step = previous_step == 0 ? regular_step : std::min(regular_step, 1.5 * previous_step);
    if (parameters->adaptive)
      step = std::min(step, parameters->largest_step);
    // The last two steps share what is left, so that none of them is tiny.
    const double left = parameters->end_time - time;
    if (left < step * (1 - round_off))
      step = left;
    else if (left > step * (1 + round_off) && left < 2 * step * (1 - round_off))
      step = left / 2;
  }

  double TimeStepper::halve(const double failed_step, const unsigned int n_retries,
                            const std::string &reason) const
  {
    const double half = failed_step / 2;
    AssertThrow(n_retries < parameters->largest_number_of_retries &&
                    half >= parameters->smallest_step,
                ExcMessage(reason + " The step was halved " + std::to_string(n_retries) +
                           " times down to " + std::to_string(failed_step) +
                           " s without success (Time/Largest number of retries, Time/Smallest "
                           "step)."));
    return half;
  }
} // namespace caudal
