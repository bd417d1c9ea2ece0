// SPDX-License-Identifier: LGPL-2.1-or-later
// Adapted steps: each indicator acts relative to its own parameter, the error with the third
// root; the smallest step wins, within the bounds of growth and Time/Largest step.

#include <caudal/base/time_stepping.h>

#include <deal.II/base/exceptions.h>

#include <iostream>

using namespace caudal;

namespace
{
  /** Limits that are not the defaults. */
  TimeParameters make_parameters()
  {
    TimeParameters parameters;
    parameters.adaptive        = true;
    parameters.step            = 1e-3;
    parameters.body_cfl        = 0.5;
    parameters.convective_cfl  = 4;
    parameters.error_tolerance = 0.02;
    return parameters;
  }

  /** The third step relative to the second. */
  double get_growth(const TimeStepper::Indicators &indicators,
                    const TimeParameters          &parameters = make_parameters())
  {
    TimeStepper stepper(parameters);
    stepper.accept(stepper.get_step(), {0.45, 0, 0}); // a step of the same size comes next
    stepper.accept(stepper.get_step(), indicators);
    return stepper.get_step() / stepper.get_previous_step();
  }
} // namespace

int main()
{
  std::cout << "nothing moves: " << get_growth({0, 0, 0}) << '\n'
            << "all at their limits: " << get_growth({0.5, 4, 0.02}) << '\n'
            << "body CFL 1.5 times its limit: " << get_growth({0.75, 0, 0}) << '\n'
            << "convective CFL 1.5 times its limit: " << get_growth({0, 6, 0}) << '\n'
            << "error 3.375 times its limit: " << get_growth({0, 0, 0.0675}) << '\n'
            << "all of them far above: " << get_growth({5, 40, 2}) << '\n';

  TimeParameters parameters = make_parameters();
  parameters.scheme         = "explicit";
  std::cout << "explicit scheme, error 2.25 times its limit: "
            << get_growth({0, 0, 0.045}, parameters) << '\n';
  parameters              = make_parameters();
  parameters.largest_step = 1.1e-3;
  std::cout << "Largest step of 1.1: " << get_growth({0, 0, 0}, parameters) << '\n';
  parameters.largest_step = 5e-4;
  std::cout << "Largest step of 0.5: " << 1e3 * TimeStepper(parameters).get_step() << '\n';
  parameters               = make_parameters();
  parameters.smallest_step = 9e-4;
  TimeStepper stepper(parameters);
  stepper.check_step();
  stepper.accept(stepper.get_step(), {5, 0, 0});
  try
  {
    stepper.check_step();
  }
  catch (const dealii::ExceptionBase &)
  {
    std::cout << "a step below Smallest step is refused" << std::endl;
  }
}
