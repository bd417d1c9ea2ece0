#ifndef caudal_viscous_failure_report_h
#define caudal_viscous_failure_report_h

#include <caudal/viscous/time_scheme.h>

namespace caudal
{
  /** What a step fails of. */
  enum class FailureKind
  {
    no_convergence,
    inverted_element,
    not_finite,
    other // the exception names its remedy
  };

  /**
   * Where to look after a failed step: the fastest flow of the last good state, for each body its
   * most deformed element in the failed step and the nearest side of the @p domain; then the
   * likely cause and what to change. Collective.
   */
  template <int dim>
  std::string describe_failure(FailureKind kind, const ImmersedSystem<dim> &system,
                               const BoundingBox<dim> &domain);
} // namespace caudal

#endif
