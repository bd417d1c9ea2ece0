#ifndef caudal_ideal_potential_state_h
#define caudal_ideal_potential_state_h

#include <caudal/base/declared_parameters.h>
#include <caudal/ideal/potential_output.h>
#include <caudal/ideal/swim_summary.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

namespace caudal
{
  /** How far a swim at one frequency has come: its next instant depends on nothing else. */
  struct SwimState
  {
    ideal::MotionSample   last; ///< at the last instant
    Tensor<1, 3>          first_centre;
    ideal::EnergyAverages energy;
    StrokeCounter         strokes;
    OutputCounters        output;

    bool has_begun() const
    {
      return output.n_rows > 0;
    }

    /** Of the centre of mass from its start [m]. */
    double get_distance() const
    {
      return (last.centre - first_centre).norm();
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &last &first_centre &energy &strokes &output;
    }
  };

  /** What a checkpoint of the potential model holds. */
  struct PotentialState
  {
    unsigned int           step_number = 0;  // instants of all swims, but for their starts
    double                 time        = 0.; // of the last one [s]
    ParameterValues        parameters;       // that made it
    std::vector<SwimState> swims;            // by frequency, those that have begun

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &step_number &time &parameters &swims;
    }
  };
} // namespace caudal

#endif
