#ifndef caudal_io_swim_report_h
#define caudal_io_swim_report_h

#include <boost/serialization/vector.hpp>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace caudal
{
  /** One full cycle of the tail, from an up-crossing to the next. */
  struct TailCycle
  {
    double start     = 0; // [s]
    double end       = 0; // [s]
    double amplitude = 0; // half the distance from peak to trough [m]
  };

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

  /** What does not change while the fish swims; per metre of span in 2D. */
  struct SwimmerConstants
  {
    std::string name;                      // of the body
    double      length;                    // L [m]
    double      mass;                      // m [kg/m]
    double      viscosity;                 // kinematic, nu [m^2/s]
    double      minimum_amplitude = 0.005; // of a tail beat, in L
  };

  /** The state of the fish after a step. */
  struct SwimSample
  {
    double time;             // [s]
    double tail_position;    // lateral, of the monitored point [m]
    double forward_position; // of the centre of mass, along the swimming direction [m]
    double muscle_work;      // since the start [J/m]

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &time &tail_position &forward_position &muscle_work;
    }
  };

  /** The numbers of one tail beat; their definitions are printed with the table. */
  struct TailBeat
  {
    double start             = 0; // [s]
    double period            = 0; // T [s]
    double frequency         = 0; // f [Hz]
    double amplitude         = 0; // A [m]
    double speed             = 0; // U [m/s]
    double lengths_per_s     = 0; // U/L [1/s]
    double strouhal          = 0;
    double reynolds          = 0;
    double swimming          = 0;
    double power             = 0; // P [W/m]
    double energy_per_metre  = 0; // P/|U| [J/m per m]
    double cost_of_transport = 0; // P/(m |U|) [J/(kg m)]
    double change            = 0; // of U since the beat before, relative
    bool   is_steady         = false;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &start &period &frequency &amplitude &speed &lengths_per_s &strouhal &reynolds;
      archive &swimming &power &energy_per_metre &cost_of_transport &change        &is_steady;
    }
  };

  /**
   * The numbers of the cycle @p cycle from @p samples that cover it: mean values are
   * differences of position and work between its interpolated ends.
   */
  TailBeat compute_beat(const SwimmerConstants &swimmer, const std::vector<SwimSample> &samples,
                        const TailCycle &cycle, double previous_speed);

  /** A table with one row per tail beat, in the log as the fish swims and in a file. */
  class SwimReport
  {
  public:
    /** Rows go to @p log, the whole table to @p file (none, if the name is empty). */
    SwimReport(const SwimmerConstants &swimmer, std::ostream &log, const std::string &file);

    /** After each step. */
    void add(const SwimSample &sample);

    /** Writes the mean of the steady beats at the end to the log. */
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
    void write_file() const;

    const SwimmerConstants  swimmer;
    std::ostream           &log;
    const std::string       file;
    TailCycleDetector       detector;
    std::vector<SwimSample> samples; // since the start of the running beat
    std::vector<TailBeat>   beats;
  };
} // namespace caudal

#endif
