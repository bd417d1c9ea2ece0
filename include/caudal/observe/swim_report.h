#ifndef caudal_observe_swim_report_h
#define caudal_observe_swim_report_h

#include <caudal/observe/tail_beat.h>

#include <boost/serialization/vector.hpp>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace caudal
{
  /**
   * Finds the cycles of a lateral position y(t) while it is fed sample by sample.
   *
   * Peaks and troughs are accepted once the signal has come back from them by
   * a fifth of the last swing, so that ripples do not count. A cycle starts
   * where the signal rises through the mean of the trough before and the peak
   * after: a mean that follows the fish when it drifts sideways. The time of the
   * crossing is interpolated between the samples.
   */
  class TailCycleDetector
  {
  public:
    /** Swings below twice @p smallest_amplitude [m] are no swings. */
    explicit TailCycleDetector(double smallest_amplitude);

    /** The next sample, in s and m; the cycle that became complete with it, if any. */
    std::optional<TailCycle> add(double time, double position);

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &times &positions &direction &extreme &opposite &swing &start &amplitude;
    }

  private:
    std::optional<TailCycle> accept_peak();
    void                     accept_trough();
    double                   get_up_crossing() const;

    double              smallest_swing; // [m]
    std::vector<double> times;          // since the last trough
    std::vector<double> positions;
    int                 direction = 0;  // +1 rising, -1 falling, 0 not known yet
    std::size_t         extreme   = 0;  // sample of the running peak or trough
    std::size_t         opposite  = 0;  // the same in the other direction, at the beginning
    double              swing     = 0;  // last distance from peak to trough [m]
    double              start     = -1; // of the running cycle [s], negative for none
    double              amplitude = 0;  // of the running cycle [m]
  };

  /** A table with one row per tail beat, in the log as the fish swims and in files. */
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
    void        write_files() const;
    std::string get_json_file() const;
    std::size_t count_steady_beats() const;

    const SwimmerConstants  swimmer;
    std::ostream           &log;
    const std::string       file;
    TailCycleDetector       detector;
    std::vector<SwimSample> samples; // since the start of the running beat
    std::vector<TailBeat>   beats;
  };
} // namespace caudal

#endif
