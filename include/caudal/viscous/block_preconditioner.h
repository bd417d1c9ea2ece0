// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_block_preconditioner_h
#define caudal_viscous_block_preconditioner_h

#include <caudal/linear/schur_complement.h>
#include <caudal/viscous/coupled_equations.h>

#include <memory>

namespace caudal
{
  /**
   * Preconditioner of the CoupledEquations without augmentation, block triangular: first pressures
   * and bodies together by their SchurComplement, with the diagonal
   *   D = diag(A - gamma B^T M_p^-1 B), without convection,
   * in place of A; then what viscosity and grad-div resist, dq -= (gamma + mu) M_p^-1 r_p in each
   * cell (Cahouet & Chabard 1988, doi:10.1002/fld.1650080802); then the velocities by a few
   * conjugate residuals with diag(A),
   *   du ~ A^-1 (r_u - B^T dq + G^T dPhi).
   * Polynomials for real eigenvalues (Chebyshev's) would magnify what a flow that passes several
   * spacings in a step carries along. The preconditioner is not linear: see
   * solve_by_conjugate_residuals.
   * A stiff body is no obstacle, since its force and the pressure share a Schur complement; a large
   * grad-div coefficient is: beyond ten times the inertia, counts grow. @p equations and what they
   * refer to have to outlive the use of set_up().
   */
  template <int dim>
  class BlockPreconditioner
  {
  public:
    BlockPreconditioner(const FluidSpace<dim> &space, const MomentumOperator<dim> &momentum);
    ~BlockPreconditioner();

    /** To be called after each change of the grid. Collective. */
    void reinit();

    /** Takes over the matrices of these equations. Collective. */
    void set_up(const CoupledEquations<dim> &equations, const MomentumWeights &weights);

    /** Takes these equations for those of set_up(), whose matrices are the same. */
    void renew_equations(const CoupledEquations<dim> &same_equations)
    {
      equations = &same_equations;
    }

    void vmult(BlockFieldVector &result, const BlockFieldVector &source) const;

    const SchurComplement &get_schur_complement() const
    {
      return schur_complement;
    }

    /**
     * By how much viscosity and grad-div exceed the inertia: the median of the diagonal entries of
     * A over those of the inertia, on the rank where it is largest. Collective.
     */
    double compute_stiffness_ratio() const;

    /** Subtracts its mean from a pressure if the equations leave that open. Collective. */
    void remove_mean_pressure(FieldVector &pressure) const;

  private:
    class VelocityBlock;

    const FluidSpace<dim>         &space;
    const MomentumOperator<dim>   &momentum;
    const CoupledEquations<dim>   *equations = nullptr;
    MomentumWeights                weights;
    SchurComplement                schur_complement;
    std::unique_ptr<VelocityBlock> velocity_block;
  };
} // namespace caudal

#endif
