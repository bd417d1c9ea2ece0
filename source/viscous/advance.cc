// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/advance.h>

#include <deal.II/lac/solver_control.h>

namespace caudal
{
  namespace
  {
    std::string get_sentence(const ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      return Utilities::trim(text.str());
    }
  } // namespace

  template <int dim>
  Step<dim> advance(const Operators<dim> &operators, const State<dim> &state, const double dt)
  {
    const auto scheme =
        Registry<TimeScheme<dim>>::get_members().at(operators.parameters.time.scheme).create();
    Step<dim> step{{state.time, {}, {}, state.solver}, {}};
    try
    {
      scheme->advance(operators, state, dt, step);
    }
    catch (const SolverControl::NoConvergence &exception)
    {
      throw StepFailure(
          "The linear solver did not converge (residual " +
              std::to_string(exception.last_residual) + "; Solver/Largest number of iterations).",
          "Likely the forces on a body change too much within a step, or the tolerance is "
          "below the round-off: reduce Time/Step (or set Time/Adaptive), soften the feedback "
          "springs, or increase Solver/Tolerance or Solver/Largest number of iterations.",
          step.state.bodies);
    }
    catch (const ExcInvertedElement &exception)
    {
      throw StepFailure(
          get_sentence(exception),
          "Likely the body is pushed together there faster than the step or its elements "
          "resolve: reduce Time/Step, the force of the muscle, or increase Body/Region/"
          "Volumetric stabilisation; a finer fluid grid (Domain/Levels) keeps volumes better.",
          step.state.bodies);
    }
    catch (const ExcNotFinite &exception)
    {
      throw StepFailure(
          get_sentence(exception),
          "Likely the flow or a force grew without bound: reduce Time/Step, look at the "
          "forces and at the inflow that the parameters prescribe, and at the last rows of "
          "statistics.txt.",
          step.state.bodies);
    }
    return step;
  }

  template Step<2> advance(const Operators<2> &, const State<2> &, double);
  template Step<3> advance(const Operators<3> &, const State<3> &, double);
} // namespace caudal
