// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_coupled_solver_h
#define caudal_viscous_coupled_solver_h

#include <caudal/viscous/coupled_equations.h>
#include <caudal/viscous/state.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

namespace caudal
{
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

  DeclException1(ExcNotFinite, std::string, << arg1 << " not finite.");

  /**
   * Solves the CoupledEquations by generalised conjugate residuals. The preconditioner is the block
   * triangular one of the augmented Lagrangian (see MomentumOperator), in which velocities and
   * bodies are factorised together. With an up-to-date factorisation one to three iterations do; an
   * older one is reused as long as the additional iterations cost less than a new one.
   *
   * What it decides depends on the SolverMemory alone. Its factors are those about a point that
   * this remembers; where they are not, recall() makes them anew.
   */
  template <int dim>
  class CoupledSolver
  {
  public:
    CoupledSolver(const SolverParameters &parameters, const FluidSpace<dim> &space,
                  const MomentumOperator<dim> &momentum, TimerOutput &timer);

    /** Divides the unknowns among the ranks anew: to be called after each change of the grid. */
    void reinit();

    struct Solution
    {
      CoupledUnknowns correction;
      unsigned int    n_iterations = 0;
    };

    /**
     * The correction for the @p residual. The equations are those of MomentumOperator and @p bodies
     * about @p point. @p scale: the norm of the forces to which the residual is compared, at least
     * that of the right hand side. Throws SolverControl::NoConvergence or ExcNotFinite.
     */
    Solution solve(const CoupledUnknowns &residual, const std::vector<BodyEquations<dim>> &bodies,
                   const std::shared_ptr<const Linearisation> &point, double scale,
                   SolverMemory &memory) const;

    /** Whether the factors are not those that @p memory remembers: in a resumed run, after a failed
     * step. */
    bool has_forgotten(const SolverMemory &memory) const
    {
      return memory.linearisation != nullptr && memory.linearisation != factorised_point;
    }

    /** Makes the factors of the equations about @p point anew. */
    void recall(const std::vector<BodyEquations<dim>>      &bodies,
                const std::shared_ptr<const Linearisation> &point) const;

    /** Number of entries of the factors. */
    double get_factor_entries() const
    {
      return direct_solver.get_factor_entries();
    }
    unsigned int get_n_factorisations() const
    {
      return n_factorisations;
    }

    /** Number of factorisations that needed pivots from all rows, which is slow. */
    unsigned int get_n_pivoting_factorisations() const
    {
      return n_pivoting_factorisations;
    }

  private:
    const SolverParameters      &parameters;
    const FluidSpace<dim>       &space;
    const MomentumOperator<dim> &momentum;
    TimerOutput                 &timer;

    // Work space.
    mutable MultifrontalSolver                   direct_solver;
    mutable std::shared_ptr<const Linearisation> factorised_point;
    mutable unsigned int                         n_factorisations          = 0;
    mutable unsigned int                         n_pivoting_factorisations = 0;

    void factorise(const CoupledEquations<dim>                &equations,
                   const std::shared_ptr<const Linearisation> &point) const;
  };
} // namespace caudal

#endif
