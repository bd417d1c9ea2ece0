// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_io_progress_h
#define caudal_io_progress_h

#include <deal.II/base/timer.h>

#include <ostream>
#include <string>

namespace caudal
{
  /**
   * Whether a user sees the output on a terminal. Both the standard output and
   * the standard error are asked, since mpirun gives each rank a pseudo-terminal
   * for the former wherever its own output goes.
   */
  bool is_terminal();

  /** A duration as "1:02:03" (hours, minutes, seconds), or "2:03" below an hour. */
  std::string format_duration(double seconds);

  /**
   * Tells how far the run is: simulated time and its end, percent of that, steps a
   * second, and the remaining wall time, which assumes that simulated time goes
   * on as fast as it did so far. On a terminal one line is rewritten, four
   * times a second; elsewhere a plain line appears every five percent, or
   * after five minutes without one.
   */
  class Progress
  {
  public:
    /**
     * @p out is std::cout on a terminal, else also a log. Times in s;
     * @p start_time is the resumed time in a resumed run.
     */
    Progress(std::ostream &out, double start_time, double end_time, bool is_terminal);

    /** After each step; @p details is put at the end of the line. */
    void update(double time, unsigned int step, const std::string &details = "");

    /** Leaves the line; what is written next starts on a new one. */
    void finish();

  private:
    std::ostream       &out;
    const double        start_time;
    const double        end_time;
    const bool          rewrites_line;
    const dealii::Timer clock;

    unsigned int n_steps       = 0;
    double       last_fraction = 0; // of the simulated time, when last printed
    double       last_print    = 0; // [s] after the start
    std::string  last_line;         // what finish() has to leave behind
  };
} // namespace caudal

#endif
