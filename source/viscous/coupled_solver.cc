// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/compatibility.h>
#include <caudal/linear/conjugate_residuals.h>
#include <caudal/viscous/block_preconditioner.h>
#include <caudal/viscous/coupled_solver.h>

#include <deal.II/lac/solver_control.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace caudal
{
  void SolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    prm.add_parameter(
        "Method", method,
        "direct: factorise the matrix of velocities and bodies; iterative: factorise what is near "
        "the bodies alone, and iterate; automatic: iterative in 3D on more than 1000 cells, else "
        "direct. It is decided anew when the grid changes.",
        Patterns::Selection("automatic|direct|iterative"));
    prm.add_parameter("Tolerance", tolerance,
                      "Residual of the linear system of a step relative to the forces in it [1].");
    prm.add_parameter(
        "Largest number of iterations", largest_number_of_iterations,
        "Iterations after which an old factorisation is renewed, and after which a step "
        "with a new one has failed [1].",
        Patterns::Integer(2));
    prm.add_parameter("Limit of the iterative method", limit_of_iterative_method,
                      "Iterations after which a step by Method = iterative has failed; it keeps "
                      "two vectors of each [1].",
                      Patterns::Integer(2));
    prm.add_parameter(
        "Augmentation", augmentation,
        "Augmentation gamma of the momentum equation, in units of rho H^2/dt, H being "
        "the smallest length of the domain: larger means fewer iterations and larger "
        "round-off [1].");
    prm.add_parameter(
        "Reuse factorisation", reuse,
        "automatic: reuse an old factorisation as preconditioner while that is cheaper; "
        "never: factorise in each step.",
        Patterns::Selection("automatic|never"));
    prm.leave_subsection();
  }

  void SolverParameters::check() const
  {
    check_value(tolerance > 0 && tolerance < 1e-2, "Solver/Tolerance", tolerance,
                "Give a number between 0 and 0.01.");
    check_positive("Solver/Augmentation", augmentation, "Give a positive number, 1e3 for example.");
  }

  namespace
  {
    /**
     * Time of a factorisation for each of its operations over that of an iteration for an entry of
     * the factors: 0.036 to 0.05 in systems with 2e6 to 3e7 entries (OpenBLAS, one core). It is
     * a constant since decisions by measured times would differ from run to run.
     */
    constexpr double relative_speed = 0.04;

    /**
     * A body's velocities would take their pivots from the balance of its forces, that is from the
     * stiffness. It is singular for rigid motions, and nearly so for slow bending: on fine grids
     * that costs the digits that the iterations then have to recover. At one node in so many, but
     * at a few of any body, velocity and force density are therefore eliminated together, which
     * offers pivots in the mass. At all nodes it would take up to twice the time.
     */
    constexpr unsigned int nodes_per_anchor = 64;

    /**
     * In 3D factors grow with the 4/3rd power of the cells, and operations with the square: at 800
     * cells both methods take a second, at 2,600 one takes six and the other two. A constant,
     * since decisions by measured times or by free memory would differ from run to run.
     */
    constexpr unsigned int most_cells_of_direct_method = 1000;

    // An old factorisation that was not worth it is tried again after this many steps at most.
    constexpr unsigned int longest_pause = 64;

    template <int dim>
    class AugmentedLagrangianPreconditioner
    {
    public:
      AugmentedLagrangianPreconditioner(const MomentumOperator<dim> &momentum,
                                        const MultifrontalSolver    &direct_solver,
                                        const MomentumWeights       &weights)
          : momentum(momentum)
          , direct_solver(direct_solver)
          , factor(-weights.augmentation / weights.inertia)
      {}

      void vmult(BlockFieldVector &result, const BlockFieldVector &source) const
      {
        FieldVector pressure(source.block(1));
        momentum.apply_inverse_pressure_mass(pressure);
        pressure *= factor;

        BlockFieldVector rest(source.n_blocks() - 1);
        rest.block(0) = source.block(0);
        if (source.n_blocks() == 3)
          rest.block(1) = source.block(2);
        rest.collect_sizes();
        FieldVector gradient;
        gradient.reinit(rest.block(0));
        momentum.get_divergence_matrix().Tvmult_add(gradient, pressure);
        rest.block(0) -= gradient;
        direct_solver.solve(rest);

        result.block(0) = rest.block(0);
        result.block(1) = pressure;
        if (source.n_blocks() == 3)
          result.block(2) = rest.block(1);
      }

    private:
      const MomentumOperator<dim> &momentum;
      const MultifrontalSolver    &direct_solver;
      const double                 factor;
    };

    /**
     * For each of this rank's velocity unknowns the centre, in the direction in which the cells
     * extend most, of the last cell that has it: between two positions lies a face.
     */
    template <int dim>
    std::vector<double> get_positions(const DoFHandler<dim> &dofs)
    {
      double          count = 0;
      Tensor<1, dim>  sum, sum_of_squares;
      const IndexSet &owned = dofs.locally_owned_dofs();
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          count += 1;
          for (unsigned int d = 0; d < dim; ++d)
          {
            sum[d] += cell->center()[d];
            sum_of_squares[d] += cell->center()[d] * cell->center()[d];
          }
        }
      const MPI_Comm communicator = compatibility::get_communicator(dofs);
      count                       = Utilities::MPI::sum(count, communicator);
      sum                         = Utilities::MPI::sum(sum, communicator) / count;
      sum_of_squares              = Utilities::MPI::sum(sum_of_squares, communicator) / count;
      unsigned int axis           = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (sum_of_squares[d] - sum[d] * sum[d] > sum_of_squares[axis] - sum[axis] * sum[axis])
          axis = d;

      std::vector<double>                  positions(owned.n_elements(), -1e300);
      std::vector<types::global_dof_index> cell_dofs(dofs.get_fe().n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
        if (!cell->is_artificial())
        {
          cell->get_dof_indices(cell_dofs);
          for (const auto dof : cell_dofs)
            if (owned.is_element(dof))
            {
              double &position = positions[owned.index_within_set(dof)];
              position         = std::max(position, cell->center()[axis]);
            }
        }
      return positions;
    }
  } // namespace

  template <int dim>
  CoupledSolver<dim>::CoupledSolver(const SolverParameters      &parameters,
                                    const FluidSpace<dim>       &space,
                                    const MomentumOperator<dim> &momentum, TimerOutput &timer)
      : parameters(parameters)
      , space(space)
      , momentum(momentum)
      , timer(timer)
      , preconditioner(std::make_unique<BlockPreconditioner<dim>>(space, momentum))
      , direct_solver(space.get_communicator())
  {}

  template <int dim>
  CoupledSolver<dim>::~CoupledSolver() = default;

  template <int dim>
  double CoupledSolver<dim>::get_factor_entries() const
  {
    return iterative ? preconditioner->get_schur_complement().get_factor_entries()
                     : direct_solver.get_factor_entries();
  }

  template <int dim>
  void CoupledSolver<dim>::reinit()
  {
    iterative = parameters.method == "iterative" ||
                (parameters.method == "automatic" && dim == 3 && SchurComplement::is_available() &&
                 space.get_triangulation().n_global_active_cells() > most_cells_of_direct_method);
    if (iterative)
      preconditioner->reinit();
    else
      direct_solver.set_positions(get_positions(space.velocity_dofs));
    factorised_point.reset();
    preconditioned_point.reset();
  }

  template <int dim>
  std::string CoupledSolver<dim>::describe_method() const
  {
    std::string reason;
    if (parameters.method == "automatic" && dim == 2)
      reason = ", in the plane";
    else if (parameters.method == "automatic" && !SchurComplement::is_available())
      reason = ", built without Trilinos' ML";
    else if (parameters.method == "automatic")
      reason = ", on up to " + std::to_string(most_cells_of_direct_method) +
               " cells direct, on more iterative";
    return "Linear solver: " + std::string(iterative ? "iterative" : "direct") +
           " (Solver/Method = " + parameters.method + reason + ")";
  }

  template <int dim>
  void CoupledSolver<dim>::factorise(const CoupledEquations<dim>                &equations,
                                     const std::shared_ptr<const Linearisation> &point) const
  {
    TimerOutput::Scope timer_section(timer, "factorisation");
    factorised_point.reset(); // should it fail
    const MatrixParts matrix = equations.collect_matrix();
    // Where nodes of bodies are close to each other, more of them have to be anchors.
    if (!direct_solver.factorize(equations.get_group_begins(nodes_per_anchor), matrix) &&
        !direct_solver.factorize(equations.get_group_begins(1), matrix))
    {
      direct_solver.factorize_with_pivoting(equations.get_group_begins(1).back(), matrix);
      ++n_pivoting_factorisations;
    }
    factorised_point = point;
    ++n_factorisations;
  }

  template <int dim>
  void CoupledSolver<dim>::recall(const std::vector<BodyEquations<dim>>      &bodies,
                                  const std::shared_ptr<const Linearisation> &point) const
  {
    factorise(CoupledEquations<dim>(space, momentum, bodies, point->weights), point);
  }

  namespace
  {
    /** Draws on an attempt to reuse a factorisation: after a failed one the next comes later. */
    void update_reuse_policy(SolverMemory &memory, const bool succeeded)
    {
      memory.reuse_pause       = succeeded ? 1 : std::min(2 * memory.reuse_pause, longest_pause);
      memory.steps_until_reuse = succeeded ? 0 : memory.reuse_pause;
    }
  } // namespace

  template <int dim>
  void CoupledSolver<dim>::set_up(const CoupledEquations<dim>                &equations,
                                  const std::shared_ptr<const Linearisation> &point) const
  {
    TimerOutput::Scope timer_section(timer, "preconditioner");
    const bool         is_known =
        preconditioned_point != nullptr && preconditioned_point->has_same_matrix(*point);
    preconditioned_point.reset(); // should it fail
    if (is_known)
      preconditioner->renew_equations(equations);
    else
    {
      preconditioner->set_up(equations, point->weights);
      ++n_factorisations;
      if (preconditioner->get_schur_complement().has_pivoted())
        ++n_pivoting_factorisations;
    }
    preconditioned_point = point;
  }

  template <int dim>
  typename CoupledSolver<dim>::Solution
  CoupledSolver<dim>::solve_iteratively(const CoupledEquations<dim> &equations,
                                        const BlockFieldVector &rhs, const double reference,
                                        const std::shared_ptr<const Linearisation> &point) const
  {
    set_up(equations, point);
    TimerOutput::Scope timer_section(timer, "iterations");
    BlockFieldVector   solution;
    solution.reinit(rhs);
    const IterationResult result = solve_by_conjugate_residuals(
        equations, solution, rhs, *preconditioner, parameters.tolerance * reference,
        parameters.limit_of_iterative_method);
    if (!result.converged)
      throw_stalled(equations, rhs, solution, reference);
    preconditioner->remove_mean_pressure(solution.block(1));
    return {equations.extract_correction(solution), result.n_iterations};
  }

  template <int dim>
  void CoupledSolver<dim>::throw_stalled(const CoupledEquations<dim> &equations,
                                         const BlockFieldVector      &rhs,
                                         const BlockFieldVector      &solution,
                                         const double                 reference) const
  {
    BlockFieldVector residual;
    residual.reinit(rhs);
    equations.vmult(residual, solution);
    residual.sadd(-1, 1, rhs);
    unsigned int       worst = 0;
    std::ostringstream text;
    text << std::setprecision(2) << "The iterative linear solver has stalled: after "
         << parameters.limit_of_iterative_method
         << " iterations (Solver/Limit of the iterative method) it leaves "
         << residual.l2_norm() / reference << " of the forces, and Solver/Tolerance asks for "
         << parameters.tolerance << ".";
    for (unsigned int b = 1; b < residual.n_blocks(); ++b)
      if (residual.block(b).l2_norm() > residual.block(worst).l2_norm())
        worst = b;
    if (worst == 0)
      text << " Most of it is in the momentum equation, where viscosity and grad-div exceed the "
              "inertia "
           << preconditioner->compute_stiffness_ratio()
           << " times; above ten, iterations are many. Reduce Time/Step or Fluid/Grad-div "
              "stabilisation";
    else if (worst == 1)
      text << " Most of it is in the continuity equation, that is in the multigrid method for the "
              "pressure. Give cells that are about as long as wide and high (Domain/Cells)";
    else
      text << " Most of it is in the equations of the bodies. Give elements about as large as the "
              "fluid's finest cells (Shape/Elements), or reduce Time/Step";
    text << ", increase the limit, or choose Solver/Method = direct.";
    throw ExcStalled(text.str());
  }

  template <int dim>
  typename CoupledSolver<dim>::Solution
  CoupledSolver<dim>::solve(const CoupledUnknowns                      &residual,
                            const std::vector<BodyEquations<dim>>      &bodies,
                            const std::shared_ptr<const Linearisation> &point, const double scale,
                            SolverMemory &memory) const
  {
    Assert(!has_forgotten(memory), ExcInternalError());
    const CoupledEquations<dim> equations(space, momentum, bodies, point->weights);
    const BlockFieldVector      rhs       = equations.make_right_hand_side(residual);
    const double                reference = std::max(scale, rhs.l2_norm());
    AssertThrow(std::isfinite(reference), ExcNotFinite("The forces on the fluid are"));
    if (iterative)
    {
      memory = SolverMemory();
      return solve_iteratively(equations, rhs, reference, point);
    }
    BlockFieldVector solution;
    solution.reinit(rhs);
    const auto iterate = [&](const unsigned int n_most) {
      TimerOutput::Scope timer_section(timer, "iterations");
      return solve_by_conjugate_residuals(
          equations, solution, rhs,
          AugmentedLagrangianPreconditioner<dim>(momentum, direct_solver, point->weights),
          parameters.tolerance * reference, n_most);
    };

    const unsigned int n_possible = parameters.largest_number_of_iterations;
    const bool         matrix_changed =
        !memory.linearisation || !memory.linearisation->has_same_matrix(*point);
    const auto pauses = [&]() {
      return parameters.reuse == "never" || memory.steps_until_reuse > 0;
    };
    const bool      reuses = memory.linearisation && !(matrix_changed && pauses());
    IterationResult result;
    if (reuses)
    {
      // Iterations with an old factorisation that cost as much as a new one.
      const unsigned int n_affordable =
          memory.exact_iterations +
          static_cast<unsigned int>(relative_speed * direct_solver.get_factorisation_cost());
      result = iterate(matrix_changed ? n_affordable : n_possible);
      if (matrix_changed)
        update_reuse_policy(memory, result.converged);
    }
    if (!result.converged)
    {
      factorise(equations, point);
      memory.linearisation    = point;
      result                  = iterate(n_possible);
      memory.exact_iterations = result.converged ? result.n_iterations : n_possible + 1;
      if (!reuses && memory.steps_until_reuse > 0)
        --memory.steps_until_reuse;
    }
    if (!result.converged)
      throw SolverControl::NoConvergence(n_possible + 1, result.residual);
    // What no step will reuse need not be remembered.
    if (point->has_transport() && pauses())
      memory.linearisation.reset();
    return {equations.extract_correction(solution), result.n_iterations};
  }

  template class CoupledSolver<2>;
  template class CoupledSolver<3>;
} // namespace caudal
