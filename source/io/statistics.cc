#include <caudal/io/statistics.h>

#include <caudal/io/safe_file.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <string_view>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const unsigned int n_digits = 10;
    const unsigned int width    = n_digits + 8;

    /** Scientific, n_digits; what a stream would print, in a third of its time. */
    void print(std::ostream &out, const double value)
    {
      char        text[2 * width];
      const auto *end = std::to_chars(text, text + sizeof text, value,
                                      std::chars_format::scientific, n_digits - 1)
                            .ptr;
      out << std::setw(width) << std::string_view(text, end - text);
    }
  } // namespace

  Statistics::Statistics(const std::string &file, const double kept_time)
      : file_name(file)
  {
    open(kept_time < 0 ? "" : read_rows(kept_time));
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
        columns.push_back({line.substr(line.find(": ") + 2), 0., false});
      else
      {
        std::istringstream        numbers(line);
        const std::vector<double> row{std::istream_iterator<double>(numbers), {}};
        if (row.size() != columns.size() || row.empty() || !(row[0] <= latest))
          break;
      }
      rows += line + "\n";
    }
    columns_are_fixed = !columns.empty();
    return rows;
  }

  void Statistics::open(const std::string &text)
  {
    if (file_name.empty())
      return;
    // A file that is kept stays whole whenever the program ends.
    if (!text.empty())
      replace_file(file_name, text);
    file.open(file_name, text.empty() ? std::ios::trunc : std::ios::app);
    file << std::flush;
    AssertThrow(file, ExcMessage("The statistics file <" + file_name + "> can't be written."));
  }

  void Statistics::set(const std::string &name, const std::string &unit, const double value)
  {
    if (!std::isfinite(value))
    {
      std::ostringstream message;
      message << "The statistics' column <" << name << "> is " << value;
      if (!columns.empty() && columns[0].is_set)
        message << " at " << columns[0].header << " = " << columns[0].value;
      message << ". The solution broke down at or before this time.";
      AssertThrow(false, ExcMessage(message.str()));
    }

    const std::string header     = name + " [" + unit + "]";
    const auto        has_header = [&](const Column &column) { return column.header == header; };
    if (!columns_are_fixed)
    {
      AssertThrow(std::none_of(columns.begin(), columns.end(), has_header), ExcColumn(header));
      columns.push_back({header, value, true});
      return;
    }

    // Quantities are set in the same order in all rows, or nearly so.
    auto column = columns.begin() + (next < columns.size() ? next : 0);
    if (!has_header(*column))
      column = std::find_if(columns.begin(), columns.end(), has_header);
    AssertThrow(column != columns.end() && !column->is_set, ExcColumn(header));
    column->value  = value;
    column->is_set = true;
    next           = column - columns.begin() + 1;
  }

  void Statistics::write_row()
  {
    for (const Column &column : columns)
      AssertThrow(column.is_set, ExcColumn(column.header));
    if (!columns_are_fixed)
      write_headers();

    for (Column &column : columns)
    {
      if (file.is_open())
        print(file, column.value);
      column.is_set = false;
    }
    next = 0;
    if (file.is_open())
    {
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
  }

  void Statistics::write_headers()
  {
    columns_are_fixed = true;
    for (std::size_t i = 0; i < columns.size() && file.is_open(); ++i)
      file << "# " << i + 1 << ": " << columns[i].header << '\n';
  }
} // namespace caudal
