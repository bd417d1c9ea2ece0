// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/progress.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace caudal
{
  bool is_terminal()
  {
    return isatty(STDOUT_FILENO) == 1 && isatty(STDERR_FILENO) == 1;
  }

  std::string format_duration(const double seconds)
  {
    const long         total = std::lround(seconds);
    std::ostringstream text;
    text << std::setfill('0');
    if (total >= 3600)
      text << total / 3600 << ':' << std::setw(2);
    text << total / 60 % 60 << ':' << std::setw(2) << total % 60;
    return text.str();
  }

  Progress::Progress(std::ostream &out, const double start_time, const double end_time,
                     const bool is_terminal)
      : out(out)
      , start_time(start_time)
      , end_time(end_time)
      , rewrites_line(is_terminal)
  {}

  void Progress::update(const double time, const unsigned int step, const std::string &details)
  {
    ++n_steps;
    const double fraction  = (time - start_time) / (end_time - start_time);
    const double elapsed   = clock.wall_time();
    const double remaining = fraction > 0 ? elapsed * std::max(0., 1 / fraction - 1) : 0;

    std::ostringstream line;
    line << "t = " << std::fixed << std::setprecision(4) << time << " of " << std::setprecision(2)
         << end_time << " s  " << std::setw(5) << std::setprecision(1) << 100 * time / end_time
         << " %  step " << step << "  " << std::setprecision(2) << n_steps / std::max(elapsed, 1e-9)
         << " steps/s  " << format_duration(remaining) << " left" << (details.empty() ? "" : "  ")
         << details;
    last_line = line.str();

    const double silence = elapsed - last_print;
    const bool   is_due =
        rewrites_line ? silence > 0.25 : (fraction - last_fraction > 0.05 || silence > 300);
    if (!is_due)
      return;
    last_fraction = fraction;
    last_print    = elapsed;
    // The cursor is left at the start of the line, so that whatever is written next replaces it.
    if (rewrites_line)
      out << "\033[K" << last_line << '\r' << std::flush;
    else
      finish();
  }

  void Progress::finish()
  {
    if (!last_line.empty())
      out << (rewrites_line ? "\033[K" : "") << last_line << std::endl;
    last_line.clear();
  }
} // namespace caudal
