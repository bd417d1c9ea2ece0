// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_ideal_state_h
#define caudal_ideal_ideal_state_h

#include <caudal/base/archive.h>
#include <caudal/base/declared_parameters.h>
#include <caudal/ideal/motion_sample.h>
#include <caudal/io/checkpoints.h>
#include <caudal/io/field_output.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

namespace caudal
{
  /** Place and direction of the body at the end of a stroke. */
  struct StrokeEnd
  {
    Tensor<1, 3> centre;       ///< of mass [m]
    double       heading = 0.; ///< of R e_1 in the plane [rad]

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &centre &heading;
    }
  };

  /** How far a swim at one frequency has come: its next instant depends on nothing else. */
  struct SwimState
  {
    ideal::MotionSample    last; ///< at the last instant
    Tensor<1, 3>           first_centre;
    ideal::EnergyAverages  energy;
    std::vector<StrokeEnd> stroke_ends;

    unsigned int n_output_times = 0;  ///< that have come, with or without a row
    unsigned int n_fields       = 0;  ///< written
    double       next_fields    = 0.; ///< [s]

    bool has_begun() const
    {
      return n_output_times > 0;
    }

    /** The distance of the centre of mass from its start [m]. */
    double get_distance() const
    {
      return (last.centre - first_centre).norm();
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &last &first_centre &energy &stroke_ends &n_output_times &n_fields &next_fields;
    }
  };

  /** Everything of a run in an ideal fluid that outlives a step. */
  struct IdealState
  {
    unsigned int           step_number = 0;  ///< instants of all swims, but for their starts
    double                 time        = 0.; ///< of the last one [s]
    ParameterValues        parameters;       ///< that made it
    std::vector<SwimState> swims;            ///< by frequency, those that have begun
    FieldOutput::Series    fields;           ///< that were written, on rank 0

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &step_number &time &parameters &swims &fields;
    }
  };

  /** Reads a state from a slot, which has no parts. */
  inline void read(const CheckpointSlot &slot, IdealState &state)
  {
    unpack(slot.data, state);
  }
} // namespace caudal

#endif
