// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/archive.h>
#include <caudal/base/collective.h>
#include <caudal/base/memory.h>
#include <caudal/base/safe_file.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/ideal/resistance.h>
#include <caudal/ideal/swim.h>
#include <caudal/ideal/swim_summary.h>
#include <caudal/io/progress.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace caudal
{
  using namespace ideal;

  namespace
  {
    const unsigned int n_phases_of_averages = 720;

    std::string get_table_name(const std::string &suffix)
    {
      return "statistics" + suffix + ".txt";
    }

    /** The name of a swim in the list of fields. */
    std::string get_block_name(const std::string &suffix)
    {
      return "fish" + suffix;
    }
  } // namespace

  IdealSwimmer::IdealSwimmer(const IdealParameters &parameters, const MPI_Comm communicator)
      : parameters(parameters)
      , communicator(communicator)
      , the_case(parameters)
      , swimming_shape(the_case.surface, *the_case.deformation, *the_case.gait,
                       parameters.get_densities(), the_case.get_torques(),
                       the_case.uses_table() ? MPI_COMM_SELF : communicator)
      , checkpoints(parameters.checkpoint, communicator)
  {
    const double n = the_case.surface.n_nodes();
    check_memory(communicator,
                 n * n * sizeof(double) * Utilities::MPI::n_mpi_processes(communicator),
                 "Surface/Cells along: there are " + std::to_string(the_case.surface.n_nodes()) +
                     " panels on the surface",
                 "Give fewer cells along or across.");
  }

  std::string IdealSwimmer::get_suffix(const double frequency) const
  {
    if (the_case.gait->get_frequencies().size() == 1)
      return "";
    std::ostringstream text;
    text << "_" << frequency << "Hz";
    return text.str();
  }

  std::unique_ptr<StrokeModel> IdealSwimmer::create_model(Log &log)
  {
    const double shortest_step = std::min(parameters.time.step, parameters.time.first_step);
    if (!the_case.uses_table())
      return create_brute_force(swimming_shape,
                                the_case.gait->is_periodic() ? 1e-3 : 0.1 * shortest_step);
    Timer timer(communicator);
    auto  table =
        std::make_unique<PhaseTable>(swimming_shape, parameters.integration.n_phases, communicator);
    const auto cost = swimming_shape.boundary_elements.get_cost();
    timer.stop();
    log << "Table of phases: " << table->get_n_computed() << " shapes, " << timer.cpu_time()
        << " s of CPU, " << timer.wall_time() << " s; on rank 0 assembly " << cost.assembly
        << " s, solution " << cost.solution << " s, gradient of the energy " << cost.gradient
        << " s of CPU." << std::endl;
    return table;
  }

  void IdealSwimmer::write_checkpoint(const Output &output)
  {
    if (checkpoints.has_written(state.step_number))
      return;
    state.fields = output.fields.get_series();
    checkpoints.write(pack(state), "", state.step_number, state.time);
  }

  /** Removes the summary, and the tables of swims that are to begin anew. */
  void IdealSwimmer::remove_later_results(const Output &output) const
  {
    run_on_root(communicator, [&]() {
      for (const char *const ending : {"txt", "csv", "json"})
        std::filesystem::remove(output.folder.path(std::string("summary.") + ending));
    });
    const std::vector<double> frequencies = the_case.gait->get_frequencies();
    for (std::size_t k = 0; k < frequencies.size(); ++k)
    {
      const std::string table = output.folder.path(get_table_name(get_suffix(frequencies[k])));
      if (k >= state.swims.size())
        run_on_root(communicator, [&]() { std::filesystem::remove(table); });
    }
  }

  bool IdealSwimmer::swim(StrokeModel &model, const double frequency, SwimState &swim_state,
                          Output &output, const std::function<bool()> &stop_requested)
  {
    MotionProblem problem;
    problem.model      = &model;
    problem.rate       = the_case.gait->get_argument_rate(frequency);
    problem.length     = the_case.deformation->get_length();
    problem.tolerance  = parameters.integration.tolerance;
    problem.integrator = the_case.uses_table() ? Integrator::adaptive : Integrator::given_steps;
    problem.force      = create_resistance(parameters.resistance, swimming_shape);

    const bool        is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
    const std::string suffix  = get_suffix(frequency);
    const Instants    instants(parameters.time.get_times(),
                            the_case.has_strokes() ? 1. / frequency : 0.);
    Statistics        table(is_root ? output.folder.add_table(get_table_name(suffix)) : "",
                     swim_state.has_begun() ? swim_state.last.time : -1.);
    SurfaceOutput surface(swimming_shape, model, output.fields, get_block_name(suffix),
                          parameters.output.n_subdivisions);
    Swim          swim(problem, instants, *the_case.gait, the_case.get_torques() != Torques::none,
                       parameters.output, table, surface, swim_state);
    if (!swim_state.has_begun())
      swim.start(parameters.body.get_impulse());

    Progress   progress(is_terminal() ? std::cout : output.log.get_stream(), swim_state.last.time,
                      instants.times.back(), is_terminal());
    const bool shows_progress = !the_case.uses_table() && is_root;
    while (!swim.is_at_end() && !stop_requested() && !checkpoints.is_out_of_time())
    {
      BodyState         body;
      const std::string error = catch_error([&]() { body = swim.integrate(); });
      if (!error.empty())
      {
        write_checkpoint(output);
        AssertThrow(false,
                    ExcMessage(error + " The last state, t = " + std::to_string(state.time) +
                               " s, is kept: caudal --resume " + output.folder.path() + "."));
      }
      swim.take(body);
      state.time = swim_state.last.time;
      ++state.step_number;
      if (shows_progress)
        progress.update(state.time, state.step_number);
      if (checkpoints.is_due(state.step_number))
        write_checkpoint(output);
    }
    if (shows_progress)
      progress.finish();
    return swim.is_at_end();
  }

  void IdealSwimmer::write_summaries(StrokeModel &model, const OutputFolder &folder, Log &log) const
  {
    const bool     has_torques = the_case.get_torques() != Torques::none;
    const bool     are_equal   = the_case.uses_table() && the_case.is_from_rest(); // the strokes
    EnergyAverages stroke;
    if (are_equal)
      stroke = average_stroke(model, n_phases_of_averages, has_torques);

    std::vector<SwimSummary> summaries;
    for (std::size_t k = 0; k < state.swims.size(); ++k)
    {
      const double frequency = the_case.gait->get_frequencies()[k];
      SwimSummary  summary(state.swims[k]);
      summary.coordinate  = the_case.gait->get_coordinate_name();
      summary.frequency   = the_case.has_strokes() ? frequency : 0.;
      summary.length      = the_case.deformation->get_length();
      summary.mass        = the_case.compute_mass();
      summary.has_torques = has_torques;
      if (are_equal)
        summary.energy = stroke.at_rate(the_case.gait->get_argument_rate(frequency));
      summaries.push_back(summary);
    }
    run_on_root(communicator, [&]() {
      replace_file(folder.add("summary.txt"), print_text(summaries));
      replace_file(folder.add("summary.csv"), print_csv(summaries));
      replace_file(folder.add("summary.json"), print_json(summaries));
      log << "\n" << print_text(summaries);
    });
  }

  Outcome IdealSwimmer::run(const OutputFolder &folder, Log &log,
                            const std::function<bool()> &stop_requested)
  {
    Timer timer;
    the_case.print_summary(log.get_stream());
    const auto model      = create_model(log);
    const bool is_resumed = !state.swims.empty();
    Output     output{folder, log,
                  FieldOutput(folder, parameters.output.format, communicator, state.fields)};
    if (is_resumed)
      remove_later_results(output);
    checkpoints.start(folder);

    const std::vector<double> frequencies = the_case.gait->get_frequencies();
    bool                      is_at_end   = true;
    for (std::size_t k = 0; k < frequencies.size() && is_at_end; ++k)
    {
      if (k == state.swims.size())
        state.swims.emplace_back();
      is_at_end = swim(*model, frequencies[k], state.swims[k], output, stop_requested);
    }
    write_checkpoint(output);
    if (is_at_end)
      write_summaries(*model, folder, log);
    else
      log << describe_stop(stop_requested(), state.time, state.step_number, folder.path())
          << std::endl;
    log << "CPU of rank 0: " << timer.cpu_time() << " s." << std::endl;
    return is_at_end ? Outcome::finished : Outcome::stopped;
  }
} // namespace caudal
