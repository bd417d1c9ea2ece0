// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_solver_parameters_h
#define caudal_viscous_solver_parameters_h

#include <deal.II/base/parameter_handler.h>

namespace caudal
{
  using namespace dealii;

  /** Section `Solver`. */
  struct SolverParameters
  {
    double       tolerance                    = 1e-8;
    unsigned int largest_number_of_iterations = 40;
    double       augmentation                 = 1e3;
    std::string  reuse                        = "automatic";

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };
} // namespace caudal

#endif
