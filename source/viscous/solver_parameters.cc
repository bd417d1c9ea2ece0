// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/viscous/solver_parameters.h>

namespace caudal
{
  void SolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    prm.add_parameter("Tolerance", tolerance,
                      "Residual of the linear system of a step relative to the forces in it [1].");
    prm.add_parameter(
        "Largest number of iterations", largest_number_of_iterations,
        "Iterations after which an old factorisation is renewed, and after which a step "
        "with a new one has failed [1].",
        Patterns::Integer(2));
    prm.add_parameter(
        "Augmentation", augmentation,
        "Augmentation gamma of the momentum equation, in units of rho H^2/dt, H being "
        "the smallest length of the domain: larger means fewer iterations and larger "
        "round-off [1].");
    prm.add_parameter(
        "Reuse factorisation", reuse,
        "automatic: reuse an old factorisation as preconditioner while that is cheaper; "
        "never: factorise in each step.",
        Patterns::Selection("automatic|never"));
    prm.leave_subsection();
  }

  void SolverParameters::check() const
  {
    check_value(tolerance > 0 && tolerance < 1e-2, "Solver/Tolerance", tolerance,
                "Give a number between 0 and 0.01.");
    check_positive("Solver/Augmentation", augmentation, "Give a positive number, 1e3 for example.");
  }
} // namespace caudal
