#include <caudal/base/collective.h>
#include <caudal/fluid/external_power.h>
#include <caudal/viscous/run_output.h>

#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/numerics/data_out.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  RunOutput<dim>::RunOutput(const RunParameters<dim> &parameters,
                            const Observation<dim> &observation, const OutputFolder &folder,
                            Log &log, const std::optional<KeptResults> &kept)
      : parameters(parameters)
      , log(log)
      , statistics(Utilities::MPI::this_mpi_process(observation.space.get_communicator()) == 0
                       ? folder.path("statistics.txt")
                       : "",
                   kept ? kept->until : -1)
      , field_output(folder.path(), parameters.output.get_format(),
                     observation.space.get_communicator(), kept ? kept->fields : -1)
      , forces(observation)
  {
    const bool is_root =
        Utilities::MPI::this_mpi_process(observation.space.get_communicator()) == 0;
    for (const auto &[body, state, report] : observation.bodies)
    {
      initial_centers.push_back(
          body.get_solid().compute_mean(body.get_solid().get_initial_positions()));
      const std::string file =
          observation.bodies.size() == 1 ? "swim.txt" : "swim_" + body.get_name() + ".txt";
      swim_reports.push_back(
          body.swims() ? std::make_unique<SwimReport>(get_constants(body), log.get_stream(),
                                                      is_root ? folder.path(file) : "")
                       : nullptr);
    }
    body_impulses.resize(observation.bodies.size());
    update_ledger(observation);
    initial_ledger = ledger;
  }

  template <int dim>
  SwimmerConstants RunOutput<dim>::get_constants(const Body<dim> &body) const
  {
    const SolidBody<dim> &solid = body.get_solid();
    SwimmerConstants      swimmer;
    swimmer.name   = body.get_name();
    swimmer.length = body.get_length();
    swimmer.mass =
        (parameters.fluid.density + solid.get_excess_density()) * solid.get_reference_volume();
    swimmer.viscosity     = parameters.fluid.kinematic_viscosity;
    swimmer.fluid_density = parameters.fluid.density;
    swimmer.is_per_span   = dim == 2;
    // The control volume gives the force on all bodies together.
    swimmer.has_control_volume =
        !parameters.fluid.control_volume.empty() && parameters.bodies.size() == 1;
    swimmer.wetted_area = 0;
    for (const auto &face : solid.get_triangulation().active_face_iterators())
      if (face->at_boundary())
        swimmer.wetted_area += face->measure();
    return swimmer;
  }

  template <int dim>
  void RunOutput<dim>::report_step(const Observation<dim> &observation)
  {
    update_ledger(observation);
    update_forces(observation);
    // Rank 0 alone writes to the tables; if it can't, all ranks must know.
    run_on_all(observation.space.get_communicator(), [&]() { report_swimming(observation); });
    if (observation.step_number % parameters.output.statistics_interval == 0 || observation.is_last)
      write_statistics(observation);
    if (fields_are_due(observation.time) || observation.is_last)
      write_fields(observation);
  }

  template <int dim>
  void RunOutput<dim>::update_forces(const Observation<dim> &observation)
  {
    const bool was_valid = forces.is_control_volume_valid();
    forces.update(observation);
    if (was_valid && !forces.is_control_volume_valid())
      log << "Warning: a body has left Fluid/Control volume at t = " << observation.time
          << " s; the force by control volume is none on the bodies from here on." << std::endl;
  }

  template <int dim>
  void RunOutput<dim>::report_new_grid(const Observation<dim> &observation)
  {
    forces.adapt(observation);
  }

  template <int dim>
  bool RunOutput<dim>::fields_are_due(const double time) const
  {
    // Whether a multiple of the interval was passed since the last output, which may
    // have been an additional one.
    const double interval = parameters.output.field_interval;
    const auto   count    = [&](const double t) { return std::floor(t / interval * (1 + 1e-9)); };
    return interval == 0 || count(time) > count(last_field_time);
  }

  template <int dim>
  void RunOutput<dim>::report_swimming(const Observation<dim> &observation)
  {
    for (unsigned int b = 0; b < observation.bodies.size(); ++b)
      if (swim_reports[b])
      {
        const auto &[body, state, report] = observation.bodies[b];
        const SolidBody<dim> &solid       = body.get_solid();
        const Tensor<1, dim>  forward     = -solid.get_initial_axis(0);
        const double          volume      = solid.get_reference_volume();
        const double          speed       = body.get_mean_velocity(state) * forward;
        body_impulses[b] += observation.step * (forces.get_resultant(b) * forward);

        SwimSample sample;
        sample.time          = observation.time;
        sample.tail_position = body.get_lateral_position(state);
        sample.forward_position =
            (solid.compute_mean(state.positions) - initial_centers[b]) * forward;
        sample.muscle_work = state.muscle_work;
        sample.forward_momentum =
            (parameters.fluid.density + solid.get_excess_density()) * volume * speed;
        // The body force includes the inertia of the excess mass.
        sample.body_impulse  = body_impulses[b] + solid.get_excess_density() * volume * speed;
        sample.fluid_impulse = forces.get_control_volume_impulse() * forward;
        sample.ledger        = ledger;
        swim_reports[b]->add(sample);
      }
  }

  template <int dim>
  void RunOutput<dim>::update_ledger(const Observation<dim> &observation)
  {
    const FlowSummary<dim> &flow = observation.report.flow;
    const double            step = observation.step, damping = observation.report.damping;
    ledger.kinetic_energy = flow.kinetic_energy;
    const double numerical =
        flow.grad_div_dissipation + compute_stabilisation_dissipation(observation.space,
                                                                      observation.fluid.velocity,
                                                                      observation.report.rate);
    const double dissipation = flow.viscous_dissipation + numerical;
    const double external =
        compute_external_power(observation.space, observation.fluid, observation.time);
    ledger.dissipation += 0.5 * step * (last_dissipation + dissipation) + damping;
    ledger.numerical_dissipation += 0.5 * step * (last_numerical_dissipation + numerical) + damping;
    ledger.external_work += 0.5 * step * (last_external_power + external);
    last_dissipation           = dissipation;
    last_numerical_dissipation = numerical;
    last_external_power        = external;
    ledger.elastic_energy = ledger.muscle_work = ledger.feedback_work = 0;
    for (const auto &[body, state, report] : observation.bodies)
    {
      const SolidBody<dim> &solid = body.get_solid();
      ledger.elastic_energy += report.deformation.elastic_energy;
      ledger.muscle_work += state.muscle_work;
      ledger.feedback_work += state.feedback_work;
      Vector<double> weighted(solid.n_dofs());
      solid.get_mass_matrix().vmult(weighted, state.velocity);
      ledger.kinetic_energy += 0.5 * solid.get_excess_density() * (weighted * state.velocity);
    }
  }

  template <int dim>
  void RunOutput<dim>::write_statistics(const Observation<dim> &observation)
  {
    const StepReport<dim>  &result = observation.report;
    const FlowSummary<dim> &flow   = result.flow;
    statistics.set("time", "s", observation.time);
    statistics.set("time step", "s", observation.step);
    statistics.set("iterations", "", result.iterations);
    statistics.set("cells", "", observation.space.get_triangulation().n_global_active_cells());
    statistics.set("CFL", "", result.indicators.convective_cfl);
    statistics.set("body CFL", "", result.indicators.body_cfl);
    statistics.set("max velocity", "m/s", flow.largest_velocity);
    statistics.set("divergence", "m/s", flow.divergence_norm);
    double identity = 0;
    for (unsigned int b = 0; b < observation.bodies.size(); ++b)
    {
      set_body_statistics(observation, b);
      identity = std::max(identity, result.bodies[b].power_identity);
    }
    forces.set_control_volume_statistics(statistics);
    statistics.set("kinetic energy", get_extensive_unit<dim>("J"), ledger.kinetic_energy);
    statistics.set("dissipation", get_extensive_unit<dim>("J"), ledger.dissipation);
    statistics.set("numerical dissipation", get_extensive_unit<dim>("J"),
                   ledger.numerical_dissipation);
    statistics.set("external work", get_extensive_unit<dim>("J"), ledger.external_work);
    statistics.set("energy residual", get_extensive_unit<dim>("J"),
                   ledger.get_residual(initial_ledger));
    statistics.set("power identity", "", identity);
    set_probe_statistics(observation);
    if (!parameters.fluid.exact_solution.empty())
    {
      const auto [velocity_error, pressure_error] =
          compute_errors(observation.space, observation.fluid, observation.time);
      statistics.set("velocity error", dim == 2 ? "m^2/s" : "m^2.5/s", velocity_error);
      statistics.set("pressure error", dim == 2 ? "Pa m" : "Pa m^1.5", pressure_error);
    }
    run_on_all(observation.space.get_communicator(), [&]() { statistics.write_row(); });
  }

  template <int dim>
  void RunOutput<dim>::set_probe_statistics(const Observation<dim> &observation)
  {
    const char *const velocities = "uvw";
    for (unsigned int k = 0; k < parameters.fluid.probes.size(); ++k)
    {
      const std::string probe = " at probe " + std::to_string(k + 1);
      const auto        values =
          evaluate_at(observation.space, observation.fluid, parameters.fluid.probes[k]);
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(velocities[d] + probe, "m/s", values.velocity[d]);
      statistics.set("p" + probe, "Pa", values.pressure);
    }
  }

  template <int dim>
  void RunOutput<dim>::set_body_statistics(const Observation<dim> &observation,
                                           const unsigned int      b)
  {
    const auto &[body, state, report] = observation.bodies[b];
    const std::string     prefix      = body.get_name() + ": ";
    const SolidBody<dim> &solid       = body.get_solid();
    const char *const axes = "xyz", *const velocities = "uvw";
    for (unsigned int k = 0; k < solid.get_parameters().monitored_points.size(); ++k)
    {
      const std::string    point    = " of point " + std::to_string(k + 1);
      const Tensor<1, dim> position = solid.evaluate(state.positions, k);
      const Tensor<1, dim> velocity = solid.evaluate(state.velocity, k);
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(prefix + axes[d] + point, "m", position[d]);
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(prefix + velocities[d] + point, "m/s", velocity[d]);
    }
    const Tensor<1, dim> center = solid.compute_mean(state.positions);
    const Tensor<1, dim> mean   = solid.compute_mean(state.velocity);
    for (unsigned int d = 0; d < dim; ++d)
      statistics.set(prefix + axes[d] + " of centre of mass", "m", center[d]);
    for (unsigned int d = 0; d < dim; ++d)
      statistics.set(prefix + velocities[d] + " of centre of mass", "m/s", mean[d]);
    forces.set_body_statistics(observation, b, statistics);
    statistics.set(prefix + "area change", "", report.deformation.volume_change);
    statistics.set(prefix + "min J", "", report.deformation.smallest_jacobian);
    statistics.set(prefix + "max J", "", report.deformation.largest_jacobian);
    statistics.set(prefix + "lateral position", "m", body.get_lateral_position(state));
    statistics.set(prefix + "activation", "", body.get_activation(state));
    statistics.set(prefix + "muscle power", get_extensive_unit<dim>("W"), report.muscle_power);
    statistics.set(prefix + "muscle work", get_extensive_unit<dim>("J"), state.muscle_work);
    statistics.set(prefix + "elastic energy", get_extensive_unit<dim>("J"),
                   report.deformation.elastic_energy);
    statistics.set(prefix + "feedback work", get_extensive_unit<dim>("J"), state.feedback_work);
  }

  template <int dim>
  void RunOutput<dim>::write_fields(const Observation<dim> &observation)
  {
    if (observation.time == last_field_time)
      return;
    write_fluid(observation);
    for (const auto &body : observation.bodies)
      write_body(observation, body);
    last_field_time = observation.time;
    ++n_field_outputs;
  }

  template <int dim>
  void RunOutput<dim>::write_fluid(const Observation<dim> &observation)
  {
    const FluidSpace<dim>            &space = observation.space;
    const VorticityPostprocessor<dim> vorticity;
    DataOut<dim>                      data_out;
    data_out.add_data_vector(space.velocity_dofs, observation.fluid.velocity,
                             std::vector<std::string>(dim, "velocity"),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                 dim, DataComponentInterpretation::component_is_part_of_vector));
    data_out.add_data_vector(space.pressure_dofs, observation.fluid.pressure, "pressure");
    data_out.add_data_vector(space.velocity_dofs, observation.fluid.velocity, vorticity);
    const auto   &triangulation = space.get_triangulation();
    Vector<float> level(triangulation.n_active_cells()), rank(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
    {
      level[cell->active_cell_index()] = cell->level();
      rank[cell->active_cell_index()]  = cell->is_locally_owned() ? cell->subdomain_id() : -1;
    }
    data_out.attach_triangulation(triangulation);
    data_out.add_data_vector(level, "level");
    data_out.add_data_vector(rank, "rank");
    data_out.build_patches(parameters.output.n_subdivisions);
    field_output.write(data_out, "fluid", observation.time, n_field_outputs,
                       space.get_communicator());
  }

  template <int dim>
  void RunOutput<dim>::write_body(const Observation<dim>     &observation,
                                  const BodyObservation<dim> &observed)
  {
    const auto &[body, state, report] = observed;
    const SolidBody<dim> &solid       = body.get_solid();
    const auto vector = std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector);

    // The grid lives in the body's own frame; the picture in the domain.
    Vector<double> displacement(state.positions), move(state.positions);
    displacement -= solid.get_initial_positions();
    for (const auto &node : solid.get_nodes())
      for (unsigned int d = 0; d < dim; ++d)
        move[node[d]] -= solid.get_reference_point(node[0])[d];
    Vector<double> muscle_force = body.compute_force(
        LoadAccount::muscle, body.get_motion(state, observation.time, observation.step));
    solid.apply_inverse_mass(muscle_force);
    const CellDeformation cells = compute_cell_deformation(solid, state.positions);

    DataOut<dim> data_out;
    const auto  &dofs = solid.get_dof_handler();
    data_out.add_data_vector(dofs, displacement, std::vector<std::string>(dim, "displacement"),
                             vector);
    data_out.add_data_vector(dofs, state.velocity, std::vector<std::string>(dim, "velocity"),
                             vector);
    data_out.add_data_vector(dofs, muscle_force, std::vector<std::string>(dim, "muscle_force"),
                             vector);
    data_out.attach_triangulation(solid.get_triangulation());
    data_out.add_data_vector(cells.jacobian, "J");
    for (const auto &[name, values] : cells.cauchy_stress)
      data_out.add_data_vector(values, name);
    data_out.add_data_vector(cells.region, "region");
    const MappingQEulerian<dim> mapping(dofs.get_fe().degree, dofs, move);
    data_out.build_patches(mapping, dofs.get_fe().degree, DataOut<dim>::curved_inner_cells);
    field_output.write(data_out, body.get_name(), observation.time, n_field_outputs, MPI_COMM_SELF);
  }

  template <int dim>
  double RunOutput<dim>::get_last_beat_period() const
  {
    for (const auto &report : swim_reports)
      if (report && !report->get_beats().empty())
        return report->get_beats().back().period;
    return 0.;
  }

  template <int dim>
  void RunOutput<dim>::finish()
  {
    for (const auto &report : swim_reports)
      if (report)
        report->finish();
  }

  template class RunOutput<2>;
  template class RunOutput<3>;
} // namespace caudal
