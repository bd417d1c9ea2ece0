// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_failure_report_h
#define caudal_viscous_failure_report_h

#include <caudal/viscous/advance.h>

namespace caudal
{
  /**
   * The likely cause of the @p failure of a step from @p state, what to change, and where to look:
   * the fastest flow, and for each body its most deformed element, before and in the failed step,
   * and the nearest side of the domain. Collective.
   */
  template <int dim>
  std::string describe_failure(const StepFailure &failure, const Operators<dim> &operators,
                               const State<dim> &state);
} // namespace caudal

#endif
