// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_swim_report_h
#define caudal_observe_swim_report_h

#include <caudal/observe/tail_beat.h>

#include <boost/serialization/vector.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace caudal
{
  /** The table with one row per tail beat, in the log as the fish swims and in files. */
  class SwimReport
  {
  public:
    /**
     * Rows go to @p log, the whole table to @p file (none, if the name is empty) and, with
     * the ending .json instead of .txt, to a file for programs.
     */
    SwimReport(const SwimmerConstants &swimmer, std::ostream &log, const std::string &file);

    /** After each step. */
    void add(const SwimSample &sample);

    /** Writes the mean of the steady beats at the end, or else the last beat, to the log. */
    void finish();

    /** After the state was read back: removes later beats from the file. */
    void resume() const;

    const std::vector<TailBeat> &get_beats() const
    {
      return beats;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &detector &samples &beats;
    }

  private:
    using Quantities = std::vector<TailBeatQuantity>;

    const SwimmerConstants  swimmer;
    std::ostream           &log;
    const std::string       file;
    const Quantities        in_file, on_screen; // those that are known for the swimmer
    TailCycleDetector       detector;
    std::vector<SwimSample> samples; // since the start of the running beat
    std::vector<TailBeat>   beats;

    std::string get_file(const std::string &ending) const;
    std::size_t count_steady_beats() const;
    void        write_header(std::ostream &out, const Quantities &quantities) const;
    void        write_row(std::ostream &out, const Quantities &quantities, std::size_t beat) const;
    void        write_json(std::ostream &out) const;
    void        write_csv(std::ostream &out) const;
    void        write_files() const;
  };
} // namespace caudal

#endif
