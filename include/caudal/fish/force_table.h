// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_force_table_h
#define caudal_fish_force_table_h

#include <deal.II/base/function_lib.h>

#include <memory>
#include <string>

namespace caudal
{
  using namespace dealii;

  /**
   * Amplitudes over time, at one or several stations along the body, from a
   * text file (see NumberTable): a row per instant, the time first. A first row
   * `time, s1, s2, ...` gives the stations (arc length over body length, increasing); it may be
   * left out if there is one column of amplitudes, which then holds for the whole body.
   *
   * Linear between the rows and between the stations, constant beyond the
   * outermost station. The last row of a periodic table repeats the first.
   */
  class ForceTable
  {
  public:
    /** Throws a sentence with file and line about the first bad row. */
    ForceTable(const std::string &file_name, bool periodic);

    /** The amplitude at time @p time [s] and arc length @p s [body lengths]. */
    double value(double time, double s) const;

    /** The largest modulus of all amplitudes. */
    double get_maximum() const
    {
      return maximum;
    }

  private:
    const std::string file_name;
    const bool        periodic;
    double            begin = 0., end = 0.; // [s]
    double            maximum = 0.;

    std::unique_ptr<Functions::InterpolatedTensorProductGridData<2>> amplitudes; // of (t, s)
  };
} // namespace caudal

#endif
