// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/checkpoint_folder.h>

#include <caudal/base/collective.h>
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
  namespace
  {
    namespace fs = std::filesystem;

    const std::string title  = "Checkpoint of a run of Caudal, format 1";
    const std::string prefix = "step-";

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

    std::string get_slot_name(const unsigned int step)
    {
      return prefix + Utilities::int_to_string(step, 8);
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
    CheckpointFolder::Checkpoint find_newest(const fs::path &folder)
    {
      CheckpointFolder::Checkpoint checkpoint;
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
  } // namespace

  CheckpointFolder::CheckpointFolder(const std::string &results, const unsigned int n_slots,
                                     const MPI_Comm communicator)
      : results(results)
      , folder(results + "/restart")
      , n_slots(n_slots)
      , communicator(communicator)
  {}

  void CheckpointFolder::write_slot(const std::string &data, const unsigned int step,
                                    const double time) const
  {
    const fs::path root = folder, unfinished = root / "unfinished", replaced = root / "replaced";
    const fs::path slot = root / get_slot_name(step);
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

  void CheckpointFolder::write(const std::string &data, const unsigned int step,
                               const double time) const
  {
    run_on_root(communicator, [&]() {
      const std::string reason = catch_file_error([&]() { write_slot(data, step, time); });
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
  }

  CheckpointFolder::Checkpoint CheckpointFolder::read_newest() const
  {
    Checkpoint checkpoint;
    run_on_root(communicator, [&]() {
      checkpoint = find_newest(folder);
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

  void CheckpointFolder::remove_after(const unsigned int step) const
  {
    run_on_root(communicator, [&]() {
      for (const fs::path &slot : find_slots(folder))
        if (get_step(slot) > step)
          fs::remove_all(slot);
    });
  }
} // namespace caudal
