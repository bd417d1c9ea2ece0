// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/case_name.h>
#include <caudal/app/model_run.h>
#include <caudal/app/verify_restart.h>
#include <caudal/base/collective.h>
#include <caudal/base/command_line.h>
#include <caudal/base/declared_parameters.h>
#include <caudal/base/parameter_text.h>
#include <caudal/base/safe_file.h>
#include <caudal/base/version.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/passage/fish_passage.h>
#include <caudal/solid/elastic_body.h>
#include <caudal/viscous/immersed_swimmer.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <malloc.h>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace
{
  using namespace caudal;

  volatile std::sig_atomic_t stop_signal = 0;
  bool                       is_root     = true; // for signal handlers, which can't ask MPI

  /** nohup asks for this. (Shells ask for it of SIGINT and all that runs behind them.) */
  bool ignores_hangup = false;

  /** Exit codes. */
  enum Exit
  {
    finished = 0,
    failed   = 1,
    stopped  = 2
  };

  /**
   * Lets @p handler answer to what users, terminals, shells and batch systems send to end a
   * program. scripts/swim sends SIGUSR1, which mpirun hands on.
   */
  void catch_signals(void (*handler)(int))
  {
    for (const int signal :
         {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE, SIGALRM})
      std::signal(signal, signal == SIGHUP && ignores_hangup ? SIG_IGN : handler);
  }

  /** The answer before the first step, while grids are built: there is nothing to save. */
  void stop_at_once(int)
  {
    constexpr char message[] =
        "Stopped on request before the first step; there is nothing to save.\n";
    if (is_root && write(STDERR_FILENO, message, sizeof(message) - 1) < 0)
      _exit(failed);
    _exit(stopped);
  }

  /** From then on the run finishes its step and writes a checkpoint. */
  void stop_after_step(int)
  {
    stop_signal = 1;
  }

  /**
   * A process that no launcher has started is alone. Open MPI starts a daemon beside it and looks
   * for networks all the same, which takes as long as all else in a short run, unless its
   * environment says that there will be nobody to talk to. All processes that are alone share a
   * folder for sessions, which one that ends removes when another is about to use it.
   */
  void tell_mpi_of_solitude()
  {
    for (const char *name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
      if (std::getenv(name))
        return;
    const bool overwrites = false; // what users have set
    setenv("OMPI_MCA_ess_singleton_isolated", "1", overwrites);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", overwrites);
    setenv("OMPI_MCA_pml", "ob1", overwrites);
    setenv("OMPI_MCA_btl", "self", overwrites);
    setenv("OMPI_MCA_sharedfp", "^sm", overwrites); // its files would be the daemon's
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

  /** All ranks stop if one has got the signal. The first call is that before the first step. */
  bool stop_requested()
  {
    static std::once_flag first_call;
    std::call_once(first_call, catch_signals, stop_after_step);
    return Utilities::MPI::max(static_cast<int>(stop_signal), MPI_COMM_WORLD) > 0;
  }

  /**
   * Rank 0 speaks for all. An error that only some other ranks have met would
   * leave rank 0 waiting for them: then they speak and end the run.
   */
  void report_error(const std::string &error)
  {
    if (!is_root)
      std::this_thread::sleep_for(std::chrono::seconds(2));
    std::cerr << "Error: " << error << std::endl;
    if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      MPI_Abort(MPI_COMM_WORLD, failed);
  }

  /** Prints rank 0's text. */
  void print(const std::string &text)
  {
    if (is_root)
      std::cout << text << std::flush;
  }

  Exit get_exit(const Outcome outcome)
  {
    return outcome == Outcome::finished ? finished : stopped;
  }

  template <class Model>
  constexpr bool writes_checkpoints = true;

  template <int dim>
  constexpr bool writes_checkpoints<ElasticBody<dim>> = false;

  template <>
  constexpr bool writes_checkpoints<FishPassage> = false;

  /** Runs, resumes, checks or verifies a case of a model. */
  template <class Model>
  Exit run_model(ParameterFile &file, const CommandLine &command_line)
  {
    file.rename(Model::Parameters::get_renamed_entries());
    using Action = CommandLine::Action;
    if constexpr (writes_checkpoints<Model>)
    {
      if (command_line.action == Action::verify_restart)
      {
        print(verify_restart<Model>(file, /*n_steps=*/10, MPI_COMM_WORLD) + "\n");
        return finished;
      }
      const ModelRun<Model> run(file, MPI_COMM_WORLD);
      if (command_line.action == Action::resume ||
          (command_line.action == Action::resume_or_start && run.can_be_resumed()))
        return get_exit(run.resume(stop_requested));
    }
    AssertThrow(command_line.action != Action::resume &&
                    command_line.action != Action::verify_restart,
                ExcMessage("Model: runs of the model " + file.get("Model", "") +
                           " write no checkpoints. Start the run anew."));
    const ModelRun<Model> run(file, MPI_COMM_WORLD);
    if (command_line.action != Action::check)
      return get_exit(run.start(stop_requested));
    std::ostringstream summary;
    run.check(summary, command_line.fast);
    print(summary.str());
    return finished;
  }

  /**
   * The parameters of the run in a folder of results, with overrides; those in the newest
   * checkpoint if the file is lost.
   */
  std::unique_ptr<ParameterFile> read_parameters_of_run(const CommandLine &command_line)
  {
    AssertThrow(OutputFolder::find_progress(command_line.folder) != OutputFolder::Progress::none,
                ExcMessage("The folder <" + command_line.folder +
                           "> holds no run of Caudal: there is no manifest.txt. Give the folder of "
                           "a run's results."));
    const std::string name = command_line.folder + "/parameters.prm";
    run_on_root(MPI_COMM_WORLD, [&]() {
      std::string       text;
      const std::string reason = catch_file_error([&]() { text = read_text_file(name); });
      if (reason.empty() && is_whole_parameter_file(text))
        return;
      const std::string newest = find_newest_parameters(command_line.folder);
      if (std::filesystem::exists(name))
        std::filesystem::rename(name, name + ".damaged");
      replace_file(name, newest);
      std::cerr << "Warning: <" << name
                << "> was missing or damaged; it is that of the newest checkpoint now.\n";
    });
    std::vector<std::string> overrides = command_line.overrides;
    overrides.push_back("Output/Folder=" + command_line.folder);
    return std::make_unique<ParameterFile>(name, overrides);
  }

  /** Prints the parameters of a model, with the bodies that @p file names; it may be null. */
  template <class Parameters>
  Exit print_model_parameters(const ParameterFile *file, const std::string &format)
  {
    ParameterHandler prm;
    Parameters(file).declare(prm);
    FigureParameters().add_parameters(prm);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      print_parameters(std::cout, prm, format);
    return finished;
  }

  template <template <int> class Model>
  Exit run_model_in_dimension(ParameterFile &file, const CommandLine &command_line)
  {
    return get_dimension(file) == 2 ? run_model<Model<2>>(file, command_line)
                                    : run_model<Model<3>>(file, command_line);
  }

  /** Those of the dimension that the file asks for, of the plane without a file. */
  template <template <int> class Parameters>
  Exit print_parameters_of_dimension(const ParameterFile *file, const std::string &format)
  {
    return file != nullptr && get_dimension(*file) == 3
               ? print_model_parameters<Parameters<3>>(file, format)
               : print_model_parameters<Parameters<2>>(file, format);
  }

  /** What the program can do with a model. */
  struct Model
  {
    const char *name; // in the entry Model
    Exit (*run)(ParameterFile &, const CommandLine &);
    Exit (*print_parameters)(const ParameterFile *, const std::string &format);
  };

  const Model models[] = {
      {"immersed", run_model_in_dimension<ImmersedSwimmer>,
       print_parameters_of_dimension<RunParameters>},
      {"potential", run_model<IdealSwimmer>,
       [](const ParameterFile *, const std::string &format) { // of a body without a name
         return print_model_parameters<IdealParameters>(nullptr, format);
       }},
      {"passage", run_model<FishPassage>, print_model_parameters<PassageParameters>},
      {"elastic", run_model_in_dimension<ElasticBody>,
       print_parameters_of_dimension<ElasticParameters>}};

  /** The model that @p file asks for; the first one without an entry or a file. */
  const Model &find_model(const ParameterFile *file)
  {
    if (file == nullptr)
      return models[0];
    const std::string name  = file->get("Model", models[0].name);
    const auto       *model = std::find_if(std::begin(models), std::end(models),
                                           [&](const Model &known) { return known.name == name; });
    AssertThrow(model != std::end(models),
                ExcMessage("Model: the value is <" + name +
                           ">. Give immersed, potential, passage or elastic."));
    return *model;
  }

  Exit run(const int argc, char **argv)
  {
    using Action                   = CommandLine::Action;
    const CommandLine command_line = parse_command_line(argc, argv);
    // What only prints ends quietly once its output is not read any more, by `head` for example.
    const bool only_prints =
        command_line.action == Action::help || command_line.action == Action::version ||
        command_line.action == Action::print_parameters || command_line.action == Action::check;
    if (only_prints)
      catch_signals(SIG_DFL);
    if (command_line.action == Action::help || command_line.action == Action::version)
    {
      print(command_line.action == Action::help ? get_help() : get_version() + "\n");
      return finished;
    }
    std::unique_ptr<ParameterFile> file;
    if (command_line.action == Action::resume)
      file = read_parameters_of_run(command_line);
    else if (!command_line.file.empty())
    {
      check_case_name(command_line.file);
      file = std::make_unique<ParameterFile>(command_line.file, command_line.overrides);
    }
    load_libraries(file ? file->get("Libraries", "") : "");
    const Model &model = find_model(file.get());
    return command_line.action == Action::print_parameters
               ? model.print_parameters(file.get(), command_line.format)
               : model.run(*file, command_line);
  }
} // namespace

int main(int argc, char **argv)
{
  ignores_hangup = std::signal(SIGHUP, SIG_IGN) == SIG_IGN; // MPI changes it
  tell_mpi_of_solitude();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // A file that exceeds its limit is an error like that of a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  is_root = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  catch_signals(stop_at_once);
  keep_freed_memory();
  use_one_blas_thread();
  Exit              exit  = failed;
  const std::string error = catch_error([&]() { exit = run(argc, argv); });
  if (!error.empty())
    report_error(error);
  return exit;
}
