// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_motion_table_h
#define caudal_ideal_motion_table_h

#include <caudal/ideal/motion_sample.h>
#include <caudal/io/statistics.h>

namespace caudal::ideal
{
  /** The table of a swim, with a row of columns for each time: statistics.txt. */
  class MotionTable
  {
  public:
    /** Without a name nothing is written. Keeps the rows of an earlier run up to @p kept_time [s].
     */
    MotionTable(const std::string &file_name, double kept_time);

    /** @p distance is that of the centre of mass from its start [m]. */
    void write_row(const MotionSample &sample, double distance);

  private:
    void set_vector(const std::string &quantity, const std::string &unit,
                    const Tensor<1, 3> &vector);
    void set_modes(const std::string &quantity, const std::string &unit,
                   const std::vector<double> &values);

    Statistics statistics;
  };
} // namespace caudal::ideal

#endif
