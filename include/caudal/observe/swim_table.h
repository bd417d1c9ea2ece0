// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_swim_table_h
#define caudal_observe_swim_table_h

#include <caudal/observe/tail_beat.h>

#include <ostream>

namespace caudal
{
  /** Which quantities a table of tail beats has. */
  enum class SwimTable
  {
    screen, ///< those for which there is room
    file    ///< all
  };

  /** What stands in front of the rows: the definitions of the columns and their titles. */
  void write_header(std::ostream &out, const SwimmerConstants &swimmer, SwimTable table);

  /** The row of a beat. */
  void write_row(std::ostream &out, const SwimmerConstants &swimmer, std::size_t number,
                 const TailBeat &beat, SwimTable table);

  /**
   * The mean of beats at the end of a run, all quantities with their units:
   * @p n_beats of @p n_all.
   */
  void write_summary(std::ostream &out, const SwimmerConstants &swimmer, const TailBeat &mean,
                     std::size_t n_beats, std::size_t n_all);

  /**
   * The table as JSON: the constants, for each quantity its symbol, unit and definition, the
   * beats, and the mean of the last @p n_steady, which are steady (null if there are none).
   * What is not finite, such as a Strouhal number without speed, is null.
   */
  void write_swim_json(std::ostream &out, const SwimmerConstants &swimmer,
                       const std::vector<TailBeat> &beats, std::size_t n_steady);
} // namespace caudal

#endif
