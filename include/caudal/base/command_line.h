// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_command_line_h
#define caudal_base_command_line_h

#include <string>
#include <vector>

namespace caudal
{
  /** What the program was asked to do. */
  struct CommandLine
  {
    enum class Action
    {
      run,
      resume,
      resume_or_start,
      verify_restart,
      check,
      help,
      version,
      print_parameters
    };

    Action                   action = Action::run;
    std::string              file;           // empty if the action needs none
    std::string              folder;         // of the run to resume
    std::vector<std::string> overrides;      // "Section/Entry=value"
    std::string              format = "prm"; // of print_parameters: "prm" or "md"
    bool                     fast   = false; // of check: no trial steps
  };

  /** Throws a sentence for anything that is not described by get_help(). */
  CommandLine parse_command_line(int argc, const char *const *argv);

  /** How to call the program. */
  std::string get_help();

  /** What users call to run it: $CAUDAL_COMMAND, which scripts/swim sets, or caudal. */
  std::string get_command();
} // namespace caudal

#endif
