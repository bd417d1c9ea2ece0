#include <caudal/base/collective.h>
#include <caudal/ideal/potential_output.h>
#include <caudal/ideal/surface_fields.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe_field.h>
#include <deal.II/numerics/data_out.h>

#include <filesystem>

namespace caudal
{
  using namespace ideal;

  namespace
  {
    const std::string coordinates[] = {"x", "y", "z"};

    /** Of the swim in the list of fields. */
    std::string get_block_name(const std::string &suffix)
    {
      return "fish" + suffix;
    }

    std::string get_table_name(const std::string &suffix)
    {
      return "statistics" + suffix + ".txt";
    }

    /**
     * The potential of the whole flow at the nodes at a time near that of the sample, to which
     * the impulses go on at the rate @p impulse_rate.
     */
    Vector<double> compute_potential(StrokeModel &model, const MotionSample &sample,
                                     const Screw &impulse_rate, const double time,
                                     const double rate, const Gait &gait)
    {
      const Screw               impulse = sample.body.impulse + (time - sample.time) * impulse_rate;
      const double              argument = rate * time;
      const FullMatrix<double>  modes    = model.compute_potentials(argument);
      const std::vector<double> rates    = gait.evaluate(argument).rates;
      const Screw    velocity = model.compute_motion(argument).compute_velocity(impulse, rate);
      Vector<double> motions(modes.n()), potential(modes.m());
      for (unsigned int k = 0; k < 6; ++k)
        motions(k) = velocity[k];
      for (unsigned int i = 0; i < rates.size(); ++i)
        motions(6 + i) = rate * rates[i];
      modes.vmult(potential, motions);
      return potential;
    }
  } // namespace

  PotentialOutput::PotentialOutput(const PotentialParameters &parameters, SwimmingShape &shape,
                                   StrokeModel &model, const OutputFolder &folder,
                                   FieldOutput &fields, const std::string &suffix,
                                   OutputCounters &counters, const double kept_time,
                                   const MPI_Comm communicator)
      : parameters(parameters)
      , shape(shape)
      , model(model)
      , name(get_block_name(suffix))
      , communicator(communicator)
      , statistics(Utilities::MPI::this_mpi_process(communicator) == 0
                       ? folder.path(get_table_name(suffix))
                       : "",
                   kept_time)
      , fields(fields)
      , counters(counters)
      , place_handler(shape.surface.get_dof_handler().get_triangulation())
  {
    place_handler.distribute_dofs(FESystem<2, 3>(shape.surface.get_fe(), 3));
  }

  void PotentialOutput::remove_after(const double time, const OutputFolder &folder,
                                     FieldOutput &fields, const std::string &suffix,
                                     const MPI_Comm communicator)
  {
    fields.remove_after(get_block_name(suffix), time);
    if (time < 0.)
      run_on_root(communicator,
                  [&]() { std::filesystem::remove(folder.path(get_table_name(suffix))); });
  }

  void PotentialOutput::write(const MotionSample &sample, const MotionProblem &problem,
                              const double distance)
  {
    if (counters.n_rows % parameters.output.statistics_interval == 0)
      write_row(sample, problem.rate, distance);
    ++counters.n_rows;
    const double end      = parameters.time.end_time;
    const auto   has_come = [&](const double time) { return sample.time >= time - 1e-9 * end; };
    const bool   are_due  = has_come(counters.next_fields);
    if (are_due || has_come(end))
      write_fields(sample, problem);
    if (are_due)
      counters.next_fields += parameters.output.field_interval;
  }

  void PotentialOutput::write_row(const MotionSample &sample, const double rate,
                                  const double distance)
  {
    const auto set        = [this](const std::string &quantity, const std::string &unit,
                            const double value) { statistics.set(quantity, unit, value); };
    const auto set_vector = [&](const std::string &what, const std::string &unit,
                                const Tensor<1, 3> &vector) {
      for (unsigned int d = 0; d < 3; ++d)
        set(coordinates[d] + " of " + what, unit, vector[d]);
    };
    const auto get_part = [](const Screw &screw, const unsigned int first) {
      return Point<3>(screw[first], screw[first + 1], screw[first + 2]);
    };

    set("time", "s", sample.time);
    set_vector("nose", "m", sample.body.position);
    for (unsigned int i = 0; i < 4; ++i)
      set("quaternion " + std::to_string(i), "1", sample.body.quaternion[i]);
    set_vector("centre of mass", "m", sample.centre);
    set("distance", "m", distance);
    set_vector("velocity of centre of mass", "m/s", sample.centre_velocity);
    set("speed", "m/s", sample.centre_velocity.norm());
    set_vector("angular velocity in body frame", "rad/s", get_part(sample.velocity, 0));
    set_vector("velocity of nose in body frame", "m/s", get_part(sample.velocity, 3));
    set_vector("angular impulse in body frame", "kg m^2/s", get_part(sample.body.impulse, 0));
    set_vector("linear impulse in body frame", "kg m/s", get_part(sample.body.impulse, 3));
    set("kinetic energy", "J", sample.energy);
    const GaitState gait = shape.gait.evaluate(rate * sample.time);
    for (std::size_t i = 0; i < gait.c.size(); ++i)
      set("coordinate of mode " + std::to_string(i + 1), "rad", gait.c[i]);
    for (std::size_t i = 0; i < sample.torques.size(); ++i)
      set("torque of mode " + std::to_string(i + 1), "N m", sample.torques[i]);
    for (std::size_t i = 0; i < sample.powers.size(); ++i)
      set("power of mode " + std::to_string(i + 1), "W", sample.powers[i]);
    if (!sample.powers.empty())
      set("power", "W", sample.get_power());
    statistics.write_row();
  }

  void PotentialOutput::write_fields(const MotionSample &sample, const MotionProblem &problem)
  {
    const double        rate      = problem.rate;
    const double        argument  = rate * sample.time;
    const GaitState     gait      = shape.gait.evaluate(argument);
    const SurfaceMotion motion    = shape.deformation.place(gait.c);
    const double        increment = 1e-4 / rate;

    // Places and velocities in the inertial frame
    const Screw              &q     = sample.velocity;
    const Tensor<1, 3>        omega = Point<3>(q[0], q[1], q[2]), v = Point<3>(q[3], q[4], q[5]);
    std::vector<Point<3>>     nodes;
    std::vector<Tensor<1, 3>> velocities;
    for (unsigned int node = 0; node < shape.surface.n_nodes(); ++node)
    {
      Tensor<1, 3> u = v + cross_product_3d(omega, Tensor<1, 3>(motion.positions[node]));
      for (std::size_t i = 0; i < gait.rates.size(); ++i)
        u += rate * gait.rates[i] * motion.modes[i][node];
      nodes.emplace_back(sample.body.position + sample.body.rotate(motion.positions[node]));
      velocities.push_back(sample.body.rotate(u));
    }

    const Screw external =
        problem.force ? problem.force({argument, rate, sample.velocity}).screw : Screw();
    const Screw impulse_rate = compute_impulse_rate(sample.body.impulse, sample.velocity, external);
    const auto  compute_potential_at = [&](const double time) {
      return compute_potential(model, sample, impulse_rate, time, rate, shape.gait);
    };
    const Vector<double> potential      = compute_potential_at(sample.time);
    Vector<double>       potential_rate = compute_potential_at(sample.time + increment);
    potential_rate -= compute_potential_at(sample.time - increment);
    potential_rate /= 2. * increment;
    const SurfaceFields flow = compute_surface_fields(shape.surface, nodes, velocities, potential,
                                                      potential_rate, shape.densities.fluid);

    Vector<double> places(place_handler.n_dofs()), velocity(place_handler.n_dofs()),
        pressure(potential.size());
    std::copy(flow.pressure.begin(), flow.pressure.end(), pressure.begin());
    const auto                          &fe = place_handler.get_fe();
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : place_handler.active_cell_iterators())
    {
      cell->get_dof_indices(indices);
      const auto &cell_nodes = shape.surface.get_nodes(cell->active_cell_index());
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const auto [component, k] = fe.system_to_component_index(i);
        places(indices[i])        = nodes[cell_nodes[k]][component];
        velocity(indices[i])      = flow.velocity[cell_nodes[k]][component];
      }
    }

    const MappingFEField<2, 3, Vector<double>> mapping(place_handler, places);
    DataOut<2, 3>                              data_out;
    data_out.add_data_vector(shape.surface.get_dof_handler(), potential, "potential");
    data_out.add_data_vector(shape.surface.get_dof_handler(), pressure, "pressure");
    data_out.add_data_vector(place_handler, velocity, std::vector<std::string>(3, "velocity"),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                                 3, DataComponentInterpretation::component_is_part_of_vector));
    data_out.build_patches(mapping, std::max(2u, parameters.output.n_subdivisions),
                           DataOut<2, 3>::curved_inner_cells);
    fields.write(data_out, name, sample.time, counters.n_fields++, MPI_COMM_SELF);
  }
} // namespace caudal
