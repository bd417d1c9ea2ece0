#include <caudal/base/archive.h>
#include <caudal/base/collective.h>
#include <caudal/ideal/phase_table.h>
#include <caudal/ideal/potential_swim.h>
#include <caudal/ideal/potential_swimmer.h>
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

    /** "0.64Hz" */
    std::string print_frequency(const double frequency)
    {
      std::ostringstream text;
      text << frequency << "Hz";
      return text.str();
    }

    /** Replaces the file's contents. */
    void write_text(const std::string &file_name, const std::string &text)
    {
      std::ofstream file(file_name);
      file << text;
      file.close();
      AssertThrow(file, ExcMessage("The file <" + file_name + "> can't be written."));
    }
  } // namespace

  PotentialSwimmer::PotentialSwimmer(const PotentialParameters &parameters,
                                     const MPI_Comm             communicator)
      : parameters(parameters)
      , communicator(communicator)
      , surface(parameters.surface)
      , gait(create_gait(parameters.gait))
      , shape(create_shape(parameters.shape, surface))
      , deformation(gait->create_deformation(surface, *shape))
      , checkpoints(parameters.checkpoint, communicator)
  {
    check_shape();
    swimming_shape =
        std::make_unique<SwimmingShape>(surface, *deformation, *gait, parameters.get_densities(),
                                        get_torques(), uses_table() ? MPI_COMM_SELF : communicator);
  }

  void PotentialSwimmer::check_shape() const
  {
    AssertThrow(
        parameters.time.end_time <= gait->get_end() * (1. + 1e-9),
        ExcMessage("Time/End time: the value is " + std::to_string(parameters.time.end_time) +
                   " s, but the gait's table ends after " + std::to_string(gait->get_end()) +
                   " s. Lengthen the table, shorten the run, or set "
                   "Gait/Table/Periodic."));
    const unsigned int n_samples = 256;
    const double       end = gait->is_periodic() ? 2. * numbers::PI : parameters.time.end_time;
    for (unsigned int k = 0; k < n_samples; ++k)
    {
      const double bend = deformation->compute_bend(gait->evaluate(end * k / n_samples).c);
      AssertThrow(bend < 1.,
                  ExcMessage("Gait: the body would intersect itself, since its width relative to "
                             "the room that the bend leaves (half-width times curvature, or two "
                             "half-widths over their distance) reaches " +
                             std::to_string(bend) +
                             " and has to stay below 1. Reduce the gait's Amplitude, Curvature "
                             "or Bias, or the half-widths in section Shape."));
    }
  }

  bool PotentialSwimmer::uses_table() const
  {
    return parameters.integration.method == "table" && gait->is_periodic();
  }

  bool PotentialSwimmer::is_periodic() const
  {
    return gait->is_periodic() && deformation->n_modes() > 0;
  }

  bool PotentialSwimmer::is_from_rest() const
  {
    return parameters.body.is_from_rest() && !parameters.resistance.active &&
           deformation->n_modes() > 0;
  }

  bool PotentialSwimmer::has_torques() const
  {
    return parameters.integration.torques && deformation->n_modes() > 0;
  }

  Torques PotentialSwimmer::get_torques() const
  {
    return !has_torques() ? Torques::none : is_from_rest() ? Torques::from_rest : Torques::any;
  }

  void PotentialSwimmer::check(std::ostream &out, bool /*fast*/) const
  {
    print_summary(out);
    out << "No problems found.\n";
  }

  void PotentialSwimmer::set_parameter_values(const ParameterValues &values)
  {
    state.parameters = values;
  }

  void PotentialSwimmer::resume_from(PotentialState resumed)
  {
    state = std::move(resumed);
  }

  void PotentialSwimmer::print_summary(std::ostream &out) const
  {
    const double n    = surface.n_nodes();
    double       bend = 0.;
    const double end  = gait->is_periodic() ? 2. * numbers::PI : parameters.time.end_time;
    for (unsigned int k = 0; k < 64; ++k)
      bend = std::max(bend, deformation->compute_bend(gait->evaluate(end * k / 64).c));
    const double volume = deformation->compute_body_mass(gait->evaluate(0.).c)(3, 3);
    out << "Swimmer in an ideal fluid\n"
        << "  surface   " << surface.n_cells() << " curved quadrilaterals, " << n
        << " panels (unknowns of the potential), matrix of " << n * n * 8 / 1048576. << " MiB\n"
        << "  body      length " << deformation->get_length() << " m, volume " << volume
        << " m^3, mass " << volume * parameters.get_densities().body << " kg, "
        << deformation->n_modes() << " modes of deformation\n"
        << "  bend      width over the room that the bend leaves up to " << bend << " (limit 1)\n"
        << "  method    "
        << (uses_table()
                ? "table of " + std::to_string(parameters.integration.n_phases) + " phases" +
                      (has_glide_symmetry(*gait) && deformation->is_symmetric()
                           ? ", half of them mirrored"
                           : "")
                : std::string("brute force, a new surface at each time"))
        << "\n"
        << get_ideal_fluid_statement();
    if (parameters.integration.method == "table" && !gait->is_periodic())
      out << "Note: the gait has no period, so that there can't be a table; a new surface is\n"
             "computed at each time.\n";
    if (get_torques() == Torques::any)
      out << "Note: torques and powers take several times as long as all the rest, as the body\n"
             "does not start from rest or Resistance is active; Integration/Torques = false saves\n"
             "them.\n";
    if (deformation->n_modes() > 0 && is_reciprocal(*gait))
      out << "Warning: the stroke is reciprocal (its second half is the first one played\n"
             "backwards), and from rest such a stroke can't swim: each shape is passed in both\n"
             "directions, which cancels the motion exactly (Purcell's argument). Give "
             "Gait/Wave\nnumber a value that is not zero.\n";
  }

  std::unique_ptr<StrokeModel> PotentialSwimmer::create_model(const double increment, Log &log)
  {
    if (!uses_table())
      return create_brute_force(*swimming_shape, increment);
    Timer timer(communicator);
    auto  table     = std::make_unique<PhaseTable>(*swimming_shape, parameters.integration.n_phases,
                                              communicator);
    const auto cost = swimming_shape->boundary_elements.get_cost();
    timer.stop();
    log << "Table of phases: " << table->get_n_computed() << " shapes, " << timer.cpu_time()
        << " s of CPU, " << timer.wall_time() << " s; on rank 0 assembly " << cost.assembly
        << " s, solution " << cost.solution << " s, gradient of the energy " << cost.gradient
        << " s of CPU." << std::endl;
    return table;
  }

  MotionProblem PotentialSwimmer::make_problem(StrokeModel &model, const double rate) const
  {
    MotionProblem problem;
    problem.model      = &model;
    problem.rate       = rate;
    problem.length     = deformation->get_length();
    problem.tolerance  = parameters.integration.tolerance;
    problem.integrator = uses_table() ? Integrator::adaptive : Integrator::given_steps;
    problem.force      = create_resistance(parameters.resistance, *swimming_shape);
    return problem;
  }

  std::string PotentialSwimmer::get_suffix(const double frequency) const
  {
    return gait->get_frequencies().size() > 1 ? "_" + print_frequency(frequency) : "";
  }

  SwimSummary PotentialSwimmer::make_summary(const double frequency, const SwimState &swim) const
  {
    SwimSummary summary;
    summary.frequency   = is_periodic() ? frequency : 0.;
    summary.duration    = swim.last.time;
    summary.length      = deformation->get_length();
    summary.has_torques = has_torques();
    summary.mass        = deformation->compute_body_mass(gait->evaluate(0.).c)(3, 3) *
                   parameters.get_densities().body;
    summary.distance = swim.get_distance();
    summary.energy   = swim.energy;
    swim.strokes.fill(summary);
    return summary;
  }

  void PotentialSwimmer::write_summaries(StrokeModel &model, const OutputFolder &folder, Log &log)
  {
    std::vector<SwimSummary> summaries;
    for (std::size_t k = 0; k < state.swims.size(); ++k)
      summaries.push_back(make_summary(gait->get_frequencies()[k], state.swims[k]));
    if (uses_table() && is_from_rest()) // each stroke is the same
    {
      const EnergyAverages stroke = average_stroke(model, n_phases_of_averages, has_torques());
      for (SwimSummary &summary : summaries)
        summary.energy = stroke.at_rate(2. * numbers::PI * summary.frequency);
    }
    run_on_root(communicator, [&]() {
      std::ostringstream text, table, json;
      print_summaries(text, summaries);
      print_csv(table, summaries);
      print_json(json, summaries);
      write_text(folder.path("summary.txt"), text.str());
      write_text(folder.path("summary.csv"), table.str());
      write_text(folder.path("summary.json"), json.str());
      log << "\n" << text.str();
    });
  }

  void PotentialSwimmer::write_checkpoint()
  {
    if (!checkpoints.has_written(state.step_number))
      checkpoints.write(pack(state), state.step_number, state.time);
  }

  /** Tables of swims that have begun are cut off where these go on. */
  void PotentialSwimmer::remove_later_results(const OutputFolder &folder, FieldOutput &fields) const
  {
    run_on_root(communicator, [&]() {
      for (const char *const ending : {"txt", "csv", "json"})
        std::filesystem::remove(folder.path(std::string("summary.") + ending));
    });
    const std::vector<double> frequencies = gait->get_frequencies();
    for (std::size_t k = 0; k < frequencies.size(); ++k)
      PotentialOutput::remove_after(k < state.swims.size() ? state.swims[k].last.time : -1., folder,
                                    fields, get_suffix(frequencies[k]), communicator);
  }

  bool PotentialSwimmer::swim(StrokeModel &model, const double frequency, SwimState &swim_state,
                              const OutputFolder &folder, FieldOutput &fields, Log &log,
                              const std::function<bool()> &stop_requested)
  {
    const double        rate = gait->is_periodic() ? 2. * numbers::PI * frequency : 1.;
    const Instants      instants(parameters.time.get_times(), is_periodic() ? 1. / frequency : 0.);
    const MotionProblem problem = make_problem(model, rate);
    PotentialOutput     output(parameters, *swimming_shape, model, folder, fields,
                               get_suffix(frequency), swim_state.output,
                           swim_state.has_begun() ? swim_state.last.time : -1., communicator);
    PotentialSwim       swim(problem, instants, has_torques(), output, swim_state);
    if (!swim_state.has_begun())
      swim.start(parameters.body.get_impulse());

    Progress   progress(is_terminal() ? std::cout : log.get_stream(), swim_state.last.time,
                      instants.times.back(), is_terminal());
    const bool shows_progress =
        !uses_table() && Utilities::MPI::this_mpi_process(communicator) == 0;
    while (!swim.is_at_end() && !stop_requested() && !checkpoints.is_out_of_time())
    {
      BodyState         body;
      const std::string error = catch_error([&]() { body = swim.integrate(); });
      if (!error.empty())
      {
        write_checkpoint();
        AssertThrow(false, ExcMessage(error + " The last state, t = " + std::to_string(state.time) +
                                      " s, is kept: caudal --resume " + folder.path() + "."));
      }
      swim.take(body);
      state.time = swim_state.last.time;
      ++state.step_number;
      if (shows_progress)
        progress.update(state.time, state.step_number);
      if (checkpoints.is_due(state.step_number))
        write_checkpoint();
    }
    if (shows_progress)
      progress.finish();
    return swim.is_at_end();
  }

  Outcome PotentialSwimmer::run(const OutputFolder &folder, Log &log,
                                const std::function<bool()> &stop_requested)
  {
    Timer timer;
    print_summary(log.get_stream());
    const double increment   = gait->is_periodic()
                                   ? 1e-3
                                   : 0.1 * std::min(parameters.time.step, parameters.time.first_step);
    const auto   model       = create_model(increment, log);
    const auto   frequencies = gait->get_frequencies();
    const bool   is_resumed  = !state.swims.empty();
    FieldOutput  fields(folder.path(), parameters.output.get_format(), communicator,
                       is_resumed ? std::numeric_limits<double>::infinity() : -1.);
    if (is_resumed)
      remove_later_results(folder, fields);
    checkpoints.start(folder.path());

    bool is_at_end = true;
    for (std::size_t k = 0; k < frequencies.size() && is_at_end; ++k)
    {
      if (k == state.swims.size())
        state.swims.emplace_back();
      is_at_end = swim(*model, frequencies[k], state.swims[k], folder, fields, log, stop_requested);
    }
    write_checkpoint();
    if (is_at_end)
      write_summaries(*model, folder, log);
    else
      log << describe_stop(stop_requested(), state.time, state.step_number, folder.path())
          << std::endl;
    log << "CPU of rank 0: " << timer.cpu_time() << " s." << std::endl;
    return is_at_end ? Outcome::finished : Outcome::stopped;
  }
} // namespace caudal
