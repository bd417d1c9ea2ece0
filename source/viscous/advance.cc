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
    Step<dim> step{{state.time, {}, {}, state.solver, state.frame}, {}};
    try
    {
      scheme->advance(operators, state, dt, step);
    }
    catch (const SolverControl::NoConvergence &exception)
    {
      throw StepFailure("The linear solver did not converge (residual " +
                            std::to_string(exception.last_residual) +
                            "; Solver/Largest number of iterations).",
                        StepFailure::Kind::not_converged, step.state.bodies);
    }
    catch (const ExcStalled &exception)
    {
      throw StepFailure(get_sentence(exception), StepFailure::Kind::stalled, step.state.bodies);
    }
    catch (const ExcInvertedElement &exception)
    {
      throw StepFailure(get_sentence(exception), StepFailure::Kind::inverted_element,
                        step.state.bodies);
    }
    catch (const ExcNotFinite &exception)
    {
      throw StepFailure(get_sentence(exception), StepFailure::Kind::not_finite, step.state.bodies);
    }
    return step;
  }

  template Step<2> advance(const Operators<2> &, const State<2> &, double);
  template Step<3> advance(const Operators<3> &, const State<3> &, double);
} // namespace caudal
