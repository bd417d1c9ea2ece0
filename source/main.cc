// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/model_run.h>
#include <caudal/app/verify_restart.h>
#include <caudal/base/collective.h>
#include <caudal/base/command_line.h>
#include <caudal/base/declared_parameters.h>
#include <caudal/base/version.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/solid/elastic_body.h>
#include <caudal/viscous/immersed_swimmer.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <iostream>
#include <malloc.h>
#include <thread>

namespace
{
  using namespace caudal;

  volatile std::sig_atomic_t stop_signal = 0;

  /** Exit codes. */
  enum Exit
  {
    finished = 0,
    failed   = 1,
    stopped  = 2
  };

  /**
   * SIGINT and SIGTERM, and SIGUSR1 as which scripts/swim forwards them through mpirun. A file
   * that exceeds its limit is an error like that of a full disk.
   */
  void catch_signals()
  {
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
      std::signal(signal, [](int) { stop_signal = 1; });
  }

  /**
   * Memory that was freed stays with the process: each step's factorisation asks for it again,
   * and to get it from the system page by page is a tenth of a step.
   */
  void keep_freed_memory()
  {
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
  }

  /**
   * Each rank has a core, for which the threads of a BLAS would compete: it uses one, unless the
   * environment says otherwise. It has read the environment when it was loaded, so that it has to
   * be told by its own function, which only that library has.
   */
  void use_one_blas_thread()
  {
    if (std::getenv("OPENBLAS_NUM_THREADS") || std::getenv("MKL_NUM_THREADS") ||
        std::getenv("OMP_NUM_THREADS"))
      return;
    for (const char *name : {"openblas_set_num_threads", "MKL_Set_Num_Threads"})
      if (void *function = dlsym(RTLD_DEFAULT, name))
        reinterpret_cast<void (*)(int)>(function)(1);
  }

  /** All ranks stop if one has got the signal. */
  bool stop_requested()
  {
    return Utilities::MPI::max(static_cast<int>(stop_signal), MPI_COMM_WORLD) > 0;
  }

  /**
   * Rank 0 speaks for all. An error that only some other ranks have met would
   * leave rank 0 waiting for them: then they speak and end the run.
   */
  void report_error(const std::string &error)
  {
    const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (!is_root)
      std::this_thread::sleep_for(std::chrono::seconds(2));
    std::cerr << "Error: " << error << std::endl;
    if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      MPI_Abort(MPI_COMM_WORLD, failed);
  }

  /** Prints rank 0's text. */
  void print(const std::string &text)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << text << std::flush;
  }

  Exit get_exit(const Outcome outcome)
  {
    return outcome == Outcome::finished ? finished : stopped;
  }

  /** Runs, resumes, checks or verifies a case of a model with checkpoints. */
  template <class Swimmer>
  Exit run_model(ParameterFile &file, const CommandLine &command_line)
  {
    file.rename(Swimmer::Parameters::get_renamed_entries());
    using Action                  = CommandLine::Action;
    const unsigned int n_verified = 10; // steps
    if (command_line.action == Action::verify_restart)
    {
      print(verify_restart<Swimmer>(file, n_verified, MPI_COMM_WORLD) + "\n");
      return finished;
    }
    const ModelRun<Swimmer> run(file, MPI_COMM_WORLD);
    if (command_line.action == Action::check)
    {
      std::ostringstream summary;
      run.check(summary, command_line.fast);
      print(summary.str());
      return finished;
    }
    return get_exit(command_line.action == Action::resume ? run.resume(stop_requested)
                                                          : run.start(stop_requested));
  }

  template <int dim>
  Exit run_elastic(ParameterFile &file, const CommandLine &command_line)
  {
    file.rename(BodyGridParameters<dim>::get_renamed_entries());
    using Action = CommandLine::Action;
    ElasticParameters<dim> parameters(&file);
    AssertThrow(command_line.action != Action::resume &&
                    command_line.action != Action::verify_restart,
                ExcMessage("Model: runs of the model " + parameters.model +
                           " write no checkpoints. Start the run anew."));
    ParameterHandler prm;
    FigureParameters figures;
    parameters.declare(prm);
    figures.add_parameters(prm);
    file.parse(prm);
    parameters.check();
    figures.check();
    const std::vector<std::string> remarks = file.get_remarks(prm);

    // What can be wrong with the case is found before anything is written.
    ElasticBody<dim> body(parameters, MPI_COMM_WORLD);
    if (command_line.action == Action::check)
    {
      std::ostringstream summary;
      for (const std::string &remark : remarks)
        summary << remark << '\n';
      body.print_summary(summary);
      print(summary.str() + "No problems found.\n");
      return finished;
    }
    const OutputFolder folder(parameters.output.folder, MPI_COMM_WORLD);
    std::ostringstream used_parameters;
    prm.print_parameters(used_parameters, ParameterHandler::PRM);
    folder.write_parameters(used_parameters.str());
    Log log(folder.path("log.txt"), MPI_COMM_WORLD);
    if (figures.are_printed())
      log.keep_from_terminal(figures.with_warnings);
    log.print_banner();
    for (const std::string &remark : remarks)
      log << remark << std::endl;
    for (const std::string &override_text : file.get_overrides())
      log << "Override: " << override_text << std::endl;
    const Outcome outcome = body.run(folder, log, stop_requested);
    if (outcome == Outcome::finished)
      print_figures(figures, parameters.output.folder, MPI_COMM_WORLD);
    return get_exit(outcome);
  }

  /** The parameters of the run in a folder of results, with overrides. */
  std::unique_ptr<ParameterFile> read_parameters_of_run(const CommandLine &command_line)
  {
    const std::string name = command_line.folder + "/parameters.prm";
    AssertThrow(std::ifstream(name),
                ExcMessage("The folder <" + command_line.folder +
                           "> holds no run of Caudal: there is no parameters.prm. Give the folder "
                           "of a run's results."));
    std::vector<std::string> overrides = command_line.overrides;
    overrides.push_back("Output/Folder=" + command_line.folder);
    return std::make_unique<ParameterFile>(name, overrides);
  }

  template <class Parameters>
  Exit print_model_parameters(Parameters &&parameters, const std::string &format)
  {
    ParameterHandler prm;
    parameters.declare(prm);
    FigureParameters().add_parameters(prm);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      print_parameters(std::cout, prm, format);
    return finished;
  }

  Exit run(const int argc, char **argv)
  {
    const CommandLine command_line = parse_command_line(argc, argv);
    const bool        is_root      = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (command_line.action == CommandLine::Action::help)
    {
      if (is_root)
        std::cout << get_help();
      return finished;
    }
    if (command_line.action == CommandLine::Action::version)
    {
      if (is_root)
        std::cout << get_version() << std::endl;
      return finished;
    }
    std::unique_ptr<ParameterFile> file;
    if (command_line.action == CommandLine::Action::resume)
      file = read_parameters_of_run(command_line);
    else if (!command_line.file.empty())
      file = std::make_unique<ParameterFile>(command_line.file, command_line.overrides);
    load_libraries(file ? file->get("Libraries", "") : "");
    const std::string model = file ? get_model(*file) : "immersed";
    if (command_line.action == CommandLine::Action::print_parameters)
      return model == "potential"
                 ? print_model_parameters(IdealParameters(nullptr), command_line.format)
             : model == "elastic"
                 ? print_model_parameters(ElasticParameters<2>(file.get()), command_line.format)
                 : print_model_parameters(RunParameters<2>(file.get()), command_line.format);
    if (model == "potential")
      return run_model<IdealSwimmer>(*file, command_line);
    const bool is_plane = get_dimension(*file) == 2;
    if (model == "elastic")
      return is_plane ? run_elastic<2>(*file, command_line) : run_elastic<3>(*file, command_line);
    return is_plane ? run_model<ImmersedSwimmer<2>>(*file, command_line)
                    : run_model<ImmersedSwimmer<3>>(*file, command_line);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  catch_signals();
  keep_freed_memory();
  use_one_blas_thread();
  Exit              exit  = failed;
  const std::string error = catch_error([&]() { exit = run(argc, argv); });
  if (!error.empty())
    report_error(error);
  return exit;
}
