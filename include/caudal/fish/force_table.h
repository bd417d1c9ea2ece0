#ifndef caudal_fish_force_table_h
#define caudal_fish_force_table_h

#include <deal.II/base/exceptions.h>

#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /**
   * Amplitudes over time, at one or several stations along the body, from a
   * text file: a row per instant, the time first, entries separated by commas
   * or blanks, comments from '#' on. A first row `time, s1, s2, ...` gives the
   * stations (arc length over body length, increasing); it may be left out if
   * there is one column of amplitudes, which then holds for the whole body.
   *
   * Linear between the rows and between the stations, constant beyond the
   * outermost station. The last row of a periodic table repeats the first.
   */
  class ForceTable
  {
  public:
    /** Throws a sentence with file and line about the first bad row. */
    ForceTable(const std::string &file_name, const bool periodic);

    /** The amplitude at time @p time [s] and arc length @p s [body lengths]. */
    double value(const double time, const double s) const;

    /** The largest modulus of all amplitudes. */
    double get_maximum() const;

  private:
    void   read_header(const std::vector<std::string> &fields, const std::string &place);
    void   add_row(const std::vector<std::string> &fields, const std::string &place);
    void   check_end() const;
    double value_in_row(const std::size_t row, const double s) const;

    const std::string file_name;
    const bool        periodic;

    std::vector<double>              stations;
    std::vector<double>              times;
    std::vector<std::vector<double>> rows;
  };
} // namespace caudal

#endif
