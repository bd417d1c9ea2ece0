#ifndef caudal_observe_swim_table_h
#define caudal_observe_swim_table_h

#include <caudal/observe/tail_beat.h>

#include <ostream>

namespace caudal
{
  /** What stands in front of the rows on the screen, with the definitions of its columns. */
  void write_screen_header(std::ostream &out, const SwimmerConstants &swimmer);

  /** The row of a beat on the screen: what there is room for. */
  void write_screen_row(std::ostream &out, const SwimmerConstants &swimmer, std::size_t number,
                        const TailBeat &beat);

  /**
   * The mean of beats at the end of a run, all quantities with their units and definitions:
   * @p n_beats of @p n_all.
   */
  void write_summary(std::ostream &out, const SwimmerConstants &swimmer, const TailBeat &mean,
                     std::size_t n_beats, std::size_t n_all);

  /** All beats in columns that are defined in the header, for the eye and for programs. */
  void write_swim_table(std::ostream &out, const SwimmerConstants &swimmer,
                        const std::vector<TailBeat> &beats);

  /**
   * The same as JSON: the constants, for each quantity its symbol, unit and definition, the
   * beats, and the mean of the last @p n_steady, which are steady (null if there are none).
   * What is not finite, such as a Strouhal number without speed, is null.
   */
  void write_swim_json(std::ostream &out, const SwimmerConstants &swimmer,
                       const std::vector<TailBeat> &beats, std::size_t n_steady);
} // namespace caudal

#endif
