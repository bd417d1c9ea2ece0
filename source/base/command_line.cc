// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/command_line.h>
#include <caudal/base/version.h>

#include <deal.II/base/exceptions.h>

#include <cstdlib>

namespace caudal
{
  namespace
  {
    const std::string remedy = " <caudal --help> shows what is possible.";

    void choose(CommandLine &line, const CommandLine::Action action)
    {
      AssertThrow(
          line.action == CommandLine::Action::run || line.action == action,
          dealii::ExcMessage(
              "Of --resume, --resume-or-start, --verify-restart, --check, --help, --version "
              "and --print-parameters only one can be given." +
              remedy));
      line.action = action;
    }
  } // namespace

  CommandLine parse_command_line(const int argc, const char *const *const argv)
  {
    using Action = CommandLine::Action;
    using dealii::ExcMessage;

    const std::vector<std::string> arguments(argv + 1, argv + argc);
    CommandLine                    line;

    for (auto argument = arguments.begin(); argument != arguments.end(); ++argument)
    {
      const bool        is_last = argument + 1 == arguments.end();
      const std::string next    = is_last ? "" : *(argument + 1);

      if (*argument == "--help" || *argument == "-h")
        choose(line, Action::help);
      else if (*argument == "--version")
        choose(line, Action::version);
      else if (*argument == "--check")
        choose(line, Action::check);
      else if (*argument == "--fast")
        line.fast = true;
      else if (*argument == "--verify-restart")
        choose(line, Action::verify_restart);
      else if (*argument == "--resume-or-start")
        choose(line, Action::resume_or_start);
      else if (*argument == "--resume")
      {
        choose(line, Action::resume);
        AssertThrow(!is_last && next[0] != '-',
                    ExcMessage("--resume is not followed by the folder of a run." + remedy));
        line.folder = *++argument;
      }
      else if (*argument == "--print-parameters")
      {
        choose(line, Action::print_parameters);
        if (next == "prm" || next == "md")
          line.format = *++argument;
      }
      else if (argument->compare(0, 2, "-D") == 0)
      {
        const bool is_attached = argument->size() > 2;
        AssertThrow(is_attached || !is_last,
                    ExcMessage("-D is not followed by <Section/Entry=value>." + remedy));
        line.overrides.push_back(is_attached ? argument->substr(2) : *++argument);
      }
      else
      {
        AssertThrow(argument->empty() || argument->front() != '-',
                    ExcMessage("The option <" + *argument + "> is unknown." + remedy));
        AssertThrow(line.file.empty(), ExcMessage("There are two parameter files, <" + line.file +
                                                  "> and <" + *argument + ">. Give one." + remedy));
        line.file = *argument;
      }
    }

    AssertThrow(line.action != Action::resume || line.file.empty(),
                ExcMessage("--resume takes its parameters from the folder of the run; the file <" +
                           line.file + "> is not needed. Change single ones by -D." + remedy));
    AssertThrow(!line.fast || line.action == Action::check,
                ExcMessage("--fast makes --check faster, which is not given." + remedy));
    const bool needs_file = line.action == Action::run || line.action == Action::check ||
                            line.action == Action::verify_restart ||
                            line.action == Action::resume_or_start;
    AssertThrow(!needs_file || !line.file.empty(),
                ExcMessage("There is no parameter file on the command line." + remedy));
    return line;
  }

  std::string get_help()
  {
    return get_version() +
           ": self-propelled swimming by finite elements and immersed boundaries.\n"
           "\n"
           "  caudal file.prm             run the case\n"
           "  caudal --resume FOLDER      go on with the run whose results are in this folder, "
           "from\n"
           "                              its newest whole checkpoint\n"
           "  caudal --resume-or-start file.prm\n"
           "                              go on with the run of this case if there is a checkpoint "
           "of\n"
           "                              it, else start it: for batch scripts\n"
           "  caudal --check [--fast] file.prm\n"
           "                              check the case; show its size, how it is resolved, what "
           "it\n"
           "                              will cost (from four steps, not with --fast), and "
           "warnings\n"
           "  caudal --print-parameters [prm|md] [file.prm]\n"
           "                              show all parameters (those of the case) with their\n"
           "                              defaults, as a parameter file or as Markdown\n"
           "  caudal --verify-restart file.prm\n"
           "                              compare ten steps with five, a checkpoint and five "
           "more,\n"
           "                              bit by bit\n"
           "  caudal --version            show the version\n"
           "  caudal --help               show this\n"
           "\n"
           "  -D \"Section/Entry=value\"    set a parameter after reading the file; repeatable\n"
           "\n"
           "Several ranks: mpirun -np N caudal file.prm.\n"
           "Exit codes: 0 finished, 1 error, 2 stopped on request (SIGINT, SIGTERM, SIGHUP, "
           "SIGUSR1,\n"
           "SIGUSR2, SIGXCPU and the like) or by Checkpoint/Wall time limit, with a checkpoint to "
           "resume\n"
           "from. mpirun kills its ranks soon after a SIGTERM, but hands on SIGUSR1 and SIGUSR2: "
           "send it\n"
           "one of these.\n";
  }

  std::string get_command()
  {
    const char *const name = std::getenv("CAUDAL_COMMAND");
    return name != nullptr ? name : "caudal";
  }
} // namespace caudal
