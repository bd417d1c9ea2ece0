#ifndef caudal_viscous_coupled_system_h
#define caudal_viscous_coupled_system_h

#include <caudal/coupling/interaction_operator.h>
#include <caudal/fluid/momentum_operator.h>
#include <caudal/linear/multifrontal.h>

#include <deal.II/base/timer.h>
#include <deal.II/lac/sparse_matrix.h>

namespace caudal
{
  DeclException1(ExcNotFinite, std::string, << arg1 << " not finite.");

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

  /**
   * The part of a body in a step's linear system: the equations
   *   M_s dU - G du = r_U,
   *   R dU + M_s dPhi - eta M_s Z dq = r_Phi,  Z^T M_s (dU - Z dq) = r_q
   * for the corrections of its velocity, its force density and, with a gait,
   * of the velocity q of its floating frame (Z: rigid-body velocities).
   */
  struct BodyEquations
  {
    const SparseMatrix<double> *mass = nullptr;
    /** R = -db/dU: stiffness times step, damping, excess inertia. */
    const SparseMatrix<double> *response = nullptr;
    /** M_s Z, column by column; empty without a gait. */
    std::vector<Vector<double>> rigid_moments;
    /** Z^T M_s Z */
    FullMatrix<double> rigid_inertia;
    double             gait_damping = 0;

    // Right hand sides, replaced by the corrections.
    Vector<double> velocity, force_density, frame_velocity;

    unsigned int n_unknowns() const
    {
      return 2 * mass->m() + rigid_moments.size();
    }
  };

  /**
   * The linear system of a step: momentum, continuity and all bodies at once,
   *   A du + B^T dq - sum_b G_b^T dPhi_b = r_u,   B du = r_p,
   *   and the BodyEquations,
   * solved by generalised conjugate residuals. The preconditioner is the block triangular one
   * of the augmented Lagrangian (see MomentumOperator), in which velocities and bodies are
   * factorised together. There r_Phi stands in the rows of dU and r_U in those of dPhi: then
   * only dPhi shares rows and columns with the fluid, and the factors are smaller by up to a
   * fifth. With an up-to-date factorisation one to three iterations do; an older one is reused as
   * long as the additional iterations cost less than a new one.
   */
  template <int dim>
  class CoupledSystem
  {
  public:
    CoupledSystem(const SolverParameters &parameters, const FluidSpace<dim> &space,
                  const MomentumOperator<dim> &momentum, TimerOutput &timer);

    struct Body
    {
      const InteractionOperator<dim> *interaction;
      BodyEquations                  *equations;
    };

    /** Divides the unknowns among the ranks anew, after a change of the grid. */
    void reinit();

    /** The next system is another one, even in its size. */
    void forget_factorisation();

    /** Forgets also what was learnt: the coming steps do not depend on those before. */
    void forget_history();

    /**
     * Solves for the corrections. @p momentum_residual (r_u) becomes du,
     * @p divergence (r_p) becomes dq, the right hand sides of the @p bodies
     * their corrections. @p scale: the norm of the forces to which the
     * residual is compared, at least that of the right hand side. @p matrix_changed: whether the
     * system is another one than in the last call. Returns the number of iterations; throws
     * SolverControl::NoConvergence.
     */
    unsigned int solve(FieldVector &momentum_residual, FieldVector &divergence,
                       const std::vector<Body> &bodies, const MomentumWeights &weights,
                       double scale, bool matrix_changed);

    /** Number of entries of the factors. */
    double get_factor_entries() const
    {
      return direct_solver.get_factor_entries();
    }
    unsigned int get_n_factorisations() const
    {
      return n_factorisations;
    }
    /** Those of them that needed pivots from all rows, which is slow. */
    unsigned int get_n_pivoting_factorisations() const
    {
      return n_pivoting_factorisations;
    }

  private:
    const SolverParameters      &parameters;
    const FluidSpace<dim>       &space;
    const MomentumOperator<dim> &momentum;
    TimerOutput                 &timer;
    MultifrontalSolver           direct_solver;

    // What decides whether a factorisation is reused.
    unsigned int exact_iterations = 0, n_factorisations = 0, n_pivoting_factorisations = 0;
    unsigned int steps_until_reuse = 0, reuse_pause = 1;
    double       last_residual = 0;

    bool should_factorise(bool matrix_changed) const;
    /** Iterations with an old factorisation that cost as much as a new one. */
    unsigned int count_affordable_iterations() const;
    void         factorise(const std::vector<Body> &bodies, const MomentumWeights &weights);
    /**
     * First unknowns of those that are eliminated together, and the number of all unknowns. Of
     * so many nodes of a body one is an anchor.
     */
    std::vector<int> get_group_begins(const std::vector<Body> &bodies,
                                      unsigned int             most_per_anchor) const;

    /** Generalised conjugate residuals; more than @p n_affordable iterations are returned if these
     * did not do. */
    unsigned int iterate(BlockFieldVector &solution, const BlockFieldVector &rhs,
                         const std::vector<Body> &bodies, const MomentumWeights &weights,
                         double reference, unsigned int n_affordable);

    /** The bodies' right hand sides as one vector, which rank 0 owns. */
    FieldVector collect_right_hand_sides(const std::vector<Body> &bodies, double scale) const;
    /** Its counterpart for the solution. */
    void return_corrections(const FieldVector &corrections, const std::vector<Body> &bodies) const;

    /** Draws the lesson from an attempt to reuse a factorisation. */
    void update_reuse(bool succeeded);
  };
} // namespace caudal

#endif
