#include <caudal/base/collective.h>
#include <caudal/fluid/external_power.h>
#include <caudal/viscous/run_output.h>

#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/numerics/data_out.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  RunOutput<dim>::RunOutput(const RunParameters<dim> &parameters, const ImmersedSystem<dim> &system,
                            const OutputFolder &folder, Log &log,
                            const std::optional<KeptResults> &kept)
      : parameters(parameters)
      , system(system)
      , log(log)
      , statistics(Utilities::MPI::this_mpi_process(system.space.get_communicator()) == 0
                       ? folder.path("statistics.txt")
                       : "",
                   kept ? kept->until : -1)
      , field_output(folder.path(), parameters.output.get_format(), system.space.get_communicator(),
                     kept ? kept->fields : -1)
      , forces(system)
      , flow(summarise_flow(system.space, system.fluid.velocity))
  {
    const bool is_root = Utilities::MPI::this_mpi_process(system.space.get_communicator()) == 0;
    for (const auto &body : system.bodies)
    {
      const SolidBody<dim> &solid = body->solid;
      initial_centers.push_back(solid.compute_mean(solid.initial_positions));
      const std::string file =
          system.bodies.size() == 1 ? "swim.txt" : "swim_" + body->get_name() + ".txt";
      swim_reports.push_back(
          body->swims() ? std::make_unique<SwimReport>(get_constants(*body), log.get_stream(),
                                                       is_root ? folder.path(file) : "")
                        : nullptr);
    }
    body_impulses.resize(system.bodies.size());
    update_ledger(0, 0, 0);
    initial_ledger = ledger;
  }

  template <int dim>
  SwimmerConstants RunOutput<dim>::get_constants(const SwimmingBody<dim> &body) const
  {
    SwimmerConstants swimmer;
    swimmer.name   = body.get_name();
    swimmer.length = body.get_length();
    swimmer.mass   = (parameters.fluid.density + body.solid.get_excess_density()) *
                   body.solid.get_reference_volume();
    swimmer.viscosity     = parameters.fluid.kinematic_viscosity;
    swimmer.fluid_density = parameters.fluid.density;
    swimmer.is_per_span   = dim == 2;
    // The control volume gives the force on all bodies together.
    swimmer.has_control_volume =
        !parameters.fluid.control_volume.empty() && system.bodies.size() == 1;
    swimmer.wetted_area = 0;
    for (const auto &face : body.solid.get_triangulation().active_face_iterators())
      if (face->at_boundary())
        swimmer.wetted_area += face->measure();
    return swimmer;
  }

  template <int dim>
  void RunOutput<dim>::report_step(const TimeStepper &stepper, const StepResult<dim> &result,
                                   const unsigned int n_cells)
  {
    TimerOutput::Scope timer_section(system.timer, "output");
    flow = result.flow;
    update_ledger(stepper.get_time(), stepper.get_previous_step(), result.damping);
    update_forces(stepper.get_time());
    // Rank 0 alone writes to the tables; if it can't, all ranks must know.
    run_on_all(system.space.get_communicator(),
               [&]() { report_swimming(stepper.get_time(), stepper.get_previous_step()); });
    if (stepper.get_step_number() % parameters.output.statistics_interval == 0 ||
        stepper.is_at_end())
      write_statistics(stepper, result, n_cells);
    if (fields_are_due(stepper.get_time()) || stepper.is_at_end())
      write_fields(stepper.get_time());
  }

  template <int dim>
  void RunOutput<dim>::update_forces(const double time)
  {
    const bool was_valid = forces.is_control_volume_valid();
    forces.update(time);
    if (was_valid && !forces.is_control_volume_valid())
      log << "Warning: a body has left Fluid/Control volume at t = " << time
          << " s; the force by control volume is none on the bodies from here on." << std::endl;
  }

  template <int dim>
  void RunOutput<dim>::report_new_grid(const double time)
  {
    TimerOutput::Scope timer_section(system.timer, "output");
    forces.adapt(time);
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
  void RunOutput<dim>::report_swimming(const double time, const double step)
  {
    for (unsigned int b = 0; b < system.bodies.size(); ++b)
      if (swim_reports[b])
      {
        const SwimmingBody<dim> &body    = *system.bodies[b];
        const SolidBody<dim>    &solid   = body.solid;
        const Tensor<1, dim>     forward = -solid.get_initial_axis(0);
        const double             volume  = solid.get_reference_volume();
        const double             speed   = body.get_mean_velocity() * forward;
        body_impulses[b] += step * (forces.get_resultant(b) * forward);

        SwimSample sample;
        sample.time          = time;
        sample.tail_position = body.get_lateral_position();
        sample.forward_position =
            (solid.compute_mean(solid.positions) - initial_centers[b]) * forward;
        sample.muscle_work = body.muscle_work;
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
  void RunOutput<dim>::update_ledger(const double time, const double step, const double damping)
  {
    ledger.kinetic_energy = flow.kinetic_energy;
    const double rate     = step > 0 ? (parameters.time.is_explicit() ? 1 : 1.5) / step : 0;
    const double numerical =
        flow.grad_div_dissipation +
        compute_stabilisation_dissipation(system.space, system.fluid.velocity, rate);
    const double dissipation = flow.viscous_dissipation + numerical;
    const double external    = compute_external_power(system.space, system.fluid, time);
    ledger.dissipation += 0.5 * step * (last_dissipation + dissipation) + damping;
    ledger.numerical_dissipation += 0.5 * step * (last_numerical_dissipation + numerical) + damping;
    ledger.external_work += 0.5 * step * (last_external_power + external);
    last_dissipation           = dissipation;
    last_numerical_dissipation = numerical;
    last_external_power        = external;
    ledger.elastic_energy = ledger.muscle_work = ledger.feedback_work = 0;
    for (const auto &body : system.bodies)
    {
      ledger.elastic_energy += body->deformation.elastic_energy;
      ledger.muscle_work += body->muscle_work;
      ledger.feedback_work += body->feedback_work;
      Vector<double> weighted(body->solid.n_dofs());
      body->solid.get_mass_matrix().vmult(weighted, body->solid.velocity);
      ledger.kinetic_energy +=
          0.5 * body->solid.get_excess_density() * (weighted * body->solid.velocity);
      // The same power seen by the body and by the fluid.
      FieldVector force = system.space.make_velocity_vector();
      body->interaction.spread(body->solid.force_density, force);
      double size = 0;
      for (unsigned int i = 0; i < weighted.size(); ++i)
        size += std::abs(weighted[i] * body->solid.force_density[i]);
      body->power_identity =
          std::abs(weighted * body->solid.force_density - force * system.fluid.velocity) /
          std::max(size, 1e-300);
    }
  }

  template <int dim>
  void RunOutput<dim>::write_statistics(const TimeStepper &stepper, const StepResult<dim> &result,
                                        const unsigned int n_cells)
  {
    statistics.set("time", "s", stepper.get_time());
    statistics.set("time step", "s", stepper.get_previous_step());
    statistics.set("iterations", "", result.iterations);
    statistics.set("cells", "", n_cells);
    statistics.set("CFL", "", result.indicators.convective_cfl);
    statistics.set("body CFL", "", result.indicators.body_cfl);
    statistics.set("max velocity", "m/s", flow.largest_velocity);
    statistics.set("divergence", "m/s", flow.divergence_norm);
    double identity = 0;
    for (unsigned int b = 0; b < system.bodies.size(); ++b)
    {
      set_body_statistics(b);
      identity = std::max(identity, system.bodies[b]->power_identity);
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
    set_probe_statistics();
    if (!parameters.fluid.exact_solution.empty())
    {
      const auto [velocity_error, pressure_error] =
          compute_errors(system.space, system.fluid, stepper.get_time());
      statistics.set("velocity error", dim == 2 ? "m^2/s" : "m^2.5/s", velocity_error);
      statistics.set("pressure error", dim == 2 ? "Pa m" : "Pa m^1.5", pressure_error);
    }
    run_on_all(system.space.get_communicator(), [&]() { statistics.write_row(); });
  }

  template <int dim>
  void RunOutput<dim>::set_probe_statistics()
  {
    const char *const velocities = "uvw";
    for (unsigned int k = 0; k < parameters.fluid.probes.size(); ++k)
    {
      const std::string probe = " at probe " + std::to_string(k + 1);
      const auto values       = evaluate_at(system.space, system.fluid, parameters.fluid.probes[k]);
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(velocities[d] + probe, "m/s", values.velocity[d]);
      statistics.set("p" + probe, "Pa", values.pressure);
    }
  }

  template <int dim>
  void RunOutput<dim>::set_body_statistics(const unsigned int b)
  {
    const SwimmingBody<dim> &body   = *system.bodies[b];
    const std::string        prefix = body.get_name() + ": ";
    const SolidBody<dim>    &solid  = body.solid;
    const char *const axes = "xyz", *const velocities = "uvw";
    for (unsigned int k = 0; k < solid.get_parameters().monitored_points.size(); ++k)
    {
      const std::string    point    = " of point " + std::to_string(k + 1);
      const Tensor<1, dim> position = solid.evaluate(solid.positions, k);
      const Tensor<1, dim> velocity = solid.evaluate(solid.velocity, k);
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(prefix + axes[d] + point, "m", position[d]);
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(prefix + velocities[d] + point, "m/s", velocity[d]);
    }
    const Tensor<1, dim> center = solid.compute_mean(solid.positions);
    const Tensor<1, dim> mean   = solid.compute_mean(solid.velocity);
    for (unsigned int d = 0; d < dim; ++d)
      statistics.set(prefix + axes[d] + " of centre of mass", "m", center[d]);
    for (unsigned int d = 0; d < dim; ++d)
      statistics.set(prefix + velocities[d] + " of centre of mass", "m/s", mean[d]);
    forces.set_body_statistics(b, statistics);
    statistics.set(prefix + "area change", "", body.deformation.volume_change);
    statistics.set(prefix + "min J", "", body.deformation.smallest_jacobian);
    statistics.set(prefix + "max J", "", body.deformation.largest_jacobian);
    statistics.set(prefix + "lateral position", "m", body.get_lateral_position());
    statistics.set(prefix + "activation", "", body.get_activation());
    statistics.set(prefix + "muscle power", get_extensive_unit<dim>("W"), body.muscle_power);
    statistics.set(prefix + "muscle work", get_extensive_unit<dim>("J"), body.muscle_work);
    statistics.set(prefix + "elastic energy", get_extensive_unit<dim>("J"),
                   body.deformation.elastic_energy);
    statistics.set(prefix + "feedback work", get_extensive_unit<dim>("J"), body.feedback_work);
  }

  template <int dim>
  void RunOutput<dim>::write_fields(const double time)
  {
    if (time == last_field_time)
      return;
    write_fluid(time);
    for (const auto &body : system.bodies)
      write_body(*body, time);
    last_field_time = time;
    ++n_field_outputs;
  }

  template <int dim>
  void RunOutput<dim>::write_fluid(const double time)
  {
    const FluidSpace<dim>            &space = system.space;
    const VorticityPostprocessor<dim> vorticity;
    DataOut<dim>                      data_out;
    data_out.add_data_vector(space.velocity_dofs, system.fluid.velocity,
                             std::vector<std::string>(dim, "velocity"),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                 dim, DataComponentInterpretation::component_is_part_of_vector));
    data_out.add_data_vector(space.pressure_dofs, system.fluid.pressure, "pressure");
    data_out.add_data_vector(space.velocity_dofs, system.fluid.velocity, vorticity);
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
    field_output.write(data_out, "fluid", time, n_field_outputs, space.get_communicator());
  }

  template <int dim>
  void RunOutput<dim>::write_body(const SwimmingBody<dim> &body, const double time)
  {
    const SolidBody<dim> &solid = body.solid;
    const auto vector = std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim, DataComponentInterpretation::component_is_part_of_vector);

    // The grid lives in the body's own frame; the picture in the domain.
    Vector<double> displacement(solid.positions), move(solid.positions);
    displacement -= solid.initial_positions;
    for (const auto &node : solid.get_nodes())
      for (unsigned int d = 0; d < dim; ++d)
        move[node[d]] -= solid.get_reference_point(node[0])[d];
    Vector<double> muscle_force(body.elastic_system.active_force);
    solid.apply_inverse_mass(muscle_force);
    const CellDeformation cells = compute_cell_deformation(solid, solid.positions);

    DataOut<dim> data_out;
    const auto  &dofs = solid.get_dof_handler();
    data_out.add_data_vector(dofs, displacement, std::vector<std::string>(dim, "displacement"),
                             vector);
    data_out.add_data_vector(dofs, solid.velocity, std::vector<std::string>(dim, "velocity"),
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
    field_output.write(data_out, body.get_name(), time, n_field_outputs, MPI_COMM_SELF);
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
