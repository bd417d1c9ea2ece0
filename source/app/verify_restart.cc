// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/model_run.h>
#include <caudal/app/verify_restart.h>
#include <caudal/base/archive.h>
#include <caudal/base/collective.h>
#include <caudal/base/safe_file.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/viscous/immersed_swimmer.h>

#include <cmath>
#include <filesystem>
#include <random>
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

    /** What differs between the two states on any rank, or nothing. Collective. */
    std::string compare_states(const Checkpoint &whole, const Checkpoint &resumed,
                               const MPI_Comm communicator)
    {
      const auto is_anywhere = [&](const bool is_here) {
        return Utilities::MPI::max(static_cast<int>(is_here), communicator) == 1;
      };
      const auto        &a = whole.fluid, &b = resumed.fluid;
      std::ostringstream differences;
      if (is_anywhere(a.cells != b.cells))
        differences << " the fluid's grid or the order of its cells;";
      if (is_anywhere(a.values != b.values))
      {
        double largest = 0;
        for (std::size_t i = 0; i < std::min(a.values.size(), b.values.size()); ++i)
          largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
        differences << " velocity or pressure, by up to "
                    << Utilities::MPI::max(largest, communicator) << ";";
      }
      for (const auto &[name, bytes] : whole.parts)
        if (bytes != resumed.parts.at(name))
          differences << " " << name << ";";
      return differences.str();
    }

    std::string compare_states(const IdealState &whole, const IdealState &resumed, MPI_Comm)
    {
      std::ostringstream differences;
      if (whole.time != resumed.time)
        differences << " the times;";
      if (pack(whole.swims) != pack(resumed.swims))
        differences << " motion, energies, strokes or counters of the output;";
      return differences.str();
    }

    std::string describe_comparison(const Checkpoint &state, const MPI_Comm communicator)
    {
      return std::to_string(Utilities::MPI::sum(state.fluid.values.size(), communicator)) +
             " values of the fluid, all bodies, tables and the list of fields";
    }

    std::string describe_comparison(const IdealState &, MPI_Comm)
    {
      return "impulses, place, energies, tables and the list of fields";
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
      names.erase("manifest.txt"); // which lists other checkpoints
      std::string differences;
      for (const std::string &name : names)
      {
        const fs::path a = fs::path(whole) / name, b = fs::path(resumed) / name;
        if (!fs::exists(a) || !fs::exists(b) || read_whole_file(a) != read_whole_file(b))
          differences += " " + name + ";";
      }
      return differences;
    }

  } // namespace

  template <class Swimmer>
  std::string verify_restart(const ParameterFile &file, const unsigned int n_steps,
                             MPI_Comm communicator)
  {
    using Checkpoint = typename Swimmer::Checkpoint;
    ModelRun<Swimmer> run(file, communicator);
    const std::string base                       = run.parameters.output.folder + ".verify/";
    run.parameters.checkpoint.step_interval      = 0;
    run.parameters.checkpoint.wall_time_interval = 0;
    run.parameters.checkpoint.wall_time_limit    = 0;
    run.parameters.output.existing_results       = "replace"; // of an earlier verification
    const auto run_in = [&](const std::string &folder, const unsigned int n) {
      run.parameters.output.folder = base + folder;
      return run.start(stop_after(n));
    };
    const auto read_last_state = [&](const std::string &folder) {
      Checkpoint           state;
      const CheckpointSlot slot = read_newest_checkpoint(base + folder, communicator);
      run_on_all(communicator, [&]() { read(slot, state); });
      return state;
    };

    const unsigned int seed     = Utilities::MPI::broadcast(communicator, std::random_device()());
    const unsigned int n_before = 1 + seed % (n_steps - 1);
    run_in("whole", n_steps);
    AssertThrow(run_in("resumed", n_before) == Outcome::stopped,
                ExcMessage("Time/End time: the case ends within " + std::to_string(n_before) +
                           " steps, before there is anything to resume. Give a later time."));
    run.resume(stop_after(n_steps - n_before));

    const Checkpoint whole = read_last_state("whole"), resumed = read_last_state("resumed");
    std::string      differences = compare_states(whole, resumed, communicator), files;
    if (whole.step_number != resumed.step_number)
      differences += " the numbers of steps, " + std::to_string(whole.step_number) + " and " +
                     std::to_string(resumed.step_number) + ";";
    run_on_root(communicator, [&]() { files = compare_files(base + "whole", base + "resumed"); });
    differences += Utilities::MPI::broadcast(communicator, files);
    const std::string stop =
        "after step " + std::to_string(n_before) + " (seed " + std::to_string(seed) + ")";
    AssertThrow(differences.empty(),
                ExcMessage("The run that was stopped " + stop +
                           " and resumed is not the one that was not interrupted. They differ in" +
                           differences + " see <" + base + "whole> and <" + base + "resumed>."));
    return std::to_string(whole.step_number) + " steps, and the same stopped " + stop +
           " and resumed for the rest: " + describe_comparison(whole, communicator) +
           " are equal, bit by bit.";
  }

  template std::string verify_restart<ImmersedSwimmer<2>>(const ParameterFile &, unsigned int,
                                                          MPI_Comm);
  template std::string verify_restart<ImmersedSwimmer<3>>(const ParameterFile &, unsigned int,
                                                          MPI_Comm);
  template std::string verify_restart<IdealSwimmer>(const ParameterFile &, unsigned int, MPI_Comm);
} // namespace caudal
