#ifndef caudal_ideal_swim_summary_h
#define caudal_ideal_swim_summary_h

#include <caudal/ideal/motion_sample.h>

#include <ostream>
#include <string>
#include <vector>

namespace caudal
{
  /** The result of a swim at one frequency. */
  struct SwimSummary
  {
    double frequency = 0.; ///< f [Hz]; 0 for a gait without period
    double duration  = 0.; ///< T [s]
    double length    = 0.; ///< L of the body [m]
    double mass      = 0.; ///< of the body [kg]

    double distance = 0.; ///< of the centre of mass from its start, at T [m]
    double stroke   = 0.; ///< the same from stroke to stroke, mean of all whole ones [m]
    double turn     = 0.; ///< in a stroke, about e_3 [rad]

    unsigned int n_strokes   = 0;     ///< whole ones
    bool         has_torques = false; ///< so that powers are known

    ideal::EnergyAverages energy; ///< over whole strokes, if there are any

    /** distance/T [m/s] */
    double get_speed() const;

    /**
     * Radius of the circle on which the centre of mass stands at the ends of the strokes; 0 if
     * the body swims straight [m].
     */
    double get_radius() const;

    /** Gross power by mass and speed [J/(kg m)]. */
    double get_cost_of_transport() const;
  };

  /** What an ideal fluid leaves out: a paragraph that stands in every summary. */
  std::string get_ideal_fluid_statement();

  /** All results with units, for the eye. */
  void print_summaries(std::ostream &out, const std::vector<SwimSummary> &summaries);

  /** The same for programs: a row for each frequency, the names of the columns first. */
  void print_csv(std::ostream &out, const std::vector<SwimSummary> &summaries);

  /** The same with the units and constants of the body, an object of JSON. */
  void print_json(std::ostream &out, const std::vector<SwimSummary> &summaries);

  /** Adds up displacements and turns from the samples at the end of each stroke. */
  class StrokeCounter
  {
  public:
    void add(const ideal::MotionSample &sample);
    void fill(SwimSummary &summary) const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &ends;
    }

  private:
    struct End
    {
      dealii::Tensor<1, 3> centre;
      double               heading; // [rad]

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &centre &heading;
      }
    };

    std::vector<End> ends;
  };
} // namespace caudal

#endif
