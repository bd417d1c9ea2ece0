// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/safe_file.h>

#include <fstream>
#include <regex>
#include <stdexcept>
#include <vector>

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

    /** Removes all that Caudal, scripts/plot, report and paraview write, and nothing else. */
    void remove_results(const fs::path &folder)
    {
      static const std::regex results(R"(log\.txt|summary\.(txt|csv|json)|report\.html|view\.py|)"
                                      R"((statistics|swim)(_.*)?\.txt|swim(_.*)?\.json|)"
                                      R"(.+\.(pvd|xdmf|vtu|h5|png))");
      for (const fs::path &where : {folder, folder / "fields", folder / "plots"})
      {
        std::vector<fs::path> found;
        if (fs::is_directory(where))
          for (const auto &entry : fs::directory_iterator(where))
            if (!entry.is_directory() &&
                std::regex_match(entry.path().filename().string(), results))
              found.push_back(entry.path());
        for (const fs::path &path : found)
          fs::remove(path);
      }
      fs::remove_all(folder / "restart");
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

      replace_file(folder / "test", "Can this folder be written to?\n");
      fs::remove(folder / "test");
      if (start == OutputFolder::Start::fresh)
      {
        remove_results(folder);
        replace_file(folder / "parameters.prm", signature + "\n");
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
      const std::string reason = catch_file_error([&]() { prepare(folder, start); });
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
                [&]() { replace_file(path("parameters.prm"), signature + "\n" + parameters); });
  }
} // namespace caudal
