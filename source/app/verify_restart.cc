#include <caudal/app/model_run.h>
#include <caudal/app/verify_restart.h>
#include <caudal/base/archive.h>
#include <caudal/base/collective.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/io/safe_file.h>
#include <caudal/viscous/immersed_swimmer.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace caudal
{
  namespace
  {
    /** Asks for a stop after that many steps; a run asks once before each. */
    std::function<bool()> stop_after(const unsigned int n_steps)
    {
      return [n_steps, n = 0u]() mutable { return n++ >= n_steps; };
    }

    template <class State>
    State read_last_state(const std::string &folder, const MPI_Comm communicator)
    {
      State state;
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

    std::string compare_states(const IdealState &whole, const IdealState &resumed)
    {
      std::ostringstream differences;
      if (whole.step_number != resumed.step_number)
        differences << " the numbers of steps, " << whole.step_number << " and "
                    << resumed.step_number << ";";
      if (whole.time != resumed.time)
        differences << " the times;";
      if (pack(whole.swims) != pack(resumed.swims))
        differences << " motion, energies, strokes or counters of the output;";
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

    /** The names of the tables and lists that are not the same in both folders. */
    std::string compare_files(const std::string &whole, const std::string &resumed)
    {
      namespace fs = std::filesystem;
      std::set<std::string> names;
      for (const std::string &folder : {whole, resumed})
        for (const auto &entry : fs::directory_iterator(folder))
          if (entry.is_regular_file())
            names.insert(entry.path().filename().string());
      names.erase("log.txt");
      std::string differences;
      for (const std::string &name : names)
      {
        const fs::path a = fs::path(whole) / name, b = fs::path(resumed) / name;
        if (!fs::exists(a) || !fs::exists(b) || read_whole_file(a) != read_whole_file(b))
          differences += " " + name + ";";
      }
      return differences;
    }

    std::string print(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }

    /** The folder of one of the runs. */
    std::string get_folder(const std::string &base, const std::string &run)
    {
      return base + ".verify/" + run;
    }

    /** What the whole run has come to, and what differs from it in the resumed one. */
    template <class State>
    struct Comparison
    {
      State       state;
      std::string differences;
    };

    /** Runs all steps; half of them and, resumed, the other half. */
    template <class Swimmer>
    Comparison<typename Swimmer::State>
    compare_halves(ModelRun<Swimmer> &run, const std::string &base, const unsigned int n_steps,
                   const MPI_Comm communicator)
    {
      using State                                  = typename Swimmer::State;
      const std::string whole                      = get_folder(base, "whole");
      const std::string resumed                    = get_folder(base, "resumed");
      run.parameters.checkpoint.step_interval      = n_steps / 2;
      run.parameters.checkpoint.wall_time_interval = 0;
      run.parameters.checkpoint.wall_time_limit    = 0;

      run.parameters.output.folder = whole;
      run.start(stop_after(n_steps));
      run.parameters.output.folder = resumed;
      const Outcome half           = run.start(stop_after(n_steps / 2));
      AssertThrow(half == Outcome::stopped,
                  ExcMessage("Time/End time: the case ends within " + std::to_string(n_steps / 2) +
                             " steps, before there is anything to resume. Give a later time."));
      run.resume(stop_after(n_steps / 2));

      Comparison<State> result{read_last_state<State>(whole, communicator), ""};
      result.differences =
          compare_states(result.state, read_last_state<State>(resumed, communicator));
      std::string files;
      run_on_root(communicator, [&]() { files = compare_files(whole, resumed); });
      result.differences += Utilities::MPI::broadcast(communicator, files);
      return result;
    }

    void check_equality(const std::string &differences, const std::string &base)
    {
      AssertThrow(
          differences.empty(),
          ExcMessage("The resumed run is not the one that was not interrupted. They differ in" +
                     differences + " see <" + get_folder(base, "whole") + "> and <" +
                     get_folder(base, "resumed") + ">."));
    }

    template <int dim>
    std::string verify(ModelRun<ImmersedSwimmer<dim>> &run, const std::string &base,
                       const unsigned int n_steps, const MPI_Comm communicator)
    {
      auto [state, differences] = compare_halves(run, base, n_steps, communicator);

      // What a checkpoint loses, both of these runs have lost; this one has not.
      run.parameters.checkpoint.step_interval = 0;
      run.parameters.output.folder            = get_folder(base, "alone");
      run.start(stop_after(n_steps));
      const RunState alone  = read_last_state<RunState>(run.parameters.output.folder, communicator);
      const double   change = compare_velocities<dim>(state.fluid, alone.fluid);
      const double   allowed = 100 * n_steps * run.parameters.solver.tolerance;
      if (!(change < allowed))
        differences += " without a checkpoint the velocities are other ones, by " + print(change) +
                       " of the largest;";
      check_equality(differences, base);
      return std::to_string(state.step_number) + " steps, and half of them resumed for the rest: " +
             std::to_string(state.fluid.values.size()) +
             " values of the fluid, all bodies, tables and the list of fields are equal, bit by "
             "bit. Without a checkpoint velocities differ by less than " +
             print(allowed) + " of the largest.";
    }

    std::string verify(ModelRun<IdealSwimmer> &run, const std::string &base,
                       const unsigned int n_steps, const MPI_Comm communicator)
    {
      const auto [state, differences] = compare_halves(run, base, n_steps, communicator);
      check_equality(differences, base);
      return std::to_string(state.step_number) +
             " steps, and half of them resumed for the rest: impulses, place, energies, tables "
             "and the list of fields are equal, bit by bit.";
    }
  } // namespace

  template <class Swimmer>
  std::string verify_restart(const ParameterFile &file, const unsigned int n_steps,
                             MPI_Comm communicator)
  {
    ModelRun<Swimmer> run(file, communicator);
    const std::string base = run.parameters.output.folder;
    return verify(run, base, n_steps, communicator);
  }

  template std::string verify_restart<ImmersedSwimmer<2>>(const ParameterFile &, unsigned int,
                                                          MPI_Comm);
  template std::string verify_restart<ImmersedSwimmer<3>>(const ParameterFile &, unsigned int,
                                                          MPI_Comm);
  template std::string verify_restart<IdealSwimmer>(const ParameterFile &, unsigned int, MPI_Comm);
} // namespace caudal
