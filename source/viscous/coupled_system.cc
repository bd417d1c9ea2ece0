#include <caudal/base/compatibility.h>
#include <caudal/viscous/coupled_system.h>

#include <caudal/linear/conjugate_residuals.h>
#include <caudal/viscous/body_unknowns.h>

#include <deal.II/lac/solver_control.h>

#include <cmath>

namespace caudal
{
  void SolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    prm.add_parameter("Tolerance", tolerance,
                      "Residual of the linear system of a step relative to the forces in it [1].");
    prm.add_parameter(
        "Largest number of iterations", largest_number_of_iterations,
        "Iterations after which an old factorisation is renewed, and after which a step "
        "with a new one has failed [1].",
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
    AssertThrow(tolerance > 0 && tolerance < 1e-2,
                ExcMessage("Solver/Tolerance: the value is " + std::to_string(tolerance) +
                           ". Give a number between 0 and 0.01."));
    AssertThrow(largest_number_of_iterations >= 2,
                ExcMessage("Solver/Largest number of iterations: give at least 2."));
    AssertThrow(std::isfinite(augmentation) && augmentation > 0,
                ExcMessage("Solver/Augmentation: the value is " + std::to_string(augmentation) +
                           ". Give a positive number, 1e3 for example."));
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
    constexpr unsigned int nodes_per_anchor = 64, fewest_anchors = 4;

    /**
     * Scales of the continuity equation and of the equation of the bodies'
     * velocities that make their residuals comparable to forces: rho/dt.
     */
    double get_kinematic_scale(const MomentumWeights &weights)
    {
      return weights.inertia;
    }

    template <int dim>
    BodyPlaces<dim> get_places(const BodyEquations &equations, const int begin)
    {
      return BodyPlaces<dim>(begin, equations.mass->m(), equations.rigid_moments.size());
    }

    template <int dim>
    class SystemOperator
    {
    public:
      SystemOperator(const MomentumOperator<dim>                          &momentum,
                     const std::vector<typename CoupledSystem<dim>::Body> &bodies,
                     const double                                          scale)
          : momentum(momentum)
          , bodies(bodies)
          , scale(scale)
      {}

      void vmult(BlockFieldVector &result, const BlockFieldVector &source) const
      {
        // It also updates the ghost entries that the interpolation needs.
        momentum.get_matrix().vmult(result.block(0), source.block(0));
        momentum.get_divergence_matrix().Tvmult_add(result.block(0), source.block(1));
        momentum.get_divergence_matrix().vmult(result.block(1), source.block(0));
        result.block(1) *= scale;
        if (bodies.empty())
          return;

        BodyVector in(source.block(0).get_mpi_communicator(), source.block(2).size());
        BodyVector out(source.block(0).get_mpi_communicator(), source.block(2).size());
        in.receive(source.block(2));
        FieldVector forces;
        forces.reinit(result.block(0));
        unsigned int begin = 0;
        for (const auto &[interaction, equations] : bodies)
        {
          const unsigned int   n = equations->mass->m(), n_q = equations->rigid_moments.size();
          const auto           places        = get_places<dim>(*equations, begin);
          const Vector<double> velocity      = in.extract(places.velocity);
          const Vector<double> force_density = in.extract(places.force_density);
          const Vector<double> frame         = in.extract(places.frame);
          interaction->spread(force_density, forces);

          Vector<double> kinematic(n), interpolated(n), balance(n), frame_balance(n_q);
          equations->mass->vmult(kinematic, velocity);
          interaction->interpolate(source.block(0), interpolated, /*homogeneous=*/true);
          kinematic -= interpolated;
          kinematic *= scale;
          equations->response->vmult(balance, velocity);
          equations->mass->vmult_add(balance, force_density);
          for (unsigned int k = 0; k < n_q; ++k)
          {
            balance.add(-equations->gait_damping * frame[k], equations->rigid_moments[k]);
            frame_balance[k] = equations->rigid_moments[k] * velocity;
            for (unsigned int l = 0; l < n_q; ++l)
              frame_balance[k] -= equations->rigid_inertia(k, l) * frame[l];
            frame_balance[k] *= scale;
          }
          out.insert(balance, places.velocity);
          out.insert(kinematic, places.force_density);
          out.insert(frame_balance, places.frame);
          begin += equations->n_unknowns();
        }
        result.block(0) -= forces;
        out.send(result.block(2));
      }

    private:
      const MomentumOperator<dim>                          &momentum;
      const std::vector<typename CoupledSystem<dim>::Body> &bodies;
      const double                                          scale;
    };

    template <int dim>
    class AugmentedLagrangianPreconditioner
    {
    public:
      AugmentedLagrangianPreconditioner(const MomentumOperator<dim> &momentum,
                                        SubstructuredSolver         &direct_solver,
                                        const double augmentation, const double scale)
          : momentum(momentum)
          , direct_solver(direct_solver)
          , augmentation(augmentation)
          , scale(scale)
      {}

      void vmult(BlockFieldVector &result, const BlockFieldVector &source) const
      {
        FieldVector pressure(source.block(1));
        momentum.apply_inverse_pressure_mass(pressure);
        pressure *= -augmentation / scale;

        BlockFieldVector rest(source.n_blocks() - 1);
        rest.block(0) = source.block(0);
        if (source.n_blocks() == 3)
          rest.block(1) = source.block(2);
        rest.collect_sizes();
        FieldVector gradient;
        gradient.reinit(rest.block(0));
        momentum.get_divergence_matrix().Tvmult(gradient, pressure);
        rest.block(0) -= gradient;
        direct_solver.solve(rest);

        result.block(0) = rest.block(0);
        result.block(1) = pressure;
        if (source.n_blocks() == 3)
          result.block(2) = rest.block(1);
      }

    private:
      const MomentumOperator<dim> &momentum;
      SubstructuredSolver         &direct_solver;
      const double                 augmentation, scale;
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
  CoupledSystem<dim>::CoupledSystem(const SolverParameters      &parameters,
                                    const FluidSpace<dim>       &space,
                                    const MomentumOperator<dim> &momentum, TimerOutput &timer)
      : parameters(parameters)
      , space(space)
      , momentum(momentum)
      , timer(timer)
      , direct_solver(space.get_communicator())
  {}

  template <int dim>
  void CoupledSystem<dim>::reinit()
  {
    direct_solver.set_positions(get_positions(space.velocity_dofs));
  }

  template <int dim>
  void CoupledSystem<dim>::forget_factorisation()
  {
    direct_solver.clear();
  }

  template <int dim>
  void CoupledSystem<dim>::forget_history()
  {
    direct_solver.reset();
    exact_iterations  = 0;
    steps_until_reuse = 0;
    reuse_pause       = 1;
    last_residual     = 0;
  }

  template <int dim>
  unsigned int CoupledSystem<dim>::count_affordable_iterations() const
  {
    return exact_iterations +
           static_cast<unsigned int>(relative_speed * direct_solver.get_factorisation_cost());
  }

  template <int dim>
  bool CoupledSystem<dim>::should_factorise(const bool matrix_changed) const
  {
    if (!direct_solver.is_factorized())
      return true;
    if (!matrix_changed)
      return false;
    if (parameters.reuse == "never")
      return true;
    return steps_until_reuse > 0;
  }

  template <int dim>
  void CoupledSystem<dim>::factorise(const std::vector<Body> &bodies,
                                     const MomentumWeights   &weights)
  {
    TimerOutput::Scope timer_section(timer, "factorisation");
    const double       scale = get_kinematic_scale(weights);
    MatrixParts        matrix;
    Triplets          &entries = matrix.entries;
    momentum.get_matrix().append_to(matrix);
    int              begin = space.velocity_dofs.n_dofs();
    std::vector<int> group_begins; // of unknowns that are eliminated together
    for (int i = 0; i < begin; i += dim)
      group_begins.push_back(i);
    const bool is_root = Utilities::MPI::this_mpi_process(space.get_communicator()) == 0;
    for (const auto &[interaction, equations] : bodies)
    {
      const unsigned int n = equations->mass->m(), n_q = equations->rigid_moments.size();
      const auto         places   = get_places<dim>(*equations, begin);
      const Places      &velocity = places.velocity, &force_density = places.force_density,
                   &frame   = places.frame;
      const Places &balance = velocity, &kinematic = force_density; // rows
      interaction->for_each_entry(
          [&](const unsigned int row, const types::global_dof_index column, const double value) {
            entries.add(kinematic[row], column, -scale * value);
            entries.add(column, force_density[row], -value);
          });
      if (is_root)
      {
        for (const auto &entry : *equations->mass)
        {
          entries.add(kinematic[entry.row()], velocity[entry.column()], scale * entry.value());
          entries.add(balance[entry.row()], force_density[entry.column()], entry.value());
        }
        for (const auto &entry : *equations->response)
          entries.add(balance[entry.row()], velocity[entry.column()], entry.value());
        for (unsigned int k = 0; k < n_q; ++k)
        {
          for (unsigned int i = 0; i < n; ++i)
          {
            entries.add(balance[i], frame[k],
                        -equations->gait_damping * equations->rigid_moments[k][i]);
            entries.add(frame[k], velocity[i], scale * equations->rigid_moments[k][i]);
          }
          for (unsigned int l = 0; l < n_q; ++l)
            entries.add(frame[k], frame[l], -scale * equations->rigid_inertia(k, l));
        }
      }
      const unsigned int spacing = std::clamp(n / dim / fewest_anchors, 1u, nodes_per_anchor);
      for (unsigned int i = 0; i < n; i += dim)
      {
        const bool is_anchor = i / dim % spacing == 0;
        group_begins.push_back(velocity[i]);
        if (!is_anchor)
          group_begins.push_back(force_density[i]);
      }
      if (n_q > 0)
        group_begins.push_back(frame.begin);
      begin += equations->n_unknowns();
    }
    group_begins.push_back(begin);
    direct_solver.factorize(group_begins, matrix);
    ++n_factorisations;
  }

  template <int dim>
  unsigned int CoupledSystem<dim>::iterate(BlockFieldVector &solution, const BlockFieldVector &rhs,
                                           const std::vector<Body> &bodies,
                                           const MomentumWeights &weights, const double reference,
                                           const unsigned int n_affordable)
  {
    TimerOutput::Scope                           timer_section(timer, "iterations");
    const double                                 scale = get_kinematic_scale(weights);
    const SystemOperator<dim>                    system(momentum, bodies, scale);
    const AugmentedLagrangianPreconditioner<dim> preconditioner(momentum, direct_solver,
                                                                weights.augmentation, scale);
    const IterationResult                        result = solve_by_conjugate_residuals(
                               system, solution, rhs, preconditioner, parameters.tolerance * reference, n_affordable);
    last_residual = result.residual;
    return result.converged ? result.n_iterations : n_affordable + 1;
  }

  template <int dim>
  void CoupledSystem<dim>::update_reuse(const bool succeeded)
  {
    // Where an old factorisation was not worth it, the next try comes later.
    reuse_pause       = succeeded ? 1 : std::min(2 * reuse_pause, 64u);
    steps_until_reuse = succeeded ? 0 : reuse_pause;
  }

  template <int dim>
  unsigned int CoupledSystem<dim>::solve(FieldVector &momentum_residual, FieldVector &divergence,
                                         const std::vector<Body> &bodies,
                                         const MomentumWeights &weights, const double forces_scale,
                                         const bool matrix_changed)
  {
    const double     scale = get_kinematic_scale(weights);
    BlockFieldVector rhs(bodies.empty() ? 2 : 3), solution(rhs.n_blocks());
    rhs.block(0) = momentum_residual;
    rhs.block(1) = divergence;
    rhs.block(1) *= scale;
    if (!bodies.empty())
      rhs.block(2) = collect_right_hand_sides(bodies, scale);
    rhs.collect_sizes();
    solution.reinit(rhs);

    const double reference = std::max(forces_scale, rhs.l2_norm());
    AssertThrow(std::isfinite(reference), ExcNotFinite("The forces on the fluid are"));
    const bool         reuses     = !should_factorise(matrix_changed);
    const unsigned int n_possible = parameters.largest_number_of_iterations;
    unsigned int       iterations = n_possible + 1;
    if (reuses)
    {
      const unsigned int n_affordable = matrix_changed ? count_affordable_iterations() : n_possible;
      iterations = iterate(solution, rhs, bodies, weights, reference, n_affordable);
      if (matrix_changed)
        update_reuse(iterations <= n_affordable);
      if (iterations > n_affordable)
        iterations = n_possible + 1;
    }
    if (iterations > n_possible)
    {
      factorise(bodies, weights);
      iterations       = iterate(solution, rhs, bodies, weights, reference, n_possible);
      exact_iterations = iterations;
      if (!reuses && steps_until_reuse > 0)
        --steps_until_reuse;
    }
    if (iterations > n_possible)
      throw SolverControl::NoConvergence(iterations, last_residual);

    momentum_residual = solution.block(0);
    divergence        = solution.block(1);
    if (!bodies.empty())
      return_corrections(solution.block(2), bodies);
    return iterations;
  }

  template <int dim>
  FieldVector CoupledSystem<dim>::collect_right_hand_sides(const std::vector<Body> &bodies,
                                                           const double             scale) const
  {
    unsigned int size = 0;
    for (const auto &body : bodies)
      size += body.equations->n_unknowns();
    BodyVector   values(space.get_communicator(), size);
    unsigned int begin = 0;
    for (const auto &[interaction, equations] : bodies)
    {
      const auto places = get_places<dim>(*equations, begin);
      equations->velocity *= scale;
      equations->frame_velocity *= scale;
      values.insert(equations->force_density, places.velocity);
      values.insert(equations->velocity, places.force_density);
      values.insert(equations->frame_velocity, places.frame);
      begin += equations->n_unknowns();
    }
    IndexSet owned(size);
    if (Utilities::MPI::this_mpi_process(space.get_communicator()) == 0)
      owned.add_range(0, size);
    FieldVector result(owned, space.get_communicator());
    values.send(result);
    return result;
  }

  template <int dim>
  void CoupledSystem<dim>::return_corrections(const FieldVector       &corrections,
                                              const std::vector<Body> &bodies) const
  {
    BodyVector values(space.get_communicator(), corrections.size());
    values.receive(corrections);
    unsigned int begin = 0;
    for (const auto &[interaction, equations] : bodies)
    {
      const auto places         = get_places<dim>(*equations, begin);
      equations->velocity       = values.extract(places.velocity);
      equations->force_density  = values.extract(places.force_density);
      equations->frame_velocity = values.extract(places.frame);
      begin += equations->n_unknowns();
    }
  }

  template class CoupledSystem<2>;
  template class CoupledSystem<3>;
} // namespace caudal
