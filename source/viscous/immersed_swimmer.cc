// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/immersed_swimmer.h>

#include <caudal/base/archive.h>
#include <caudal/base/collective.h>
#include <caudal/base/print.h>
#include <caudal/fluid/boundary_flux.h>
#include <caudal/io/progress.h>
#include <caudal/observe/tail_beats.h>
#include <caudal/viscous/adaptation.h>
#include <caudal/viscous/body_distance.h>
#include <caudal/viscous/failure_report.h>

#include <deal.II/base/utilities.h>

#include <iomanip>

namespace caudal
{
  namespace
  {
    // The part of a checkpoint that holds the reports.
    const std::string output_part = "energies, tail beats or counters of the output";
    const std::string report_part = "results of the last step";

    // --check tries no steps that are expected to take longer [s].
    constexpr double longest_trial_step = 10;
  } // namespace

  template <int dim>
  ImmersedSwimmer<dim>::ImmersedSwimmer(const RunParameters<dim> &parameters, MPI_Comm communicator)
      : parameters(parameters)
      , communicator(communicator)
      , operators(parameters, communicator)
      , state{TimeStepper(parameters.time), {}, {}, {}}
      , observers(parameters.observers)
      , writer(parameters.checkpoint, communicator)
  {
    report.bodies.resize(operators.bodies.size());
  }

  template <int dim>
  void ImmersedSwimmer<dim>::start()
  {
    check_places();
    check_resolution(operators);
    for (const auto &body : operators.bodies)
      body->check_until(parameters.time.end_time);
    state       = make_initial_state(operators);
    report.flow = summarise_flow(operators.space, state.fluid.velocity);
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
      report.bodies[b].deformation =
          summarise_deformation(operators.bodies[b]->get_solid(), state.bodies[b].positions);
    check_boundary_flux(operators.space, parameters.time.end_time);
    observers.check_case(observe());
  }

  template <int dim>
  void ImmersedSwimmer<dim>::resume_from(Checkpoint checkpoint)
  {
    for (const auto &body : operators.bodies)
      body->check_until(parameters.time.end_time);
    state = restore(checkpoint, operators);
    unpack(checkpoint.parts.at(report_part), report);
    resumed = std::move(checkpoint);
    observers.check_case(observe());
  }

  template <int dim>
  void ImmersedSwimmer<dim>::check_places() const
  {
    const BoundingBox<dim> domain = operators.get_domain();
    std::vector<BodyState> states;
    for (const auto &body : operators.bodies)
    {
      states.push_back(body->make_initial_state());
      for (const auto &node : body->get_solid().get_nodes())
      {
        const Point<dim> point = get_value(states.back().positions, node);
        Point<dim>       place = point;
        for (unsigned int d = 0; d < dim; ++d)
          if (parameters.domain.is_periodic(d))
            place[d] = domain.lower_bound(d);
        AssertThrow(domain.point_inside(place),
                    ExcMessage("Body " + body->get_name() +
                               "/Shape/Position: the body reaches the point (" +
                               print_place(point) +
                               "), which is outside of the domain. Move the body, or "
                               "change Domain/Size."));
        for (const auto &other : operators.bodies)
          AssertThrow(other == body || !other->get_solid().contains_at_start(point),
                      ExcMessage("Body " + body->get_name() +
                                 "/Shape/Position: the body overlaps "
                                 "with body " +
                                 other->get_name() + " at (" + print_place(point) +
                                 "). Place them apart."));
      }
    }
    check_distances(operators, states);
  }

  template <int dim>
  void ImmersedSwimmer<dim>::print_summary(const CaseCheck<dim> &check, std::ostream &out) const
  {
    std::vector<unsigned int> cells_per_level(parameters.domain.levels, 0);
    for (const auto &cell : operators.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        ++cells_per_level[cell->level()];
    Utilities::MPI::sum(cells_per_level, communicator, cells_per_level);
    const Tensor<1, dim> spacing = parameters.domain.get_finest_spacing();
    out << "Fluid: " << operators.triangulation.n_global_active_cells() << " cells (by level";
    for (const unsigned int n : cells_per_level)
      out << ' ' << n;
    out << "), " << operators.space.velocity_dofs.n_dofs() << " velocity and "
        << operators.space.pressure_dofs.n_dofs() << " pressure unknowns, finest spacing "
        << spacing << " m\n";
    if (dim == 3 || operators.solver.is_iterative())
      out << operators.solver.describe_method() << ".\n";
    for (const auto &body : operators.bodies)
    {
      const SolidBody<dim> &solid = body->get_solid();
      out << "Body " << body->get_name() << ": " << solid.get_triangulation().n_active_cells()
          << " cells, " << solid.n_dofs() << " unknowns, volume " << solid.get_reference_volume()
          << (dim == 2 ? " m^2" : " m^3") << ", length " << body->get_length() << " m\n";
      if (!body->describe_gait().empty())
        out << "Gait of body " << body->get_name() << ": " << body->describe_gait() << ".\n";
    }
    for (const std::string &warning : check.find_warnings())
      out << "Warning: " << warning << '\n';
  }

  template <int dim>
  void ImmersedSwimmer<dim>::check(std::ostream &out, const bool fast)
  {
    const CaseCheck<dim> check(operators, operators.triangulation.n_global_active_cells());
    print_summary(check, out);
    check.print_resolution(out);
    const StepCost estimate =
        operators.solver.is_iterative() ? estimate_iterative_step(operators) : StepCost();
    check.print_costs(out, fast || estimate.seconds > longest_trial_step ? estimate : try_steps(4));
    const std::size_t n_warnings = check.find_warnings().size();
    if (n_warnings == 0)
      out << "No problems found.\n";
    else
      out << "The case can be run; see the " << (n_warnings == 1 ? "warning" : "warnings")
          << " above.\n";
  }

  template <int dim>
  StepCost ImmersedSwimmer<dim>::try_steps(const unsigned int n_steps)
  {
    StepCost cost;
    Timer    trial_clock(communicator);
    while (cost.n_steps < n_steps && !state.time.is_at_end())
    {
      if (cost.n_steps == 1)
        trial_clock.restart();
      state = advance(operators, state, state.time.get_step()).state;
      ++cost.n_steps;
    }
    if (cost.n_steps > 1)
      cost.seconds =
          Utilities::MPI::max(trial_clock.wall_time(), communicator) / (cost.n_steps - 1);
    cost.memory = get_memory();
    return cost;
  }

  template <int dim>
  Observation<dim> ImmersedSwimmer<dim>::observe() const
  {
    Observation<dim> observation{state.time.get_time(),
                                 state.time.get_previous_step(),
                                 state.time.get_step_number(),
                                 state.time.is_at_end(),
                                 state.frame.origin,
                                 parameters.domain.has_moving_frame(),
                                 operators.space,
                                 operators.lattice,
                                 state.fluid,
                                 report,
                                 operators.coupling.get_support(),
                                 {}};
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
      observation.bodies.push_back({*operators.bodies[b], state.bodies[b], report.bodies[b]});
    return observation;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::adapt_grid(Log &log)
  {
    const unsigned int step_number = state.time.get_step_number();
    const bool is_due = step_number > 0 && step_number % parameters.refinement.interval == 0;
    if (!is_due && !adaptation_is_needed(operators, state))
      return;
    const AdaptationReport adaptation = adapt(operators, state);
    if (!adaptation.changed)
      return;
    {
      TimerOutput::Scope timer_section(operators.timer, "output");
      observers.observe_new_grid(observe());
    }
    if (!(std::abs(adaptation.momentum_change) < 1e-3))
      log << "Warning: adapting the grid at t = " << state.time.get_time()
          << " s changed the momentum by " << adaptation.momentum_change
          << " of that of the fastest flow, the kinetic energy by "
          << adaptation.kinetic_energy_change << ' ' << get_extensive_unit<dim>("J") << ".\n";
  }

  /** A step that fails is tried again with half its size, unless it was too often: the run ends. */
  template <int dim>
  Step<dim> ImmersedSwimmer<dim>::advance_with_retries(Log &log) const
  {
    double dt = state.time.get_step();
    for (unsigned int n_retries = 0;; ++n_retries)
      try
      {
        return advance(operators, state, dt);
      }
      catch (const StepFailure &failure)
      {
        log << "The step from t = " << state.time.get_time() << " s with " << dt << " s failed. "
            << failure.what() << std::endl;
        const std::string error =
            catch_error([&]() { dt = state.time.halve(dt, n_retries, failure.what()); });
        AssertThrow(error.empty(),
                    ExcMessage(error + "\n" + describe_failure(failure, operators, state)));
      }
  }

  template <int dim>
  void ImmersedSwimmer<dim>::set_parameter_values(const ParameterValues &values)
  {
    parameter_values = values;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::run_to_end(Log &log, const std::function<bool()> &stop_requested)
  {
    Progress   progress(is_terminal() ? std::cout : log.get_stream(), state.time.get_time(),
                      parameters.time.end_time, is_terminal());
    const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
    while (!state.time.is_at_end() && !stop_requested() && !writer.is_out_of_time())
    {
      state.time.check_step();
      adapt_grid(log);
      Step<dim> step = advance_with_retries(log);
      state          = std::move(step.state);
      report         = std::move(step.report);
      {
        TimerOutput::Scope timer_section(operators.timer, "output");
        observers.observe_step(observe());
      }

      std::ostringstream details;
      details << std::setprecision(3) << "dt " << state.time.get_previous_step() << " s, "
              << operators.triangulation.n_global_active_cells() << " cells, " << report.iterations
              << " iterations, max |u| " << report.flow.largest_velocity << " m/s";
      if (is_root)
        progress.update(state.time.get_time(), state.time.get_step_number(), details.str());
      if (writer.is_due(state.time.get_step_number()))
        write_checkpoint();
    }
    if (is_root)
      progress.finish();
  }

  template <int dim>
  Outcome ImmersedSwimmer<dim>::run(const OutputFolder &folder, Log &log,
                                    const std::function<bool()> &stop_requested)
  {
    print_summary(
        CaseCheck<dim>(operators, resumed ? 0 : operators.triangulation.n_global_active_cells()),
        log.get_stream());
    log << std::endl;
    observers.start(observe(), folder, log, parameters.output, resumed.has_value());
    writer.start(folder);
    if (resumed)
    {
      unpack(resumed->parts.at(output_part), observers);
      observers.resume(observe());
      if (state.time.is_at_end())
        log << "Nothing to do: the run has come to its end time. Give a later one to go on, -D "
               "\"Time/End time=...\"."
            << std::endl;
    }
    resumed.reset();
    const unsigned int first_step = state.time.get_step_number();
    const double       start      = state.time.get_time();
    try
    {
      run_to_end(log, stop_requested);
    }
    catch (...)
    {
      write_last_state(log);
      throw;
    }
    // The checkpoint comes first: the fields of a stopped run are not due.
    write_checkpoint();
    observers.finish(observe());
    if (!state.time.is_at_end())
      log << describe_stop(stop_requested(), state.time.get_time(), state.time.get_step_number(),
                           folder.path())
          << std::endl;

    observers.print_warnings();
    if (state.time.get_step_number() > first_step)
      print_costs(state.time.get_step_number() - first_step, state.time.get_time() - start,
                  observers.template get<TailBeats<dim>>().get_last_period(), log.get_stream());
    return state.time.is_at_end() ? Outcome::finished : Outcome::stopped;
  }

  template <int dim>
  void ImmersedSwimmer<dim>::write_checkpoint()
  {
    const unsigned int step_number = state.time.get_step_number();
    if (writer.has_written(step_number))
      return;
    TimerOutput::Scope timer_section(operators.timer, "checkpoint");
    Checkpoint         checkpoint = take_checkpoint(operators, state);
    checkpoint.parameters         = parameter_values;
    checkpoint.parts[report_part] = pack(report);
    checkpoint.parts[output_part] = pack(observers);
    writer.write(pack(checkpoint), pack(checkpoint.fluid), step_number, state.time.get_time());
  }

  template <int dim>
  void ImmersedSwimmer<dim>::write_last_state(Log &log)
  {
    // One may fail for the reason that ended the run.
    const bool has_checkpoint = catch_error([&]() { write_checkpoint(); }).empty();
    const bool has_fields     = catch_error([&]() { observers.finish(observe()); }).empty();
    log << "The last good state, at t = " << state.time.get_time() << " s, is written "
        << (has_checkpoint && has_fields ? "as fields and as a checkpoint"
            : has_checkpoint             ? "as a checkpoint, but not as fields"
            : has_fields                 ? "as fields, but not as a checkpoint"
                                         : "neither as a checkpoint nor as fields")
        << "." << std::endl;
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
        << " steps/s, " << operators.solver.get_n_factorisations() << " factorisations of up to "
        << operators.solver.get_factor_entries() << " entries, "
        << (operators.solver.get_n_pivoting_factorisations() == 0
                ? ""
                : std::to_string(operators.solver.get_n_pivoting_factorisations()) +
                      " of them with pivots from all rows, which is slow, ")
        << get_memory() << " MiB of memory on all ranks";
    if (duration > 0)
      out << ", " << total / duration << " s of wall time for a simulated second";
    if (duration > 0 && period > 0)
      out << ", " << total / duration * period << " s for a tail beat";
    out << ". Wall time of rank 0:\n";
    for (const auto &[section, seconds] :
         operators.timer.get_summary_data(TimerOutput::total_wall_time))
      out << "  " << std::left << std::setw(24) << section << std::right << std::setw(9)
          << std::fixed << std::setprecision(1) << seconds << " s" << std::setw(7)
          << 100 * seconds / total << " %\n";
    out << std::defaultfloat << std::flush;
  }

  template class ImmersedSwimmer<2>;
  template class ImmersedSwimmer<3>;
} // namespace caudal
