#include <caudal/app/potential_output.h>
#include <caudal/app/potential_swimmer.h>
#include <caudal/base/collective.h>
#include <caudal/io/progress.h>
#include <caudal/potential/phase_table.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace caudal
{
  using namespace potential;

  namespace
  {
    /** Ends the integration when the user asks for it. */
    struct StopRequest
    {};

    const unsigned int n_phases_of_averages = 720;

    /** "0.64Hz" */
    std::string print_frequency(const double frequency)
    {
      std::ostringstream text;
      text << frequency << "Hz";
      return text.str();
    }

    /** The times of output and the ends of the strokes. */
    struct Instants
    {
      std::vector<double> times;
      std::vector<bool>   is_output, ends_stroke;
    };

    Instants merge_times(const std::vector<double> &output, const double period)
    {
      std::map<double, std::pair<bool, bool>> all;
      for (const double time : output)
        all[time].first = true;
      const double end = output.back(), tolerance = 1e-9 * end;
      for (unsigned int k = 0; period > 0. && k * period < end + tolerance; ++k)
      {
        // Times that differ by rounding are one.
        auto near = all.lower_bound(k * period - tolerance);
        if (near == all.end() || near->first > k * period + tolerance)
          near = all.insert({k * period, {false, false}}).first;
        near->second.second = true;
      }
      Instants instants;
      for (const auto &[time, flags] : all)
      {
        instants.times.push_back(time);
        instants.is_output.push_back(flags.first);
        instants.ends_stroke.push_back(flags.second);
      }
      return instants;
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

  SwimSummary PotentialSwimmer::make_summary(const double frequency) const
  {
    SwimSummary summary;
    summary.frequency   = frequency;
    summary.length      = deformation->get_length();
    summary.has_torques = has_torques();
    summary.mass        = deformation->compute_body_mass(gait->evaluate(0.).c)(3, 3) *
                   parameters.get_densities().body;
    return summary;
  }

  SwimSummary PotentialSwimmer::swim(StrokeModel &model, const double frequency,
                                     const std::string &suffix, const OutputFolder &folder,
                                     FieldOutput &fields, Log &log,
                                     const std::function<bool()> &stop_requested)
  {
    const bool     is_periodic = gait->is_periodic() && deformation->n_modes() > 0;
    const double   rate        = gait->is_periodic() ? 2. * numbers::PI * frequency : 1.;
    const Instants instants =
        merge_times(parameters.time.get_times(), is_periodic ? 1. / frequency : 0.);

    const MotionProblem problem = make_problem(model, rate);
    BodyState           start;
    for (unsigned int d = 0; d < 3; ++d)
    {
      start.impulse[d]     = parameters.body.angular_impulse[d];
      start.impulse[3 + d] = parameters.body.linear_impulse[d];
    }
    SwimSummary summary = make_summary(is_periodic ? frequency : 0.);

    PotentialOutput output(parameters, *swimming_shape, model, folder, fields, suffix,
                           communicator);
    StrokeCounter   strokes;
    MotionSample    previous;
    Tensor<1, 3>    first_centre;
    unsigned int    k = 0;
    Progress   progress(is_terminal() ? std::cout : log.get_stream(), 0., instants.times.back(),
                      is_terminal());
    const bool shows_progress =
        !uses_table() && Utilities::MPI::this_mpi_process(communicator) == 0;
    integrate_motion(problem, start, instants.times, [&](const BodyState &body, const double) {
      const double       time   = instants.times[k];
      const MotionSample sample = compute_sample(problem, body, time, summary.has_torques);
      if (k == 0)
        first_centre = sample.centre;
      else
      {
        summary.energy.add(previous, 0.5 * (time - previous.time));
        summary.energy.add(sample, 0.5 * (time - previous.time));
      }
      if (instants.is_output[k])
        output.write(sample, rate);
      if (instants.ends_stroke[k])
        strokes.add(sample);
      summary.duration = time;
      summary.distance = (sample.centre - first_centre).norm();
      previous         = sample;
      ++k;
      if (shows_progress)
        progress.update(time, k);
      if (stop_requested())
        throw StopRequest();
    });
    if (shows_progress)
      progress.finish();
    strokes.fill(summary);
    return summary;
  }

  Outcome PotentialSwimmer::run(const OutputFolder &folder, Log &log,
                                const std::function<bool()> &stop_requested)
  {
    Timer timer;
    print_summary(log.get_stream());
    const double             increment   = gait->is_periodic()
                                               ? 1e-3
                                               : 0.1 * std::min(parameters.time.step, parameters.time.first_step);
    const auto               model       = create_model(increment, log);
    const auto               frequencies = gait->get_frequencies();
    FieldOutput              fields(folder.path(), parameters.output.get_format(), communicator);
    std::vector<SwimSummary> summaries;
    const bool               repeats = uses_table() && is_from_rest(); // each stroke is the same
    const EnergyAverages     stroke =
        repeats ? average_stroke(*model, n_phases_of_averages, has_torques()) : EnergyAverages();
    try
    {
      for (const double frequency : frequencies)
      {
        const std::string suffix = frequencies.size() > 1 ? "_" + print_frequency(frequency) : "";
        summaries.push_back(swim(*model, frequency, suffix, folder, fields, log, stop_requested));
        if (repeats)
          summaries.back().energy = stroke.at_rate(2. * numbers::PI * frequency);
      }
    }
    catch (const StopRequest &)
    {
      log << "Stopped on request; there is no summary." << std::endl;
      return Outcome::stopped;
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
    log << "CPU of rank 0: " << timer.cpu_time() << " s." << std::endl;
    return Outcome::finished;
  }
} // namespace caudal
