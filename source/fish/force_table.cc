#include <caudal/fish/force_table.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace caudal
{
  namespace
  {
    /** The entries of a row; none if it is blank or a comment. */
    std::vector<std::string> split(std::string line)
    {
      line = line.substr(0, line.find('#'));
      if (line.find(',') != std::string::npos)
        return Utilities::split_string_list(line, ',');
      std::istringstream       stream(line);
      std::vector<std::string> fields;
      for (std::string field; stream >> field;)
        fields.push_back(field);
      return fields;
    }

    double to_number(const std::string &field, const std::string &place)
    {
      char        *end   = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      AssertThrow(!field.empty() && *end == '\0' && std::isfinite(value),
                  ExcMessage(place + "<" + field +
                             "> is not a finite number. Complete the row or remove it."));
      return value;
    }

    /** Where @p x lies in the increasing @p nodes: the right node and the weight of it. */
    std::pair<std::size_t, double> locate(const std::vector<double> &nodes, const double x)
    {
      const auto        above  = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
      const std::size_t right  = above - nodes.begin();
      const double      weight = (x - nodes[right - 1]) / (nodes[right] - nodes[right - 1]);
      return {right, std::min(1., std::max(0., weight))};
    }
  } // namespace

  ForceTable::ForceTable(const std::string &file_name, const bool periodic)
      : file_name(file_name)
      , periodic(periodic)
      , stations{0.}
  {
    std::ifstream file(file_name);
    AssertThrow(file, ExcMessage("Muscle/Table/File: " + file_name +
                                 ": this file cannot be read. Give the name of an existing "
                                 "table of times and amplitudes."));
    bool         first = true;
    unsigned int n     = 0;
    for (std::string line; std::getline(file, line);)
    {
      ++n;
      // Windows' line ends
      if (!line.empty() && line.back() == '\r')
        line.pop_back();
      const std::vector<std::string> fields = split(line);
      if (fields.empty())
        continue;
      const std::string place = file_name + ", line " + std::to_string(n) + ": ";
      if (first && fields[0] == "time")
        read_header(fields, place);
      else
        add_row(fields, place);
      first = false;
    }
    check_end();
  }

  void ForceTable::read_header(const std::vector<std::string> &fields, const std::string &place)
  {
    stations.clear();
    for (std::size_t i = 1; i < fields.size(); ++i)
    {
      stations.push_back(to_number(fields[i], place));
      AssertThrow(i == 1 || stations[i - 1] > stations[i - 2],
                  ExcMessage(place + "the station <" + fields[i] +
                             "> does not lie behind the one before it. Sort the columns by "
                             "increasing arc length."));
    }
    AssertThrow(!stations.empty(),
                ExcMessage(place + "there is no station after <time>. Give their positions."));
  }

  void ForceTable::add_row(const std::vector<std::string> &fields, const std::string &place)
  {
    AssertThrow(fields.size() == stations.size() + 1,
                ExcMessage(place + "there are " + std::to_string(fields.size()) +
                           " entries, but a time and " + std::to_string(stations.size()) +
                           " amplitude(s) are expected. Complete the row; name several stations "
                           "in a first row <time, s1, s2, ...>."));
    std::vector<double> values;
    for (const std::string &field : fields)
      values.push_back(to_number(field, place));
    AssertThrow(times.empty() || values[0] > times.back(),
                ExcMessage(place + "the time <" + fields[0] +
                           "> is not later than that of the row before. Sort the rows by time."));
    times.push_back(values[0]);
    rows.emplace_back(values.begin() + 1, values.end());
  }

  void ForceTable::check_end() const
  {
    AssertThrow(times.size() >= 2,
                ExcMessage(file_name + ": there are " + std::to_string(times.size()) +
                           " rows of numbers. Give at least two."));
    AssertThrow(!periodic || rows.front() == rows.back(),
                ExcMessage(file_name + ": the table is periodic, and its last row differs from "
                                       "its first. End it with the first row's amplitudes, at "
                                       "the time where the period ends."));
  }

  double ForceTable::value(double time, const double s) const
  {
    const double duration = times.back() - times.front();
    if (periodic)
    {
      const double periods = (time - times.front()) / duration;
      time                 = times.front() + duration * (periods - std::floor(periods));
    }
    // A time may miss the end of the table by rounding.
    const double tolerance = 1e-9 * duration;
    AssertThrow(time > times.front() - tolerance && time < times.back() + tolerance,
                ExcMessage(file_name + ": the time " + std::to_string(time) +
                           " s lies outside the table. Lengthen it, or make it periodic."));
    const auto [right, weight] = locate(times, time);
    return (1. - weight) * value_in_row(right - 1, s) + weight * value_in_row(right, s);
  }

  double ForceTable::value_in_row(const std::size_t row, const double s) const
  {
    if (stations.size() == 1)
      return rows[row][0];
    const auto [right, weight] = locate(stations, s);
    return (1. - weight) * rows[row][right - 1] + weight * rows[row][right];
  }

  double ForceTable::get_maximum() const
  {
    double maximum = 0.;
    for (const auto &row : rows)
      for (const double amplitude : row)
        maximum = std::max(maximum, std::abs(amplitude));
    return maximum;
  }
} // namespace caudal
