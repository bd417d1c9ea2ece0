// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_advance_h
#define caudal_viscous_advance_h

#include <caudal/base/plugin.h>
#include <caudal/observe/observation.h>
#include <caudal/viscous/operators.h>

#include <stdexcept>

namespace caudal
{
  /** What a step leads to: the state at its end, and its results. */
  template <int dim>
  struct Step
  {
    State<dim>      state;
    StepReport<dim> report;
  };

  /** A step has failed, for a reason (a sentence) that a shorter one may not meet. */
  class StepFailure : public std::runtime_error
  {
  public:
    enum class Kind
    {
      not_converged,
      stalled,
      inverted_element,
      not_finite
    };

    StepFailure(const std::string &reason, const Kind kind,
                const std::vector<BodyState> &trial_bodies)
        : std::runtime_error(reason)
        , kind(kind)
        , trial_bodies(trial_bodies)
    {}

    const Kind kind;
    /** What the failed step has made of the bodies, of the first of them or of none. */
    const std::vector<BodyState> trial_bodies;
  };

  /**
   * One step of length @p dt [s] from @p state, by the scheme of the parameters. Throws StepFailure
   * if it fails. Rejecting a step is forgetting what was returned. Collective.
   */
  template <int dim>
  Step<dim> advance(const Operators<dim> &operators, const State<dim> &state, double dt);

  /** A time scheme, a plug-in that registers itself by its name in `Time/Scheme`. */
  template <int dim>
  class TimeScheme : public Plugin
  {
  public:
    /**
     * Makes @p step of a new one, see caudal::advance(). Throws SolverControl::NoConvergence,
     * ExcStalled, ExcInvertedElement or ExcNotFinite if it fails; then @p step holds what it has
     * come to.
     */
    virtual void advance(const Operators<dim> &operators, const State<dim> &state, double dt,
                         Step<dim> &step) const = 0;
  };
} // namespace caudal

#endif
