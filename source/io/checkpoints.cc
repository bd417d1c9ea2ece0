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

    const std::string title       = "Checkpoint of a run of Caudal, format 3";
    const std::string prefix      = "step-";
    const std::string copy_ending = "-copy"; // of a slot that is being written anew
    // The files of a slot
    const std::string state_name = "state", parameters_name = "parameters.prm",
                      manifest_name = "manifest", part_prefix = "part-";

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

    std::string get_part_name(const unsigned int rank)
    {
      return part_prefix + Utilities::int_to_string(rank, 5);
    }

    bool is_part(const std::string &name)
    {
      static const std::regex pattern(part_prefix + "\\d{5,}");
      return std::regex_match(name, pattern);
    }

    /** Size and checksum, by which a file is recognised. */
    std::string describe(const std::string &text)
    {
      return std::to_string(text.size()) + ' ' + compute_checksum(text);
    }

    /** @p parts: a line for each. */
    std::string make_manifest(const std::string &data, const std::string &parts,
                              const unsigned int step, const double time,
                              const OutputFolder &output)
    {
      const std::string &parameters = output.get_parameters();
      std::ostringstream text;
      text << title << "\nstep " << step << "\ntime " << std::setprecision(17) << time << " s\n"
           << state_name << ' ' << describe(data) << '\n'
           << parameters_name << ' ' << describe(parameters) << '\n'
           << parts;
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

    /** Reads a slot but for its parts, or throws an exception that says why it is not whole. */
    CheckpointSlot read_slot(const fs::path &slot, const std::vector<std::string> &manifest)
    {
      CheckpointSlot checkpoint;
      checkpoint.data       = read_part(slot, state_name, manifest);
      checkpoint.parameters = read_part(slot, parameters_name, manifest);
      checkpoint.damages    = find_damages(slot.parent_path().parent_path(), manifest);
      checkpoint.path       = slot.string();
      return checkpoint;
    }

    std::vector<std::string> get_parts(const std::vector<std::string> &manifest)
    {
      std::vector<std::string> names;
      for (const std::string &line : manifest)
        if (const std::string name = line.substr(0, line.find(' ')); is_part(name))
          names.push_back(name);
      return names;
    }

    /** A rank's share of the parts: neighbours stay together. */
    std::vector<std::string> read_parts(const fs::path                 &slot,
                                        const std::vector<std::string> &manifest,
                                        const std::size_t rank, const std::size_t n_ranks)
    {
      const std::vector<std::string> names = get_parts(manifest);
      std::vector<std::string>       parts;
      for (std::size_t k = rank * names.size() / n_ranks; k < (rank + 1) * names.size() / n_ranks;
           ++k)
        parts.push_back(read_part(slot, names[k], manifest));
      return parts;
    }

    std::string describe_skipped(const fs::path &slot, const std::string &reason)
    {
      return "The checkpoint <" + slot.string() + "> was skipped: " + reason + ".";
    }

    /** Removes a slot, but no file of somebody else in it. */
    void remove_slot(const fs::path &slot)
    {
      std::vector<fs::path> files{slot / manifest_name, slot / state_name, slot / parameters_name};
      if (fs::is_directory(slot))
        for (const auto &entry : fs::directory_iterator(slot))
          if (is_part(entry.path().filename().string()))
            files.push_back(entry.path());
      for (const fs::path &file : files)
        fs::remove(file);
      std::error_code ignored;
      fs::remove(slot, ignored);
    }

    /** The newest whole checkpoint, without its parts; its path is empty if there is none. */
    CheckpointSlot find_newest(const fs::path &folder)
    {
      for (const fs::path &slot : find_slots(folder))
        try
        {
          const std::vector<std::string> manifest   = read_manifest(slot);
          CheckpointSlot                 checkpoint = read_slot(slot, manifest);
          for (const std::string &part : get_parts(manifest))
            read_part(slot, part, manifest);
          return checkpoint;
        }
        catch (const std::exception &)
        {}
      return {};
    }

    fs::path get_unfinished(const OutputFolder &output)
    {
      return fs::path(get_folder(output.path())) / "unfinished";
    }

    /** Makes the folder of a slot that is being written. */
    void begin_slot(const OutputFolder &output)
    {
      if (!fs::is_directory(output.path()))
        throw std::runtime_error("the folder <" + output.path() + "> is gone");
      fs::create_directory(get_folder(output.path()));
      const fs::path unfinished = get_unfinished(output);
      remove_slot(unfinished);
      fs::create_directory(unfinished); // first, so that others see that it is being written
      output.synchronise();
    }

    /** File systems of several machines may have put a part elsewhere. @p lines: as describe(). */
    void check_parts(const fs::path &slot, const std::string &lines)
    {
      std::istringstream words(lines);
      std::string        name, checksum;
      std::uintmax_t     size = 0;
      while (words >> name >> size >> checksum)
        if (fs::file_size(slot / name) != size)
          throw std::runtime_error("<" + (slot / name).string() + "> is not as it was written");
    }

    /** Writes what rank 0 does into it and gives it its name; keeps @p n_slots of them. */
    void finish_slot(const OutputFolder &output, const std::string &data, const std::string &parts,
                     const unsigned int step, const double time, const unsigned int n_slots)
    {
      const fs::path root = get_folder(output.path()), unfinished = get_unfinished(output);
      const fs::path slot = root / (prefix + Utilities::int_to_string(step, 8));
      check_parts(unfinished, parts);
      write_whole_file(unfinished / state_name, data);
      write_whole_file(unfinished / parameters_name, output.get_parameters());
      write_whole_file(unfinished / manifest_name, make_manifest(data, parts, step, time, output));
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
    const unsigned int       rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int       n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::vector<std::string> slots, skipped;
    run_on_root(communicator, [&]() {
      for (const fs::path &slot : find_slots(get_folder(results)))
        slots.push_back(slot.string());
    });
    slots = Utilities::MPI::broadcast(communicator, slots);
    for (const std::string &slot : slots)
    {
      CheckpointSlot           checkpoint;
      std::vector<std::string> manifest, parts;
      std::string              reason;
      if (rank == 0)
        reason = catch_error([&]() {
          manifest   = read_manifest(slot);
          checkpoint = read_slot(slot, manifest);
        });
      manifest = Utilities::MPI::broadcast(communicator, manifest);
      reason   = find_first_error(communicator, reason);
      if (reason.empty())
        reason = find_first_error(communicator, catch_error([&]() {
                                    parts = read_parts(slot, manifest, rank, n_ranks);
                                  }));
      if (reason.empty())
      {
        checkpoint         = Utilities::MPI::broadcast(communicator, checkpoint);
        checkpoint.parts   = std::move(parts);
        checkpoint.skipped = skipped;
        return checkpoint;
      }
      skipped.push_back(describe_skipped(slot, reason));
    }
    std::string reasons;
    for (const std::string &sentence : skipped)
      reasons += " " + sentence;
    AssertThrow(false, ExcMessage("The folder <" + results +
                                  "> holds no checkpoint to resume from." + reasons +
                                  " Give the folder of a run that has written one, or start the "
                                  "run anew."));
    return {};
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

  std::string CheckpointWriter::try_to_write(const std::string &data, const std::string &part,
                                             const unsigned int step, const double time) const
  {
    const unsigned int rank   = Utilities::MPI::this_mpi_process(communicator);
    const auto         try_it = [&](const bool takes_part, const auto &action) {
      std::string       reason;
      const std::string other_error = catch_error([&]() {
        if (takes_part)
          reason = catch_file_error(action);
      });
      return find_first_error(communicator, reason.empty() ? other_error : reason);
    };
    std::string reason = try_it(rank == 0, [&]() { begin_slot(*output); });
    if (!reason.empty())
      return reason;
    const std::string name = get_part_name(rank);
    reason =
        try_it(!part.empty(), [&]() { write_whole_file(get_unfinished(*output) / name, part); });
    if (!reason.empty())
      return reason;
    std::string lines;
    for (const std::string &line : Utilities::MPI::gather(
             communicator, part.empty() ? std::string() : name + ' ' + describe(part) + '\n'))
      lines += line;
    return try_it(rank == 0,
                  [&]() { finish_slot(*output, data, lines, step, time, parameters.n_slots); });
  }

  void CheckpointWriter::write(const std::string &data, const std::string &part,
                               const unsigned int step, const double time)
  {
    const std::string reason = try_to_write(data, part, step, time);
    if (!reason.empty())
      run_on_root(communicator, [&]() {
        const std::string results = output->path(), folder = get_folder(results);
        catch_file_error([&]() { remove_slot(get_unfinished(*output)); });
        bool is_one_left = false;
        catch_file_error([&]() { is_one_left = !find_newest(folder).path.empty(); });
        AssertThrow(
            false, ExcMessage("The checkpoint of step " + std::to_string(step) +
                              " can't be written to <" + folder + ">: " + reason +
                              (is_one_left ? ". An earlier checkpoint there is still whole. Make "
                                             "room or give access, then go on by caudal --resume " +
                                                 results + "."
                                           : ". There is no whole checkpoint left there. Make "
                                             "room or give access, then start the run anew.")));
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
