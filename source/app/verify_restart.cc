#include <caudal/app/immersed_run.h>
#include <caudal/app/verify_restart.h>
#include <caudal/base/collective.h>
#include <caudal/io/safe_file.h>

#include <cmath>
#include <limits>
#include <map>

namespace caudal
{
  namespace
  {
    /** Asks for a stop after that many steps; a run asks once before each. */
    std::function<bool()> stop_after(const unsigned int n_steps)
    {
      return [n_steps, n = 0u]() mutable { return n++ >= n_steps; };
    }

    RunState read_last_state(const std::string &folder, const MPI_Comm communicator)
    {
      RunState state;
      unpack(CheckpointFolder(folder, 1, communicator).read_newest().data, state);
      return state;
    }

    double compute_largest_difference(const std::vector<double> &a, const std::vector<double> &b)
    {
      double difference = 0;
      for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        difference = std::max(difference, std::abs(a[i] - b[i]));
      return difference;
    }

    /** What differs between the two states, or nothing. */
    std::string compare_states(const RunState &whole, const RunState &resumed)
    {
      std::ostringstream differences;
      if (whole.step_number != resumed.step_number)
        differences << " the numbers of steps, " << whole.step_number << " and "
                    << resumed.step_number << ";";
      if (whole.fluid.cells != resumed.fluid.cells)
        differences << " the fluid's grid or the order of its cells;";
      if (whole.fluid.values != resumed.fluid.values)
        differences << " velocity or pressure, by up to "
                    << compute_largest_difference(whole.fluid.values, resumed.fluid.values) << ";";
      if (whole.bodies != resumed.bodies)
        differences << " the bodies;";
      if (whole.stepper != resumed.stepper)
        differences << " time or step;";
      if (whole.output != resumed.output)
        differences << " energies, tail beats or counters of the output;";
      return differences.str();
    }
    /** The largest difference of velocities, relative to the largest; infinite on other grids. */
    template <int dim>
    double compare_velocities(const FluidSnapshot &a, const FluidSnapshot &b)
    {
      const std::size_t key_size = 4, n_cells = a.cells.size() / key_size;
      const std::size_t stride = a.values.size() / n_cells, n_velocities = stride - (dim + 1);
      const auto        get_key = [&](const FluidSnapshot &snapshot, const std::size_t cell) {
        const auto begin = snapshot.cells.begin() + cell * key_size;
        return std::vector<std::uint32_t>(begin, begin + key_size);
      };
      // The order of the cells depends on how the grid came about.
      std::map<std::vector<std::uint32_t>, std::size_t> index;
      for (std::size_t cell = 0; cell < b.cells.size() / key_size; ++cell)
        index[get_key(b, cell)] = cell;
      double difference = 0, largest = 0;
      for (std::size_t cell = 0; cell < n_cells; ++cell)
      {
        const auto found = index.find(get_key(a, cell));
        if (found == index.end())
          return std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < n_velocities; ++i)
        {
          const double value = a.values[cell * stride + i];
          difference = std::max(difference, std::abs(value - b.values[found->second * stride + i]));
          largest    = std::max(largest, std::abs(value));
        }
      }
      return difference / std::max(largest, std::numeric_limits<double>::min());
    }

    std::string print(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }
  } // namespace

  template <int dim>
  std::string verify_restart(const ParameterFile &file, const unsigned int n_steps,
                             MPI_Comm communicator)
  {
    ImmersedRun<dim>  run(file, communicator);
    const std::string base  = run.parameters.output.folder + ".verify";
    const std::string whole = base + "/whole", resumed = base + "/resumed", alone = base + "/alone";
    run.parameters.checkpoint.step_interval      = n_steps / 2;
    run.parameters.checkpoint.wall_time_interval = 0;
    run.parameters.checkpoint.wall_time_limit    = 0;
    run.parameters.solver.reproducible           = true;

    run.parameters.output.folder = whole;
    run.start(stop_after(n_steps));
    run.parameters.output.folder = resumed;
    const Outcome half           = run.start(stop_after(n_steps / 2));
    AssertThrow(half == Outcome::stopped,
                ExcMessage("Time/End time: the case ends within " + std::to_string(n_steps / 2) +
                           " steps, before there is anything to resume. Give a later time."));
    run.resume(stop_after(n_steps / 2));

    const RunState whole_state = read_last_state(whole, communicator);
    std::string differences = compare_states(whole_state, read_last_state(resumed, communicator));
    run_on_root(communicator, [&]() {
      for (const char *const name : {"/statistics.txt", "/solution.pvd", "/solution.xdmf"})
        if (std::filesystem::exists(whole + name) &&
            read_whole_file(whole + name) != read_whole_file(resumed + name))
          differences += " " + std::string(name + 1) + ";";
    });
    differences = Utilities::MPI::broadcast(communicator, differences);

    // What a checkpoint loses, both of these runs have lost; this one has not.
    run.parameters.checkpoint.step_interval = 0;
    run.parameters.output.folder            = alone;
    run.start(stop_after(n_steps));
    const double change =
        compare_velocities<dim>(whole_state.fluid, read_last_state(alone, communicator).fluid);
    const double allowed = 100 * n_steps * run.parameters.solver.tolerance;
    if (!(change < allowed))
      differences += " without a checkpoint the velocities are other ones, by " + print(change) +
                     " of the largest;";
    AssertThrow(
        differences.empty(),
        ExcMessage("The resumed run is not the one that was not interrupted. They differ in" +
                   differences + " see <" + whole + "> and <" + resumed + ">."));
    return std::to_string(whole_state.step_number) +
           " steps, and half of them resumed for the rest: " +
           std::to_string(whole_state.fluid.values.size()) +
           " values of the fluid, all bodies, statistics.txt and the list of fields are equal, bit "
           "by bit. Without a checkpoint velocities differ by less than " +
           print(allowed) + " of the largest.";
  }

  template std::string verify_restart<2>(const ParameterFile &, unsigned int, MPI_Comm);
  template std::string verify_restart<3>(const ParameterFile &, unsigned int, MPI_Comm);
} // namespace caudal
