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
    std::string  method                       = "automatic";
    double       tolerance                    = 1e-8;
    unsigned int largest_number_of_iterations = 40;
    unsigned int limit_of_iterative_method    = 150;
    double       augmentation                 = 1e3;
    std::string  reuse                        = "automatic";

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  DeclException1(ExcNotFinite, std::string, << arg1 << " not finite.");

  /** The iterative method has stalled: a sentence that says where. */
  DeclException1(ExcStalled, std::string, << arg1);

  template <int dim>
  class BlockPreconditioner;

  /**
   * Solves the CoupledEquations by generalised conjugate residuals. The direct method's
   * preconditioner is the block triangular one of the augmented Lagrangian (see MomentumOperator),
   * in which velocities and bodies are factorised together. With an up-to-date factorisation one to
   * three iterations do; an older one is reused as long as the additional iterations cost less than
   * a new one. That of the iterative method is the BlockPreconditioner, made anew for each matrix.
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
    ~CoupledSolver();

    /**
     * Chooses the method for the present grid, and divides the unknowns among the ranks anew: to be
     * called after each change of the grid.
     */
    void reinit();

    struct Solution
    {
      CoupledUnknowns correction;
      unsigned int    n_iterations = 0;
    };

    /**
     * The correction for the @p residual. The equations are those of MomentumOperator and @p bodies
     * about @p point. @p scale: the norm of the forces to which the residual is compared, at least
     * that of the right hand side. Throws SolverControl::NoConvergence, ExcStalled or
     * ExcNotFinite.
     */
    Solution solve(const CoupledUnknowns &residual, const std::vector<BodyEquations<dim>> &bodies,
                   const std::shared_ptr<const Linearisation> &point, double scale,
                   SolverMemory &memory) const;

    /** Whether steps on the present grid are solved by the iterative method. */
    bool is_iterative() const
    {
      return iterative;
    }

    /** Which method is in use and why: a sentence for the log. */
    std::string describe_method() const;

    /** Whether the factors are not those that @p memory remembers: in a resumed run, after a failed
     * step. */
    bool has_forgotten(const SolverMemory &memory) const
    {
      return !iterative && memory.linearisation != nullptr &&
             memory.linearisation != factorised_point;
    }

    /** Makes the factors of the equations about @p point anew. */
    void recall(const std::vector<BodyEquations<dim>>      &bodies,
                const std::shared_ptr<const Linearisation> &point) const;

    /** Number of entries of the factors. */
    double       get_factor_entries() const;
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
    bool                         iterative = false;

    // Of the iterative method.
    const std::unique_ptr<BlockPreconditioner<dim>> preconditioner;
    mutable std::shared_ptr<const Linearisation>    preconditioned_point;

    // Work space.
    mutable MultifrontalSolver                   direct_solver;
    mutable std::shared_ptr<const Linearisation> factorised_point;
    mutable unsigned int                         n_factorisations          = 0;
    mutable unsigned int                         n_pivoting_factorisations = 0;

    void     factorise(const CoupledEquations<dim>                &equations,
                       const std::shared_ptr<const Linearisation> &point) const;
    Solution solve_iteratively(const CoupledEquations<dim> &equations, const BlockFieldVector &rhs,
                               double                                      reference,
                               const std::shared_ptr<const Linearisation> &point) const;
    void     set_up(const CoupledEquations<dim>                &equations,
                    const std::shared_ptr<const Linearisation> &point) const;

    [[noreturn]] void throw_stalled(const CoupledEquations<dim> &equations,
                                    const BlockFieldVector &rhs, const BlockFieldVector &solution,
                                    double reference) const;
  };
} // namespace caudal

#endif
