// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/collective.h>
#include <caudal/base/command_line.h>
#include <caudal/base/safe_file.h>
#include <caudal/io/checkpoints.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <regex>
#include <sstream>
#include <stdexcept>

using namespace dealii;

namespace caudal
{
  void CheckpointParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Checkpoint");
    prm.add_parameter("Interval of steps", step_interval,
                      "Steps between two checkpoints, from which a run can be resumed; 0: the "
                      "wall time alone decides [1].",
                      Patterns::Integer(0));
    prm.add_parameter("Interval of wall time", wall_time_interval,
                      "Wall time between two checkpoints [min]; 0: the steps alone decide.");
    prm.add_parameter("Slots", n_slots, "The number of checkpoints that are kept [1].",
                      Patterns::Integer(1, 1000));
    prm.add_parameter("Wall time limit", wall_time_limit,
                      "Wall time after which the run finishes its step, writes a checkpoint and "
                      "ends with exit code 2 [h]; 0: no limit.");
    prm.leave_subsection();
  }

  void CheckpointParameters::check() const
  {
    check_not_negative("Checkpoint/Interval of wall time", wall_time_interval,
                       "Give a positive time [min], or 0 to count steps only.");
    check_not_negative("Checkpoint/Wall time limit", wall_time_limit,
                       "Give a positive time [h], or 0 for no limit.");
  }

  namespace
  {
    namespace fs = std::filesystem;

    const std::string title       = "Checkpoint of a run of Caudal, format 2";
    const std::string prefix      = "step-";
    const std::string copy_ending = "-copy"; // of a slot that is being written anew
    // The files of a slot
    const std::string state_name = "state", parameters_name = "parameters.prm",
                      manifest_name = "manifest";

    std::string get_folder(const std::string &results)
    {
      return results + "/restart";
    }

    /** The step of a slot's folder; a name that is none gives -1. */
    long get_step(const fs::path &path)
    {
      static const std::regex pattern(prefix + "(\\d{8})(" + copy_ending + ")?");
      const std::string       name = path.filename().string();
      std::smatch             match;
      return std::regex_match(name, match, pattern) ? std::stol(match[1]) : -1;
    }

    /** The slots by their steps, the newest first. */
    std::vector<fs::path> find_slots(const fs::path &folder)
    {
      std::vector<fs::path> slots;
      if (fs::is_directory(folder))
        for (const auto &entry : fs::directory_iterator(folder))
          if (entry.is_directory() && get_step(entry.path()) >= 0)
            slots.push_back(entry.path());
      std::sort(slots.begin(), slots.end(),
                [](const fs::path &a, const fs::path &b) { return get_step(a) > get_step(b); });
      return slots;
    }

    /** Size and checksum, by which a file is recognised. */
    std::string describe(const std::string &text)
    {
      return std::to_string(text.size()) + ' ' + compute_checksum(text);
    }

    std::string make_manifest(const std::string &data, const std::string &parameters,
                              const unsigned int step, const double time,
                              const OutputFolder &output)
    {
      std::ostringstream text;
      text << title << "\nstep " << step << "\ntime " << std::setprecision(17) << time << " s\n"
           << state_name << ' ' << describe(data) << '\n'
           << parameters_name << ' ' << describe(parameters) << '\n';
      for (const std::string &table : output.get_tables())
      {
        // A table that is gone is told by its next row.
        std::string rows;
        if (catch_file_error([&]() { rows = read_whole_file(output.path(table)); }).empty())
          text << "table " << describe(rows) << ' ' << table << '\n';
      }
      return text.str() + "manifest " + compute_checksum(text.str()) + '\n';
    }

    /** The lines of a slot's manifest, or an exception that says why it can't be believed. */
    std::vector<std::string> read_manifest(const fs::path &slot)
    {
      const std::string manifest = read_whole_file(slot / manifest_name);
      const std::size_t end      = manifest.rfind("manifest ");
      if (end == std::string::npos ||
          manifest.substr(end) != "manifest " + compute_checksum(manifest.substr(0, end)) + '\n')
        throw std::runtime_error("its manifest is damaged");
      if (manifest.rfind(title + '\n', 0) != 0)
        throw std::runtime_error("it was written in another format, by another version of Caudal");
      return Utilities::split_string_list(manifest.substr(0, end), '\n');
    }

    /** A file of a slot, or an exception that says what is wrong with it. */
    std::string read_part(const fs::path &slot, const std::string &name,
                          const std::vector<std::string> &manifest)
    {
      const std::string text = read_whole_file(slot / name);
      if (std::find(manifest.begin(), manifest.end(), name + ' ' + describe(text)) ==
          manifest.end())
        throw std::runtime_error("its file <" + name + "> is damaged (size or checksum differ)");
      return text;
    }

    /** What is wrong with the tables of @p results that the manifest knows. */
    std::vector<std::string> find_damages(const fs::path                 &results,
                                          const std::vector<std::string> &manifest)
    {
      std::vector<std::string> damages;
      for (const std::string &line : manifest)
      {
        if (line.rfind("table ", 0) != 0)
          continue;
        std::istringstream words(line);
        std::string        word, checksum, name;
        std::size_t        size = 0;
        words >> word >> size >> checksum >> std::ws;
        std::getline(words, name);
        std::string       text;
        const std::string reason =
            catch_file_error([&]() { text = read_whole_file(results / name); });
        const std::string damage =
            !reason.empty()      ? " is missing or can't be read (" + reason + ")"
            : text.size() < size ? " has lost its end, " + std::to_string(size - text.size()) +
                                       " of " + std::to_string(size) + " bytes"
            : compute_checksum(text.substr(0, size)) != checksum
                ? " was changed since the checkpoint was written"
                : "";
        if (!damage.empty())
          damages.push_back("<" + name + ">" + damage +
                            (reason.empty() ? ". What is left of it is kept." : "."));
      }
      return damages;
    }

    /** Reads a slot, or throws an exception that says why it is not whole. */
    void read_slot(const fs::path &slot, CheckpointSlot &checkpoint)
    {
      const std::vector<std::string> manifest = read_manifest(slot);
      checkpoint.data                         = read_part(slot, state_name, manifest);
      checkpoint.parameters                   = read_part(slot, parameters_name, manifest);
      checkpoint.damages = find_damages(slot.parent_path().parent_path(), manifest);
      checkpoint.path    = slot.string();
    }

    /** Removes a slot, but no file of somebody else in it. */
    void remove_slot(const fs::path &slot)
    {
      for (const std::string &name : {manifest_name, state_name, parameters_name})
        fs::remove(slot / name);
      std::error_code ignored;
      fs::remove(slot, ignored);
    }

    /** The newest whole checkpoint; its path is empty if there is none. */
    CheckpointSlot find_newest(const fs::path &folder)
    {
      CheckpointSlot checkpoint;
      for (const fs::path &slot : find_slots(folder))
        try
        {
          read_slot(slot, checkpoint);
          break;
        }
        catch (const std::exception &exception)
        {
          checkpoint.skipped.push_back("The checkpoint <" + slot.string() +
                                       "> was skipped: " + exception.what() + ".");
        }
      return checkpoint;
    }

    /** Keeps @p n_slots of them. */
    void write_slot(const OutputFolder &output, const std::string &data, const unsigned int step,
                    const double time, const unsigned int n_slots)
    {
      const fs::path root = get_folder(output.path()), unfinished = root / "unfinished";
      const fs::path slot = root / (prefix + Utilities::int_to_string(step, 8));
      if (!fs::is_directory(output.path()))
        throw std::runtime_error("the folder <" + output.path() + "> is gone");
      fs::create_directory(root);
      remove_slot(unfinished);
      fs::create_directory(unfinished); // first, so that others see that it is being written
      output.synchronise();
      const std::string &parameters = output.get_parameters();
      write_whole_file(unfinished / state_name, data);
      write_whole_file(unfinished / parameters_name, parameters);
      write_whole_file(unfinished / manifest_name,
                       make_manifest(data, parameters, step, time, output));
      synchronise(unfinished);

      // The one that is written anew stays whole, as a copy, until this one is there.
      const fs::path replaced = slot.string() + copy_ending;
      remove_slot(replaced);
      if (fs::exists(slot))
        fs::rename(slot, replaced);
      fs::rename(unfinished, slot);
      synchronise(root);
      remove_slot(replaced);

      const std::vector<fs::path> slots = find_slots(root);
      for (std::size_t k = n_slots; k < slots.size(); ++k)
        remove_slot(slots[k]);
    }
  } // namespace

  CheckpointSlot read_newest_checkpoint(const std::string &results, const MPI_Comm communicator)
  {
    CheckpointSlot checkpoint;
    run_on_root(communicator, [&]() {
      checkpoint = find_newest(get_folder(results));
      std::string reasons;
      for (const std::string &sentence : checkpoint.skipped)
        reasons += " " + sentence;
      AssertThrow(!checkpoint.path.empty(),
                  ExcMessage("The folder <" + results + "> holds no checkpoint to resume from." +
                             reasons +
                             " Give the folder of a run that has written one, or start the "
                             "run anew."));
    });
    return Utilities::MPI::broadcast(communicator, checkpoint);
  }

  std::string find_newest_parameters(const std::string &results)
  {
    const CheckpointSlot newest = find_newest(get_folder(results));
    AssertThrow(!newest.path.empty(),
                ExcMessage("The folder <" + results +
                           "> has lost its parameters.prm, and there is no whole checkpoint that "
                           "knows them. Start the run anew."));
    return newest.parameters;
  }

  void remove_checkpoints_after(const std::string &results, const unsigned int step,
                                const MPI_Comm communicator)
  {
    run_on_root(communicator, [&]() {
      for (const fs::path &slot : find_slots(get_folder(results)))
        if (get_step(slot) > step)
          remove_slot(slot);
    });
  }

  CheckpointWriter::CheckpointWriter(const CheckpointParameters &parameters,
                                     const MPI_Comm              communicator)
      : parameters(parameters)
      , communicator(communicator)
  {}

  void CheckpointWriter::start(const OutputFolder &output_folder)
  {
    output = &output_folder;
    clock.restart();
  }

  bool CheckpointWriter::is_due(const unsigned int step) const
  {
    const unsigned int interval = parameters.step_interval;
    const double       minutes  = parameters.wall_time_interval;
    const bool         by_steps = interval > 0 && step % interval == 0;
    const bool         by_time  = minutes > 0 && clock.wall_time() > 60 * minutes;
    return Utilities::MPI::max(static_cast<int>(by_steps || by_time), communicator) > 0;
  }

  void CheckpointWriter::write(const std::string &data, const unsigned int step, const double time)
  {
    const std::string results = output->path(), folder = get_folder(results);
    run_on_root(communicator, [&]() {
      const std::string reason =
          catch_file_error([&]() { write_slot(*output, data, step, time, parameters.n_slots); });
      if (reason.empty())
        return;
      catch_file_error([&]() { remove_slot(fs::path(folder) / "unfinished"); });
      bool is_one_left = false;
      catch_file_error([&]() { is_one_left = !find_newest(folder).path.empty(); });
      AssertThrow(false,
                  ExcMessage("The checkpoint of step " + std::to_string(step) +
                             " can't be written to <" + folder + ">: " + reason +
                             (is_one_left ? ". An earlier checkpoint there is still whole. Make "
                                            "room or give access, then go on by caudal --resume " +
                                                results + "."
                                          : ". There is no whole checkpoint left there. Make room "
                                            "or give access, then start the run anew.")));
    });
    last_step = step;
    clock.restart();
  }

  bool CheckpointWriter::is_out_of_time() const
  {
    const double limit = parameters.wall_time_limit;
    return limit > 0 && Utilities::MPI::max(run_clock.wall_time(), communicator) > 3600 * limit;
  }

  std::string describe_stop(const bool on_request, const double time, const unsigned int step,
                            const std::string &results)
  {
    std::ostringstream text;
    text << (on_request ? "Stopped on request" : "Stopped by Checkpoint/Wall time limit")
         << " at t = " << time << " s, step " << step << ". To go on: " << get_command()
         << " --resume " << results;
    return text.str();
  }

  bool has_checkpoints(const std::string &results)
  {
    return !find_slots(get_folder(results)).empty();
  }

  void remove_checkpoints(const std::string &results)
  {
    const fs::path folder = get_folder(results);
    for (const fs::path &slot : find_slots(folder))
      remove_slot(slot);
    remove_slot(folder / "unfinished");
    std::error_code ignored;
    fs::remove(folder, ignored);
  }
} // namespace caudal
