// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/statistics.h>

#include <caudal/base/safe_file.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const unsigned int n_digits = 10;

    /** As a stream prints it, scientific and right-aligned, in a seventh of its time. */
    std::string print(const double value)
    {
      char              digits[32];
      const std::size_t size = std::to_chars(digits, std::end(digits), value,
                                             std::chars_format::scientific, n_digits - 1)
                                   .ptr -
                               digits;
      return std::string(n_digits + 8 - size, ' ').append(digits, size);
    }
  } // namespace

  void write_csv(const std::string &table, const std::string &csv)
  {
    std::istringstream lines(read_whole_file(table));
    std::string        header, rows;
    for (std::string line; std::getline(lines, line);)
      if (line.rfind("# ", 0) == 0)
        header += (header.empty() ? "" : ",") + line.substr(line.find(": ") + 2);
      else
      {
        std::istringstream words(line);
        const char        *separator = "";
        for (std::string word; words >> word; separator = ",")
          rows += separator + word;
        rows += '\n';
      }
    replace_file(csv, header + "\n" + rows);
  }

  Statistics::Statistics(const std::string &name, const double kept_time)
      : file_name(name)
  {
    const std::string rows = kept_time < 0 ? "" : read_rows(kept_time);
    has_rows               = !headers.empty();
    old_headers            = headers;
    if (file_name.empty())
      return;
    // A file that is kept stays whole whenever the program ends.
    if (!rows.empty())
      replace_file(file_name, rows);
    size = rows.size();
    if (rows.empty())
      std::ofstream(file_name, std::ios::trunc);
    // At the end of the file: if somebody else empties it, its size tells.
    file.open(file_name, std::ios::app);
    file << std::flush;
    AssertThrow(file, ExcMessage("The statistics file <" + file_name + "> can't be written."));
  }

  std::string Statistics::read_rows(const double time)
  {
    std::string       text;
    const std::string reason = catch_file_error([&]() { text = read_whole_file(file_name); });
    if (!reason.empty() && !file_name.empty())
    {
      AssertThrow(
          !std::filesystem::exists(file_name),
          ExcMessage(reason + ". Its rows would be lost: see what is wrong with the disk."));
      damages.push_back("<" + file_name + "> is missing. A new table begins.");
    }
    text.erase(text.rfind('\n') + 1); // the last row may have been cut off

    // A row counts as one up to the time even if its ten digits round it up.
    const double       latest = time + 1e-9 * std::abs(time);
    std::istringstream old(text);
    std::string        rows;
    unsigned int       number = 0, n_damaged = 0, first_damaged = 0;
    for (std::string line; std::getline(old, line);)
    {
      ++number;
      if (line.rfind("# ", 0) == 0 && line.find(": ") != std::string::npos)
        headers.push_back(line.substr(line.find(": ") + 2));
      else
      {
        std::istringstream        words(line);
        const std::vector<double> numbers{std::istream_iterator<double>(words), {}};
        if (numbers.size() != headers.size() || numbers.empty())
        {
          if (n_damaged++ == 0)
            first_damaged = number;
          continue;
        }
        if (!(numbers[0] <= latest))
          continue;
        last_time = numbers[0];
      }
      rows += line + "\n";
    }
    if (n_damaged > 0)
    {
      damaged_file = find_earlier_name();
      std::filesystem::copy_file(file_name, damaged_file);
      damages.push_back("<" + file_name + ">: " + std::to_string(n_damaged) +
                        " of its lines can't be read as rows and were left out, the first one is " +
                        std::to_string(first_damaged) + ". The file as it was is kept as <" +
                        damaged_file + ">.");
    }
    return rows;
  }

  bool Statistics::has_row_at(const double time) const
  {
    return std::abs(last_time - time) <= 1e-9 * std::abs(time);
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

    const std::string header = name + " [" + unit + "]";
    if (!old_headers.empty() && has_rows &&
        (row.size() == headers.size() || headers[row.size()] != header))
    {
      has_rows = false; // other columns than before
      headers.resize(row.size());
    }
    const bool is_right = has_rows
                              ? row.size() < headers.size() && headers[row.size()] == header
                              : std::find(headers.begin(), headers.end(), header) == headers.end();
    AssertThrow(is_right, ExcColumn(header));
    if (!has_rows)
      headers.push_back(header);
    row.push_back(value);
  }

  std::string Statistics::find_earlier_name() const
  {
    const std::filesystem::path name(file_name);
    std::string                 result = file_name;
    for (unsigned int k = 1; std::filesystem::exists(result); ++k)
      result = (name.parent_path() / name.stem()).string() + "-" + std::to_string(k) +
               name.extension().string();
    return result;
  }

  void Statistics::begin_new_table()
  {
    has_rows = false;
    if (!file.is_open())
      return;
    earlier_file = find_earlier_name();
    file.close();
    std::filesystem::rename(file_name, earlier_file);
    file.open(file_name, std::ios::app);
    size = 0;
  }

  void Statistics::write_row()
  {
    if (!old_headers.empty() && row.size() < headers.size())
      headers.resize(row.size());
    AssertThrow(row.size() == headers.size(), ExcColumn(headers[row.size()]));
    if (!old_headers.empty() && headers != old_headers)
      begin_new_table();
    old_headers.clear();
    if (file.is_open())
    {
      std::ostringstream text;
      for (std::size_t i = 0; i < headers.size() && !has_rows; ++i)
        text << "# " << i + 1 << ": " << headers[i] << '\n';
      for (const double value : row)
        text << print(value);
      text << '\n';
      file << text.str() << std::flush;
      size += text.str().size();
      // A file that was removed still takes rows, which nobody will see.
      const std::string remedy = " while the run wrote to it. Go on by caudal --resume if a "
                                 "checkpoint is left, or start the run anew.";
      AssertThrow(std::filesystem::exists(file_name),
                  ExcMessage("The statistics file <" + file_name +
                             "> is gone: it was removed, or its folder," + remedy));
      AssertThrow(file, ExcMessage("The statistics file <" + file_name +
                                   "> can't be written any more. Is the disk full?"));
      AssertThrow(std::filesystem::file_size(file_name) == size,
                  ExcMessage("The statistics file <" + file_name +
                             "> was changed or replaced by somebody else" + remedy));
    }
    row.clear();
    has_rows = true;
  }
} // namespace caudal
