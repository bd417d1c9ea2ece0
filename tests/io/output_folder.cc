// SPDX-License-Identifier: LGPL-2.1-or-later
// Which folders are taken for the results, which are refused and what is removed.

#include <caudal/io/output_folder.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>

using namespace caudal;

namespace fs = std::filesystem;

namespace
{
  unsigned int rank;

  void open(const std::string &folder, const OutputFolder::Start start = OutputFolder::Start::fresh)
  {
    std::ostringstream result;
    try
    {
      OutputFolder output(folder, MPI_COMM_WORLD, start);
      output.write_parameters("set Scheme = explicit\n");
      result << "  taken: " << output.path("log.txt") << '\n';
    }
    catch (dealii::ExceptionBase &exception)
    {
      exception.print_info(result);
    }
    // Each rank has to come to the same end.
    for (const auto &text : dealii::Utilities::MPI::gather(MPI_COMM_WORLD, result.str()))
      std::cout << text;
  }

  void on_root(const std::function<void()> &action)
  {
    if (rank == 0)
      action();
    MPI_Barrier(MPI_COMM_WORLD);
  }

  void print_files(const std::string &folder)
  {
    on_root([&]() {
      std::set<std::string> files;
      for (const auto &entry : fs::recursive_directory_iterator(folder))
        files.insert(entry.path().string());
      for (const auto &file : files)
        std::cout << "  " << file << '\n';
    });
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  rank             = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const auto title = [&](const std::string &text) {
    on_root([&]() { std::cout << text << ":\n"; });
  };

  on_root([]() { fs::remove_all("results"); });
  title("New folder with parents");
  open("results/fish");
  print_files("results");

  on_root([]() {
    fs::create_directories("results/fish/fields");
    fs::create_directories("results/fish/restart");
    for (const auto &name :
         {"log.txt", "notes.txt", "swimmers.txt", "swim.json", "swim_left.txt", "report.html",
          "view.py", "solution.pvd", "fields/fluid-00000.vtu", "fields/mine.txt", "restart/state"})
      std::ofstream("results/fish/" + std::string(name)) << "old\n";
  });
  title("Resumed: everything stays");
  open("results/fish", OutputFolder::Start::resume);
  print_files("results");
  title("A fresh run: only results are removed");
  open("results/fish");
  print_files("results");

  on_root([]() {
    fs::create_directory("results/foreign");
    std::ofstream("results/foreign/parameters.prm") << "set Something = else\n";
    std::ofstream("results/file") << "text\n";
  });
  title("A folder with other files");
  open("results/foreign");
  title("A file");
  open("results/file");
  title("Inside a file");
  open("results/file/folder");
  title("A place where nobody may write");
  open("/proc/caudal");
  title("Without a name");
  open("");
  title("Nothing to resume");
  open("results/new", OutputFolder::Start::resume);
  print_files("results");
}
