// SPDX-License-Identifier: LGPL-2.1-or-later
// What the program does before its libraries are initialised: OpenBLAS asks for memory then, and
// asks for ever if it gets none, deaf to signals.
#include <sys/resource.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#ifdef __GLIBC__
namespace
{
  /** What a small run takes beside the program's own text [bytes]. */
  constexpr rlim_t least_free = 512 * 1024 * 1024;

  /** The address space that is taken [bytes]; 0 if the system does not tell. */
  rlim_t get_used_address_space()
  {
    char      text[32] = "";
    const int file     = open("/proc/self/statm", O_RDONLY | O_CLOEXEC); // in pages
    if (file < 0 || read(file, text, sizeof(text) - 1) < 0)
      return 0;
    close(file);
    return std::strtoul(text, nullptr, 10) * sysconf(_SC_PAGESIZE);
  }

  void check_address_space(int, char **, char **)
  {
    constexpr char message[] =
        "Error: the limit of virtual memory (ulimit -v) leaves less than 0.5 GiB to the program. "
        "Raise it, or limit the memory by the batch system or a control group.\n";
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
        limit.rlim_cur >= get_used_address_space() + least_free)
      return;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, sizeof(message) - 1);
    _exit(1);
  }

  // The linker runs the functions of this section first.
  __attribute__((section(".preinit_array"), used)) void (*first)(int, char **,
                                                                 char **) = check_address_space;
} // namespace
#endif
