// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/statistics.h>

#include <caudal/io/safe_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iterator>
#include <sstream>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const unsigned int n_digits = 10;
  }

  Statistics::Statistics(const std::string &name, const double kept_time)
      : file_name(name)
  {
    const std::string rows = kept_time < 0 ? "" : read_rows(kept_time);
    has_rows               = !headers.empty();
    if (file_name.empty())
      return;
    // A file that is kept stays whole whenever the program ends.
    if (!rows.empty())
      replace_file(file_name, rows);
    file.open(file_name, rows.empty() ? std::ios::trunc : std::ios::app);
    file << std::flush;
    AssertThrow(file, ExcMessage("The statistics file <" + file_name + "> can't be written."));
  }

  std::string Statistics::read_rows(const double time)
  {
    // A row counts as one up to the time even if its ten digits round it up. The last
    // row may have been cut off.
    const double  latest = time + 1e-9 * std::abs(time);
    std::ifstream old(file_name);
    std::string   rows;
    for (std::string line; std::getline(old, line) && !old.eof();)
    {
      if (line.rfind("# ", 0) == 0 && line.find(": ") != std::string::npos)
        headers.push_back(line.substr(line.find(": ") + 2));
      else
      {
        std::istringstream        text(line);
        const std::vector<double> numbers{std::istream_iterator<double>(text), {}};
        if (numbers.size() != headers.size() || numbers.empty() || !(numbers[0] <= latest))
          break;
      }
      rows += line + "\n";
    }
    return rows;
  }

  void Statistics::set(const std::string &name, const std::string &unit, const double value)
  {
    if (!std::isfinite(value))
    {
      std::ostringstream message;
      message << "The statistics' column <" << name << "> is " << value;
      if (!row.empty())
        message << " at " << headers[0] << " = " << row[0];
      message << ". The solution broke down at or before this time.";
      AssertThrow(false, ExcMessage(message.str()));
    }

    const std::string header   = name + " [" + unit + "]";
    const bool        is_right = has_rows
                                     ? row.size() < headers.size() && headers[row.size()] == header
                                     : std::find(headers.begin(), headers.end(), header) == headers.end();
    AssertThrow(is_right, ExcColumn(header));
    if (!has_rows)
      headers.push_back(header);
    row.push_back(value);
  }

  void Statistics::write_row()
  {
    AssertThrow(row.size() == headers.size(), ExcColumn(headers[row.size()]));
    if (file.is_open())
    {
      for (std::size_t i = 0; i < headers.size() && !has_rows; ++i)
        file << "# " << i + 1 << ": " << headers[i] << '\n';
      for (const double value : row)
        file << std::setw(n_digits + 8) << std::scientific << std::setprecision(n_digits - 1)
             << value;
      file << std::endl;
      // A file that was removed still takes rows, which nobody will see.
      AssertThrow(std::filesystem::exists(file_name),
                  ExcMessage("The statistics file <" + file_name +
                             "> is gone: it was removed, or its folder, while the run wrote to "
                             "it. Go on by caudal --resume if a checkpoint is left, or start the "
                             "run anew."));
      AssertThrow(file, ExcMessage("The statistics file <" + file_name +
                                   "> can't be written any more. Is the disk full?"));
    }
    row.clear();
    has_rows = true;
  }
} // namespace caudal
