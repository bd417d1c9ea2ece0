// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_momentum_operator_h
#define caudal_fluid_momentum_operator_h

#include <caudal/fluid/cellwise_matrix.h>
#include <caudal/fluid/fluid_space.h>

namespace caudal
{
  /**
   * What a time scheme makes of the momentum equation: the implicit terms
   * (weights, and convection by @p transport) and the terms known from before.
   */
  struct MomentumStep
  {
    MomentumWeights    weights;
    const FieldVector *transport = nullptr;

    /** The sum of the old velocities times rho and their weights in the time derivative. */
    const FieldVector *inertia_history = nullptr;
    /** Viscous and grad-div terms of an old velocity. */
    const FieldVector *old_velocity = nullptr;
    MomentumWeights    old_weights;
    /** Convection terms of old velocities with their weights. */
    std::vector<std::pair<const FieldVector *, double>> old_convection;

    /** At which body force and tractions are taken. */
    Instant instant;
    /** Whether the grid moves, so that there is transport through closed sides, too. */
    bool grid_moves = false;
  };

  /**
   * The linear operators of a step of the momentum and continuity equations,
   *   A du + B^T dq = r,  B du = -B u_0,
   * for the corrections du of the velocity and dq = -dp of the pressure to a
   * first guess that satisfies the constraints, r being the residual of the
   * first guess. A contains the augmentation gamma B^T M_p^-1 B, which does
   * not change the solution (Benzi & Olshanskii 2006, doi:10.1137/050646421).
   */
  template <int dim>
  class MomentumOperator
  {
  public:
    explicit MomentumOperator(const FluidSpace<dim> &space);

    /** To be called after each change of the grid. */
    void reinit();

    /**
     * Assembles A (unless it is the same as in the last call: no transport and
     * equal weights) and returns the residual of @p velocity
     * and @p pressure. All input vectors have up-to-date ghost values.
     */
    FieldVector assemble(const MomentumStep &step, const FieldVector &velocity,
                         const FieldVector &pressure) const;

    const CellwiseMatrix &get_matrix() const
    {
      return matrix;
    }
    /** B, B_kj = int q_k div v_j dx, without the constrained velocities. */
    const CellwiseMatrix &get_divergence_matrix() const
    {
      return divergence_matrix;
    }

    /**
     * The diagonal of A - gamma B^T M_p^-1 B, @p grad_div being gamma, without convection: of A
     * without its grad-div term as far as the pressure space can tell a divergence. It depends on
     * grid and weights only.
     */
    FieldVector compute_smooth_diagonal(double grad_div) const;

    /** The diagonal of A. */
    FieldVector compute_diagonal() const;

    /** B u with all, also the constrained, velocities. */
    FieldVector compute_divergence(const FieldVector &velocity) const;

    /** vector := M_p^-1 vector, M_p the mass matrix of the pressure. */
    void apply_inverse_pressure_mass(FieldVector &vector) const;

  private:
    const FluidSpace<dim> &space;
    CellwiseMatrix         divergence_matrix;

    // Work space: A of the last assemble().
    mutable CellwiseMatrix  matrix;
    mutable MomentumWeights constant_weights;
    mutable bool            matrix_is_constant = false;
  };
} // namespace caudal

#endif
