#include <caudal/base/collective.h>
#include <caudal/io/output_folder.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

using namespace dealii;

namespace caudal
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::string signature = "# Parameters of a run of Caudal";

    bool belongs_to_caudal(const fs::path &folder)
    {
      std::ifstream file(folder / "parameters.prm");
      std::string   line;
      return std::getline(file, line) && line == signature;
    }

    /** statistics.txt or statistics_<case>.txt, swim.txt or swim_<body>.txt and .json */
    bool is_table(const std::string &name)
    {
      const std::string stem = fs::path(name).stem().string(), ending = fs::path(name).extension();
      const auto        is_called = [&](const std::string &title) {
        return stem == title || stem.rfind(title + "_", 0) == 0;
      };
      return (ending == ".txt" && (is_called("statistics") || is_called("swim"))) ||
             (ending == ".json" && is_called("swim"));
    }

    /** Everything that Caudal, scripts/plot, report and paraview write, and nothing else. */
    void remove_results(const fs::path &folder)
    {
      const std::set<std::string> names   = {"log.txt",      "summary.txt", "summary.csv",
                                             "summary.json", "report.html", "view.py"};
      const std::set<std::string> endings = {".pvd", ".xdmf", ".vtu", ".h5", ".png"};

      const auto remove_files = [&](const fs::path &where) {
        std::set<fs::path> found;
        if (fs::is_directory(where))
          for (const auto &entry : fs::directory_iterator(where))
            if (!entry.is_directory() && (names.count(entry.path().filename().string()) > 0 ||
                                          is_table(entry.path().filename().string()) ||
                                          endings.count(entry.path().extension().string()) > 0))
              found.insert(entry.path());
        for (const auto &path : found)
          fs::remove(path);
      };
      remove_files(folder);
      remove_files(folder / "fields");
      remove_files(folder / "plots");
      fs::remove_all(folder / "restart");
    }

    /** Replaces the whole file or, if that fails, leaves the old one. */
    void write_file(const fs::path &path, const std::string &text)
    {
      const fs::path temporary = path.string() + ".tmp";
      std::ofstream  file(temporary);
      file << text;
      file.close();
      if (!file)
        throw std::runtime_error("writing a file into it failed");
      fs::rename(temporary, path);
    }

    void prepare(const fs::path &folder, const OutputFolder::Start start)
    {
      if (fs::exists(folder) && !fs::is_directory(folder))
        throw std::runtime_error("there is a file of this name");
      const bool ours = belongs_to_caudal(folder);
      if (!ours && start == OutputFolder::Start::resume)
        throw std::runtime_error("it holds no run of Caudal to resume");
      fs::create_directories(folder);
      if (!ours && !fs::is_empty(folder))
        throw std::runtime_error("it is not empty and was not written by Caudal");

      write_file(folder / "test", "Can this folder be written to?\n");
      fs::remove(folder / "test");
      if (start == OutputFolder::Start::fresh)
      {
        remove_results(folder);
        write_file(folder / "parameters.prm", signature + "\n");
      }
    }
  } // namespace

  OutputFolder::OutputFolder(const std::string &path, const MPI_Comm communicator,
                             const Start start)
      : folder(path)
      , communicator(communicator)
  {
    run_on_root(communicator, [&]() {
      AssertThrow(!folder.empty(), ExcMessage("Output/Folder: the name is empty. Give a folder."));
      std::string reason;
      try
      {
        prepare(folder, start);
      }
      catch (const fs::filesystem_error &exception)
      {
        reason = exception.code().message();
      }
      catch (const std::runtime_error &exception)
      {
        reason = exception.what();
      }
      AssertThrow(
          reason.empty(),
          ExcMessage("Output/Folder: <" + folder + "> can't take the results: " + reason +
                     (start == Start::fresh
                          ? ". Give a folder that is new or empty and that you may write to."
                          : ". Give the folder of the run.")));
    });
  }

  std::string OutputFolder::path(const std::string &name) const
  {
    return name.empty() ? folder : (std::filesystem::path(folder) / name).string();
  }

  void OutputFolder::write_parameters(const std::string &parameters) const
  {
    run_on_root(communicator,
                [&]() { write_file(path("parameters.prm"), signature + "\n" + parameters); });
  }
} // namespace caudal
