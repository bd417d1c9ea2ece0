// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/collective.h>
#include <caudal/io/checkpoints.h>
#include <caudal/io/safe_file.h>

#include <boost/crc.hpp>

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

    const std::string title  = "Checkpoint of a run of Caudal, format 1";
    const std::string prefix = "step-";

    std::string get_folder(const std::string &results)
    {
      return results + "/restart";
    }

    std::string compute_checksum(const std::string &text)
    {
      boost::crc_32_type crc;
      crc.process_bytes(text.data(), text.size());
      std::ostringstream result;
      result << std::hex << std::setw(8) << std::setfill('0') << crc.checksum();
      return result.str();
    }

    /** The step of a slot's folder; a name that is none gives -1. */
    long get_step(const fs::path &path)
    {
      static const std::regex pattern(prefix + "(\\d{8})");
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

    std::string make_manifest(const std::string &data, const unsigned int step, const double time)
    {
      std::ostringstream text;
      text << title << "\nstep " << step << "\ntime " << std::setprecision(17) << time
           << " s\nstate " << data.size() << ' ' << compute_checksum(data) << '\n';
      return text.str() + "manifest " + compute_checksum(text.str()) + '\n';
    }

    /** The state in a slot, or an exception that says why it is not whole. */
    std::string read_slot(const fs::path &slot)
    {
      const std::string manifest = read_whole_file(slot / "manifest");
      const std::size_t end      = manifest.rfind("manifest ");
      if (end == std::string::npos ||
          manifest.substr(end) != "manifest " + compute_checksum(manifest.substr(0, end)) + '\n')
        throw std::runtime_error("its manifest is damaged");
      if (manifest.rfind(title + '\n', 0) != 0)
        throw std::runtime_error("it was written in another format, by another version of Caudal");
      std::istringstream words(manifest.substr(manifest.find("\nstate ")));
      std::string        word, checksum;
      std::size_t        size = 0;
      words >> word >> size >> checksum;

      const std::string data = read_whole_file(slot / "state");
      if (data.size() != size)
        throw std::runtime_error("its state has " + std::to_string(data.size()) +
                                 " bytes instead of " + std::to_string(size));
      if (compute_checksum(data) != checksum)
        throw std::runtime_error("its state is damaged (the checksums differ)");
      return data;
    }

    /** The newest whole checkpoint; its path is empty if there is none. */
    CheckpointSlot find_newest(const fs::path &folder)
    {
      CheckpointSlot checkpoint;
      for (const fs::path &slot : find_slots(folder))
        try
        {
          checkpoint.data = read_slot(slot);
          checkpoint.path = slot.string();
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
    void write_slot(const std::string &results, const std::string &data, const unsigned int step,
                    const double time, const unsigned int n_slots)
    {
      const fs::path root       = get_folder(results);
      const fs::path unfinished = root / "unfinished", replaced = root / "replaced";
      const fs::path slot = root / (prefix + Utilities::int_to_string(step, 8));
      if (!fs::is_directory(results))
        throw std::runtime_error("the folder <" + results + "> is gone");
      fs::create_directory(root);
      fs::remove_all(unfinished);
      fs::create_directory(unfinished);
      write_whole_file(unfinished / "state", data);
      write_whole_file(unfinished / "manifest", make_manifest(data, step, time));
      synchronise(unfinished);

      fs::remove_all(replaced);
      if (fs::exists(slot))
        fs::rename(slot, replaced);
      fs::rename(unfinished, slot);
      synchronise(root);
      fs::remove_all(replaced);

      const std::vector<fs::path> slots = find_slots(root);
      for (std::size_t k = n_slots; k < slots.size(); ++k)
        fs::remove_all(slots[k]);
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

  void remove_checkpoints_after(const std::string &results, const unsigned int step,
                                const MPI_Comm communicator)
  {
    run_on_root(communicator, [&]() {
      for (const fs::path &slot : find_slots(get_folder(results)))
        if (get_step(slot) > step)
          fs::remove_all(slot);
    });
  }

  CheckpointWriter::CheckpointWriter(const CheckpointParameters &parameters,
                                     const MPI_Comm              communicator)
      : parameters(parameters)
      , communicator(communicator)
  {}

  void CheckpointWriter::start(const std::string &folder)
  {
    results = folder;
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
    const std::string folder = get_folder(results);
    run_on_root(communicator, [&]() {
      const std::string reason =
          catch_file_error([&]() { write_slot(results, data, step, time, parameters.n_slots); });
      if (reason.empty())
        return;
      std::error_code ignored;
      fs::remove_all(fs::path(folder) / "unfinished", ignored);
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
         << " at t = " << time << " s, step " << step << ". To go on: caudal --resume " << results;
    return text.str();
  }
} // namespace caudal
