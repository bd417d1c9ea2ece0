// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_step_parts_h
#define caudal_viscous_step_parts_h

#include <caudal/viscous/advance.h>

namespace caudal
{
  // The parts that the time schemes share, in the order in which a step takes them.

  /**
   * Makes the factorisation that the state remembers anew if it is not there: in a resumed run, or
   * after a failed step.
   */
  template <int dim>
  void recall_factorisation(const Operators<dim> &operators, const SolverMemory &memory);

  /** Muscle to body: what controllers and muscles decide on the step, body by body. */
  template <int dim>
  std::vector<Contraction> command_muscles(const Operators<dim> &operators, const State<dim> &state,
                                           double dt);

  /** What the bodies contribute to the equations of a step. */
  template <int dim>
  struct LinearisedBodies
  {
    std::vector<InteractionOperator<dim>> interactions;
    std::vector<BodyEquations<dim>>       equations; // they refer to the interactions
    std::vector<ForcesByAccount>          forces;
    /** r_q = Z^T M_s (V - U*), V the velocity that a gait asks for. */
    std::vector<Vector<double>> frame_residuals;
  };

  /** Linearises the forces of all bodies about @p point, and computes their interactions there. */
  template <int dim>
  LinearisedBodies<dim> linearise_bodies(const Operators<dim> &operators,
                                         const Linearisation  &point);

  /**
   * Body to fluid: adds the @p forces G^T Phi of all bodies, Phi their force densities in the
   * states @p bodies. Returns the sum of their norms.
   */
  template <int dim>
  double apply_bodies_to_fluid(const std::vector<InteractionOperator<dim>> &interactions,
                               const std::vector<BodyState> &bodies, FieldVector &forces);

  /**
   * Solves for the corrections to the first @p guess of velocity and pressure at the end of the
   * step from @p state, which satisfies the boundary conditions there. The @p residual still lacks
   * that of the continuity equation. @p force_scale: what apply_bodies_to_fluid() returns. Gives
   * the corrected fluid, and the iterations that it took, to @p step; returns the corrections of
   * the bodies.
   */
  template <int dim>
  std::vector<BodyUnknowns> solve_and_correct(const Operators<dim> &operators,
                                              const State<dim> &state, const CoupledUnknowns &guess,
                                              CoupledUnknowns                             residual,
                                              const std::vector<BodyEquations<dim>>      &equations,
                                              const std::shared_ptr<const Linearisation> &point,
                                              double force_scale, Step<dim> &step);

  /** Fluid to body: the velocity U = M_s^-1 G u with which the body follows the fluid. */
  template <int dim>
  Vector<double> follow_fluid(const Body<dim> &body, const InteractionOperator<dim> &interaction,
                              const FieldVector &velocity);

  /**
   * Adds the work of the step from @p before to @p after by the midpoint rule, from the @p forces
   * in the middle of the step: those of feedback, and those of the muscle or, with a gait, the
   * elastic ones. Returns the mean power of what drives the body [W, in 2D W/m].
   */
  template <int dim>
  double account_work(const Body<dim> &body, const BodyState &before, const ForcesByAccount &forces,
                      double dt, BodyState &after);

  /**
   * Checks the state @p after of a step from @p before and fills its report. Throws unless
   * velocities are finite, no body cell is inverted and the bodies are far enough from each other.
   * @p predicted: where the bodies were expected.
   */
  template <int dim>
  void check_step(const Operators<dim> &operators, const State<dim> &before,
                  const State<dim> &after, const std::vector<Vector<double>> &predicted,
                  const std::vector<InteractionOperator<dim>> &interactions, double dt,
                  StepReport<dim> &report);
} // namespace caudal

#endif
