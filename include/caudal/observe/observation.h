// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_observation_h
#define caudal_observe_observation_h

#include <caudal/base/time_stepping.h>
#include <caudal/fluid/fluid_state.h>
#include <caudal/mesh/cell_lattice.h>
#include <caudal/solid/body.h>

namespace caudal
{
  /** Results of one step for a body. */
  struct BodyReport
  {
    /** Summary of the deformation at t^{n+1}. */
    DeformationSummary deformation;
    /** Mean over the step [W, in 2D W/m]. */
    double muscle_power = 0;
    /**
     * |Phi.(C U) - f.u| relative to the sum of the moduli of the former's terms: the power of the
     * force density, seen by the body and by the fluid, at t^{n+1} [1].
     */
    double power_identity = 0;
    /**
     * Power of its force density on the velocities that are prescribed on sides of the domain, in
     * cells that body and side have in common [W, in 2D W/m]. The sides take as much less.
     */
    double power_on_sides = 0;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &deformation &muscle_power &power_identity &power_on_sides;
    }
  };

  /** Results of one step beside the new state. */
  template <int dim>
  struct StepReport
  {
    unsigned int            iterations = 0;
    Tensor<1, dim>          grid_velocity; // with which the grid moves [m/s]
    TimeStepper::Indicators indicators;
    /** Summary of the velocity at t^{n+1}. */
    FlowSummary<dim> flow;
    /**
     * Weight of the present velocity in the time derivative [1/s], by which the stabilisation of
     * the convection is limited: 1/dt, with BDF2 (1 + 2 r)/(1 + r)/dt, r the ratio of the steps.
     */
    double rate = 0;
    /**
     * Energy that the scheme's own damping takes from the fluid in the step [J, in 2D J/m]: with
     * BDF2 rho/4 |u^{n+1} - 2 u^n + u^{n-1}|^2, for equal steps (Hairer & Wanner 1996,
     * doi:10.1007/978-3-642-05221-7, V.6: the G-norm of the method).
     */
    double                  damping = 0;
    std::vector<BodyReport> bodies;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &iterations &grid_velocity &indicators &flow &rate &damping &bodies;
    }
  };

  /** A body as observers see it. */
  template <int dim>
  struct BodyObservation
  {
    const Body<dim>  &body;
    const BodyState  &state;
    const BodyReport &report;
  };

  /**
   * The model as observers see it: at the start, after each step, and after each change of the
   * grid between two steps. They read and never write, so that no result depends on who observes.
   * References are valid during the call that an observation is handed to.
   */
  template <int dim>
  struct Observation
  {
    /** t^n [s]; the length of the step that led there [s] and its number, 0 at the start. */
    double       time        = 0;
    double       step        = 0;
    unsigned int step_number = 0;
    /** Whether the end time is reached. */
    bool is_last = false;
    /** Places of the grid are these plus the origin in the laboratory's frame [m]. */
    DomainVector origin;
    bool         grid_moves = false;

    const FluidSpace<dim>  &space;
    const CellLattice<dim> &lattice;
    const FluidState<dim>  &fluid;
    /** Results of the step that led to t^n; at the start, the initial state's and zeros. */
    const StepReport<dim> &report;
    /** Half the width of the kernel's support, in cells of the finest level. */
    double                            kernel_support = 0;
    std::vector<BodyObservation<dim>> bodies;

    Instant get_instant() const
    {
      return {time, origin};
    }
  };
} // namespace caudal

#endif
