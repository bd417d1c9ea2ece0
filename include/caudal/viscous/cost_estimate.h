// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_cost_estimate_h
#define caudal_viscous_cost_estimate_h

#include <caudal/viscous/operators.h>

namespace caudal
{
  /** What steps cost. */
  struct StepCost
  {
    unsigned int n_steps = 0; // that were tried; 0: estimated from the numbers of unknowns
    double       seconds = 0; // of wall time for a step (of a trial: but the first)
    double       memory  = 0; // [MiB] on all ranks
  };

  /**
   * What a step of the iterative method is likely to cost on this grid, before any was tried: from
   * costs a cell and an unknown near the bodies that were measured on one core (EPYC, 2026: 45
   * iterations; 3,700 to 14,300 cells, 1,000 to 6,800 velocities of a body).
   */
  template <int dim>
  StepCost estimate_iterative_step(const Operators<dim> &operators);

  /**
   * Warnings of a step by the iterative method that needs more memory than there is, or of a run
   * that would take weeks, each with what would fit. Collective.
   */
  template <int dim>
  std::vector<std::string> find_cost_warnings(const Operators<dim> &operators);
} // namespace caudal

#endif
