// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/command_line.h>
#include <caudal/base/safe_file.h>
#include <caudal/io/checkpoints.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/statistics.h>

#include <deal.II/base/utilities.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

using namespace dealii;

namespace caudal
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::string parameters_title = "# Parameters of a run of Caudal";
    const std::string manifest_title   = "# What a run of Caudal has written. The run is ";
    const std::string manifest_name    = "manifest.txt";
    const std::string lock_name        = "lock";

    std::string get_word(const OutputFolder::Progress progress)
    {
      return progress == OutputFolder::Progress::finished ? "finished"
             : progress == OutputFolder::Progress::failed ? "failed"
                                                          : "unfinished";
    }

    /** What keeps a new run out of a folder without a manifest. */
    bool has_foreign_files(const fs::path &folder)
    {
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.path().filename() != lock_name &&
            entry.path().filename() != manifest_name + ".tmp")
          return true;
      return false;
    }

    /** The name of a folder that may be given as "folder/". */
    fs::path get_base(const fs::path &folder)
    {
      return folder.has_filename() ? folder : folder.parent_path();
    }

    /** The first of folder.1, folder.2, ... that is free. */
    fs::path find_free_name(const fs::path &base)
    {
      for (unsigned int k = 1;; ++k)
      {
        const fs::path name = base.string() + "." + std::to_string(k);
        if (!fs::exists(name))
          return name;
      }
    }
  } // namespace

  /** The file `lock`, which this process holds as long as the object lives. */
  class OutputFolder::Lock
  {
  public:
    explicit Lock(const fs::path &folder)
        : path(folder / lock_name)
    {
      do // until the file that is locked is the one that others find
      {
        if (descriptor >= 0)
          close(descriptor);
        descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0)
          throw std::runtime_error(std::strerror(errno));
        if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || is_alive()))
        {
          const std::string owner = read_whole_file(path);
          close(descriptor);
          throw std::runtime_error("another run writes to it, " + Utilities::trim(owner) +
                                   ". Wait for its end, or stop it.");
        }
      } while (!is_in_place());
      const std::string text =
          "process " + std::to_string(getpid()) + " on " + Utilities::System::get_hostname() + "\n";
      if (ftruncate(descriptor, 0) != 0 || pwrite(descriptor, text.data(), text.size(), 0) < 0)
      {
        const std::string reason = std::strerror(errno);
        close(descriptor);
        throw std::runtime_error(reason);
      }
    }

    ~Lock()
    {
      std::error_code ignored;
      fs::remove(path, ignored);
      close(descriptor);
    }

    Lock(const Lock &)            = delete;
    Lock &operator=(const Lock &) = delete;

  private:
    const fs::path path;
    int            descriptor = -1;

    /** Whether the locked file still has its name: another process may have removed it. */
    bool is_in_place() const
    {
      struct stat by_name, locked;
      return stat(path.c_str(), &by_name) == 0 && fstat(descriptor, &locked) == 0 &&
             by_name.st_ino == locked.st_ino;
    }

    /** Whether the process in the file may be running: what counts if files can't be locked. */
    bool is_alive() const
    {
      std::istringstream words(read_whole_file(path));
      std::string        word, host;
      pid_t              process = 0;
      words >> word >> process >> word >> host;
      return !host.empty() &&
             (host != Utilities::System::get_hostname() || kill(process, 0) == 0 || errno == EPERM);
    }
  };

  /** The file `manifest.txt`. */
  class OutputFolder::Manifest
  {
  public:
    /** Reads it, if it is there. */
    explicit Manifest(const fs::path &folder)
        : path(folder / manifest_name)
    {
      if (!fs::exists(path))
        return;
      std::istringstream lines(read_whole_file(path));
      std::string        line;
      std::getline(lines, line);
      if (line.rfind(manifest_title, 0) == 0)
        for (const Progress known : {Progress::unfinished, Progress::failed, Progress::finished})
          if (line.substr(manifest_title.size()) == get_word(known) + ".")
            progress = known;
      while (std::getline(lines, line))
        if (is_inside(line))
          names.insert(line);
    }

    void add(const std::string &name)
    {
      if (names.insert(name).second)
        append_to_file(path, name + "\n");
    }

    void set_progress(const Progress now)
    {
      progress         = now;
      std::string text = manifest_title + get_word(now) + ".\n";
      for (const std::string &name : names)
        text += name + "\n";
      replace_file(path, text);
    }

    Progress get_progress() const
    {
      return progress;
    }

    const std::set<std::string> &get_names() const
    {
      return names;
    }

  private:
    const fs::path        path;
    Progress              progress = Progress::none;
    std::set<std::string> names;

    /** Whoever edits the list can't have files removed elsewhere. */
    static bool is_inside(const std::string &name)
    {
      const fs::path relative = fs::path(name).lexically_normal();
      return !name.empty() && relative.is_relative() && *relative.begin() != "..";
    }
  };

  OutputFolder::OutputFolder(const std::string &path, const MPI_Comm communicator,
                             const Start start, const ExistingResults existing)
      : folder(path)
      , communicator(communicator)
  {
    run_on_root(communicator, [&]() {
      AssertThrow(!folder.empty(), ExcMessage("Output/Folder: the name is empty. Give a folder."));
      const std::string reason = catch_file_error([&]() { prepare(start, existing); });
      AssertThrow(
          reason.empty(),
          ExcMessage("Output/Folder: <" + folder + "> can't take the results: " + reason +
                     (reason.back() == '.' ? ""
                      : start == Start::fresh
                          ? ". Give a folder that is new or empty and that you may write to."
                          : ". Give the folder of the run.")));
    });
  }

  OutputFolder::~OutputFolder() = default;

  void OutputFolder::prepare(const Start start, const ExistingResults existing)
  {
    if (fs::exists(folder) && !fs::is_directory(folder))
      throw std::runtime_error("there is a file of this name");
    if (start == Start::resume && find_progress(folder) == Progress::none)
      throw std::runtime_error("it holds no run of Caudal to resume");
    fs::create_directories(folder);
    lock                    = std::make_unique<Lock>(folder);
    const Progress progress = find_progress(folder);
    if (start == Start::fresh && progress == Progress::none && has_foreign_files(folder))
      throw std::runtime_error("it is not empty and was not written by this version of Caudal");
    if (start == Start::fresh && progress != Progress::none)
      make_room(progress, existing);
    manifest = std::make_unique<Manifest>(folder);
    manifest->set_progress(start == Start::resume ? progress : Progress::unfinished);
  }

  /** Removes what an earlier run has written, or moves it out of the way, or refuses to. */
  void OutputFolder::make_room(const Progress progress, const ExistingResults existing)
  {
    const bool        can_be_resumed = progress == Progress::unfinished && has_checkpoints(folder);
    const fs::path    name           = get_base(folder);
    const fs::path    place          = fs::is_symlink(name) ? fs::canonical(name) : name;
    const fs::path    kept           = find_free_name(place);
    const std::string replace        = "by Output/Existing results = replace, which removes it";
    if (can_be_resumed && existing != ExistingResults::replace)
      throw std::runtime_error("it holds an unfinished run. Go on with it by " + get_command() +
                               " --resume " + folder + ", or start afresh " + replace + ".");
    if (existing == ExistingResults::refuse)
      throw std::runtime_error("it holds an earlier run. Start afresh " + replace +
                               ", or = number, which keeps it as " + kept.string() + ".");
    if (existing == ExistingResults::number)
    {
      if (fs::equivalent(place, fs::current_path()))
        throw std::runtime_error("it is the working directory, which can't be kept as another one. "
                                 "Give a folder of its own, or start afresh " +
                                 replace + ".");
      fs::rename(place, kept);
      fs::create_directories(place);
      lock.reset();
      lock = std::make_unique<Lock>(folder);
      fs::remove(kept / lock_name);
      kept_results = kept.string();
      return;
    }
    const Manifest earlier(folder);
    for (const std::string &name : earlier.get_names())
      fs::remove(fs::path(folder) / name);
    fs::remove(fs::path(folder) / manifest_name);
    remove_checkpoints(folder);
    std::error_code ignored; // folders with files of somebody else stay
    for (const char *name : {"fields", "plots"})
      fs::remove(fs::path(folder) / name, ignored);
  }

  std::string OutputFolder::path(const std::string &name) const
  {
    return name.empty() ? folder : (fs::path(folder) / name).string();
  }

  std::string OutputFolder::add(const std::string &name) const
  {
    if (manifest)
      manifest->add(name);
    return path(name);
  }

  std::string OutputFolder::add_table(const std::string &name) const
  {
    tables.insert(name);
    return add(name);
  }

  void OutputFolder::write_parameters(const std::string &text) const
  {
    parameters = parameters_title + "\n" + text;
    run_on_root(communicator, [&]() { replace_file(add("parameters.prm"), parameters); });
  }

  Outcome OutputFolder::record(const std::function<Outcome()> &run) const
  {
    run_on_root(communicator, [&]() { manifest->set_progress(Progress::unfinished); });
    Outcome outcome;
    try
    {
      outcome = run();
    }
    catch (...)
    {
      // Not collective: it may be one rank that fails. The run's own error is the one to tell.
      if (manifest)
        catch_file_error([&]() {
          manifest->set_progress(Progress::failed);
          write_csv_tables();
        });
      throw;
    }
    run_on_root(communicator, [&]() {
      write_csv_tables();
      if (outcome == Outcome::finished)
        manifest->set_progress(Progress::finished);
    });
    return outcome;
  }

  void OutputFolder::write_csv_tables() const
  {
    for (const std::string &table : tables)
      write_csv(path(table), add(fs::path(table).replace_extension(".csv")));
  }

  void OutputFolder::synchronise() const
  {
    // Fields are on the disk as soon as they are written, but for their names.
    for (const std::string &name : manifest->get_names())
      if (fs::path(name).parent_path() != "fields" && fs::exists(path(name)))
        caudal::synchronise(path(name));
    for (const std::string &name :
         {std::string(manifest_name), std::string("fields"), std::string()})
      if (fs::exists(path(name)))
        caudal::synchronise(path(name));
  }

  OutputFolder::Progress OutputFolder::find_progress(const std::string &path)
  {
    // Checkpoints are worth more than the list of what was written, which may be lost.
    const Progress progress = Manifest(path).get_progress();
    return progress == Progress::none && has_checkpoints(path) ? Progress::unfinished : progress;
  }
} // namespace caudal
