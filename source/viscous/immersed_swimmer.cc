#include <caudal/viscous/immersed_swimmer.h>

#include <caudal/base/collective.h>
#include <caudal/io/progress.h>
#include <caudal/viscous/body_distance.h>
#include <caudal/viscous/control_volume_force.h>

#include <deal.II/base/utilities.h>
#include <deal.II/lac/solver_control.h>

#include <iomanip>

namespace caudal
{
  template <int dim>
  ImmersedSwimmer<dim>::ImmersedSwimmer(const RunParameters<dim> &parameters, MPI_Comm communicator)
      : parameters(parameters)
      , communicator(communicator)
      , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
      , triangulation(communicator)
      , lattice(parameters.domain)
      , space(triangulation, parameters.domain, parameters.fluid)
      , momentum(space)
      , coupled_system(parameters.solver, space, momentum, timer)
      , system{space,   momentum,     coupled_system,    fluid, bodies,
               lattice, finest_cells, parameters.solver, timer}
      , adaptation(triangulation, space, parameters.refinement, system)
      , scheme(parameters.time.is_explicit() ? create_explicit_scheme<dim>(system)
                                             : create_semi_implicit_scheme<dim>(system))
      , checkpoints(parameters, triangulation, space, adaptation, system)
      , guards(parameters.guards, system)
  {
    make_domain(triangulation, parameters.domain);
    AssertThrow(
        triangulation.n_global_active_cells() >= Utilities::MPI::n_mpi_processes(communicator),
        ExcMessage("Domain/Cells: there are " +
                   std::to_string(Utilities::MPI::n_mpi_processes(communicator)) +
                   " ranks, but only " + std::to_string(triangulation.n_global_active_cells()) +
                   " coarse cells. Run on fewer ranks or give more cells."));
    for (const auto &body : parameters.bodies)
      bodies.push_back(std::make_unique<SwimmingBody<dim>>(*body, parameters.coupling,
                                                           parameters.fluid.density, communicator));
    check_probes();
    check_bodies();
    adaptation.make_initial_grid();
    start_bodies();
    check_control_volume();
  }

  template <int dim>
  BoundingBox<dim> ImmersedSwimmer<dim>::get_domain() const
  {
    const Point<dim> &lower = parameters.domain.lower_corner;
    const Point<dim>  upper = lower + parameters.domain.size;
    return BoundingBox<dim>({lower, upper});
  }

  template <int dim>
  void ImmersedSwimmer<dim>::check_probes() const
  {
    for (const Point<dim> &probe : parameters.fluid.probes)
    {
      std::ostringstream place;
      place << "(" << probe << ")";
      AssertThrow(get_domain().point_inside(probe),
                  ExcMessage("Fluid/Probes: the point " + place.str() +
                             " is outside of the domain. Move it, or change Domain/Size."));
    }
  }

  template <int dim>
  void ImmersedSwimmer<dim>::check_bodies() const
  {
    const BoundingBox<dim> domain = get_domain();
    for (const auto &body : bodies)
      for (const auto &node : body->solid.get_nodes())
      {
        Point<dim> point;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = body->solid.positions[node[d]];
        std::ostringstream place;
        place << "(" << point << ")";
        AssertThrow(domain.point_inside(point),
                    ExcMessage("Body " + body->get_name() +
                               "/Shape/Position: the body reaches the point " + place.str() +
                               ", which is outside of the domain. Move the body, or "
                               "change Domain/Size."));
        for (const auto &other : bodies)
          if (other != body)
          {
            AssertThrow(!other->solid.contains_at_start(point),
                        ExcMessage("Body " + body->get_name() +
                                   "/Shape/Position: the body overlaps "
                                   "with body " +
                                   other->get_name() + " at " + place.str() +
                                   ". Place them apart."));
          }
      }
    check_distances(bodies, lattice);
  }

  template <int dim>
  void ImmersedSwimmer<dim>::check_control_volume() const
  {
    const auto &corners = parameters.fluid.control_volume;
    AssertThrow(corners.empty() ||
                    ControlVolumeForce<dim>(system, BoundingBox<dim>({corners[0], corners[1]}))
                        .has_all_bodies(),
                ExcMessage("Fluid/Control volume: the coarse cells with their centre in it do not "
                           "hold all bodies with their kernels. Give a larger one."));
  }

  /** In an initial flow the bodies move with it. */
  template <int dim>
  void ImmersedSwimmer<dim>::start_bodies()
  {
    for (const auto &body : bodies)
    {
      SolidBody<dim> &solid = body->solid;
      body->interaction.reinit(*finest_cells, space.velocity_dofs, space.constraints,
                               fluid.velocity, solid.get_dof_handler(), solid.positions,
                               body->get_name());
      body->interaction.interpolate(fluid.velocity, solid.velocity);
      solid.apply_inverse_mass(solid.velocity);
      solid.old_velocity = solid.velocity;
    }
  }

  template <int dim>
  void ImmersedSwimmer<dim>::print_summary(const CaseCheck<dim> &check, std::ostream &out) const
  {
    std::vector<unsigned int> cells_per_level(parameters.domain.levels, 0);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        ++cells_per_level[cell->level()];
    Utilities::MPI::sum(cells_per_level, communicator, cells_per_level);
    const Tensor<1, dim> spacing = parameters.domain.get_finest_spacing();
    out << "Fluid: " << triangulation.n_global_active_cells() << " cells (by level";
    for (const unsigned int n : cells_per_level)
      out << ' ' << n;
    out << "), " << space.velocity_dofs.n_dofs() << " velocity and " << space.pressure_dofs.n_dofs()
        << " pressure unknowns, finest spacing " << spacing << " m\n";
    for (const auto &body : bodies)
    {
      const SolidBody<dim> &solid = body->solid;
      out << "Body " << body->get_name() << ": " << solid.get_triangulation().n_active_cells()
          << " cells, " << solid.n_dofs() << " unknowns, volume " << solid.get_reference_volume()
          << (dim == 2 ? " m^2" : " m^3") << ", length " << body->get_length() << " m\n";
    }
    for (const std::string &doubt : check.find_doubts())
      out << "Warning: " << doubt << '\n';
  }

  template <int dim>
  void ImmersedSwimmer<dim>::check(std::ostream &out, const bool fast)
  {
    const CaseCheck<dim> check(parameters, system);
    print_summary(check, out);
    check.print_resolution(out);
    check.print_costs(out, fast ? TrialCost() : try_steps(4));
    const std::size_t n_doubts = check.find_doubts().size();
    if (n_doubts == 0)
      out << "Nothing speaks against a run.\n";
    else
      out << "The case can be run; see the " << (n_doubts == 1 ? "warning" : "warnings")
          << " above.\n";
  }

  template <int dim>
  TrialCost ImmersedSwimmer<dim>::try_steps(const unsigned int n_steps)
  {
    TimeStepper stepper(parameters.time);
    TrialCost   cost;
    Timer       trial_clock(communicator);
    while (cost.n_steps < n_steps && !stepper.is_at_end())
    {
      if (cost.n_steps == 1)
        trial_clock.restart();
      const StepResult<dim> result = scheme->advance(stepper);
      scheme->accept(stepper.get_step());
      stepper.accept(result.indicators);
      ++cost.n_steps;
    }
    if (cost.n_steps > 1)
      cost.seconds =
          Utilities::MPI::max(trial_clock.wall_time(), communicator) / (cost.n_steps - 1);
    cost.memory = get_memory();
    return cost;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::adapt_grid(const TimeStepper &stepper, RunOutput<dim> &output,
                                        Log &log)
  {
    const bool is_due = stepper.get_step_number() > 0 &&
                        stepper.get_step_number() % parameters.refinement.interval == 0;
    if (!is_due && !adaptation.is_needed())
      return;
    const AdaptationReport report = adaptation.adapt(
        stepper.get_time(), stepper.get_time() - stepper.get_previous_step(), stepper.get_step());
    if (report.changed)
      output.report_new_grid(stepper.get_time());
    if (report.changed && !(std::abs(report.momentum_change) < 1e-3))
      log << "Warning: adapting the grid at t = " << stepper.get_time()
          << " s changed the momentum by " << report.momentum_change
          << " of that of the fastest flow, the kinetic energy by " << report.kinetic_energy_change
          << ' ' << get_extensive_unit<dim>("J") << ".\n";
  }

  template <int dim>
  StepResult<dim> ImmersedSwimmer<dim>::advance(TimeStepper &stepper, Log &log)
  {
    for (;;)
    {
      std::string reason;
      FailureKind kind = FailureKind::other;
      try
      {
        return scheme->advance(stepper);
      }
      catch (const SolverControl::NoConvergence &exception)
      {
        kind   = FailureKind::no_convergence;
        reason = "The linear solver did not converge (residual " +
                 std::to_string(exception.last_residual) +
                 "; Solver/Largest number of iterations).";
      }
      catch (const ExcBodiesMeet &)
      {
        throw; // smaller steps would bring them no less close
      }
      catch (const ExceptionBase &exception)
      {
        std::ostringstream text;
        exception.print_info(text);
        reason = Utilities::trim(text.str());
        if (dynamic_cast<const ExcInvertedElement *>(&exception) != nullptr)
          kind = FailureKind::inverted_element;
        else if (dynamic_cast<const ExcNotFinite *>(&exception) != nullptr)
          kind = FailureKind::not_finite;
      }
      reject(stepper, kind, reason, log);
    }
  }

  /** The step is tried again with half its size, unless it was too often: then the run ends. */
  template <int dim>
  void ImmersedSwimmer<dim>::reject(TimeStepper &stepper, const FailureKind kind,
                                    const std::string &reason, Log &log)
  {
    log << "The step from t = " << stepper.get_time() << " s with " << stepper.get_step()
        << " s failed. " << reason << std::endl;
    const std::string error = catch_error([&]() { stepper.reject(reason); });
    AssertThrow(error.empty(),
                ExcMessage(error + "\n" + describe_failure(kind, system, get_domain())));
  }

  template <int dim>
  void ImmersedSwimmer<dim>::set_parameter_values(const ParameterValues &values)
  {
    parameter_values = values;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::resume_from(RunState state)
  {
    resumed = std::move(state);
  }

  template <int dim>
  void ImmersedSwimmer<dim>::run_to_end(TimeStepper &stepper, RunOutput<dim> &output, Log &log,
                                        const std::function<bool()> &stop_requested)
  {
    Progress   progress(is_terminal() ? std::cout : log.get_stream(), stepper.get_time(),
                      parameters.time.end_time, is_terminal());
    const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
    while (!stepper.is_at_end() && !stop_requested() && !checkpoints.is_out_of_time())
    {
      stepper.check_step();
      adapt_grid(stepper, output, log);
      const StepResult<dim> result = advance(stepper, log);
      scheme->accept(stepper.get_step());
      stepper.accept(result.indicators);
      output.report_step(stepper, result, triangulation.n_global_active_cells());
      guards.check(stepper.get_time(), output.get_ledger(), output.get_initial_ledger(), log);

      std::ostringstream details;
      details << std::setprecision(3) << "dt " << stepper.get_previous_step() << " s, "
              << triangulation.n_global_active_cells() << " cells, " << result.iterations
              << " iterations, max |u| " << output.get_largest_velocity() << " m/s";
      if (is_root)
        progress.update(stepper.get_time(), stepper.get_step_number(), details.str());
      if (checkpoints.is_due())
        checkpoints.write(/*goes_on=*/!stepper.is_at_end());
    }
    if (is_root)
      progress.finish();
  }

  template <int dim>
  Outcome ImmersedSwimmer<dim>::run(const OutputFolder &folder, Log &log,
                                    const std::function<bool()> &stop_requested)
  {
    print_summary(CaseCheck<dim>(parameters, system), log.get_stream());
    log << std::endl;
    TimeStepper    stepper(parameters.time);
    RunOutput<dim> output(
        parameters, system, folder, log,
        resumed ? std::make_optional(KeptResults{resumed->time, resumed->last_field_time})
                : std::nullopt);
    checkpoints.start(folder, parameter_values, stepper, output);
    if (resumed)
      checkpoints.restore(*resumed);
    else
      output.write_fields(0);
    resumed.reset();
    const unsigned int first_step = stepper.get_step_number();
    const double       start      = stepper.get_time();
    try
    {
      run_to_end(stepper, output, log, stop_requested);
    }
    catch (...)
    {
      write_last_state(stepper, output, log);
      throw;
    }
    // The checkpoint comes first: the fields of a stopped run are not due.
    checkpoints.write(/*goes_on=*/false);
    output.write_fields(stepper.get_time());
    output.finish();
    if (!stepper.is_at_end())
      log << describe_stop(stop_requested(), stepper.get_time(), stepper.get_step_number(),
                           folder.path())
          << std::endl;

    guards.print_summary(log);
    print_costs(stepper.get_step_number() - first_step, stepper.get_time() - start,
                output.get_last_beat_period(), log.get_stream());
    return stepper.is_at_end() ? Outcome::finished : Outcome::stopped;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::write_last_state(const TimeStepper &stepper, RunOutput<dim> &output,
                                              Log &log)
  {
    log << "The last good state, at t = " << stepper.get_time() << " s, is written as fields and "
        << "as a checkpoint." << std::endl;
    try
    {
      checkpoints.write(/*goes_on=*/false);
      output.write_fields(stepper.get_time());
      output.finish();
    }
    catch (const std::exception &)
    {
      log << "It could not be written." << std::endl; // for the reason that ended the run
    }
  }

  template <int dim>
  unsigned int ImmersedSwimmer<dim>::get_memory() const
  {
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    return Utilities::MPI::sum(memory.VmHWM, communicator) / 1024;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::print_costs(const unsigned int n_steps, const double duration,
                                         const double period, std::ostream &out) const
  {
    const double total = clock.wall_time();
    out << "\n"
        << n_steps << " steps in " << format_duration(total) << ", " << n_steps / total
        << " steps/s, " << coupled_system.get_n_factorisations() << " factorisations of up to "
        << coupled_system.get_factor_entries() << " entries, " << get_memory()
        << " MiB of memory on all ranks";
    if (duration > 0)
      out << ", " << total / duration << " s of wall time for a simulated second";
    if (duration > 0 && period > 0)
      out << ", " << total / duration * period << " s for a tail beat";
    out << ". Wall time of rank 0:\n";
    for (const auto &[section, seconds] : timer.get_summary_data(TimerOutput::total_wall_time))
      out << "  " << std::left << std::setw(24) << section << std::right << std::setw(9)
          << std::fixed << std::setprecision(1) << seconds << " s" << std::setw(7)
          << 100 * seconds / total << " %\n";
    out << std::defaultfloat << std::flush;
  }

  template class ImmersedSwimmer<2>;
  template class ImmersedSwimmer<3>;
} // namespace caudal
