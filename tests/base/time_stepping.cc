// Adapted steps: each indicator acts relative to its own parameter, the error with the third
// root; the smallest step wins, within the bounds of growth and Time/Largest step.

#include <caudal/base/time_stepping.h>

#include <iostream>

using namespace caudal;

namespace
{
  /** The coming step relative to the one before, with limits that are not the defaults. */
  double get_growth(const TimeStepper::Indicators &indicators)
  {
    TimeParameters parameters;
    parameters.adaptive        = true;
    parameters.step            = 1e-3;
    parameters.body_cfl        = 0.5;
    parameters.convective_cfl  = 4;
    parameters.error_tolerance = 0.02;
    TimeStepper stepper(parameters);
    stepper.accept({0.45, 0, 0}); // a step of the same size comes next
    stepper.accept(indicators);
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
            << "all of them far above: " << get_growth({5, 40, 2}) << std::endl;
}
