#ifndef caudal_viscous_run_state_h
#define caudal_viscous_run_state_h

#include <caudal/base/declared_parameters.h>
#include <caudal/fluid/fluid_snapshot.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

namespace caudal
{
  /** Everything that the next step of an immersed run depends on: what its checkpoint holds. */
  struct RunState
  {
    unsigned int    step_number     = 0;
    double          time            = 0;  // [s]
    double          last_field_time = -1; // [s]
    ParameterValues parameters;           // that made it
    FluidSnapshot   fluid;
    /** Archives of the time stepper, of the bodies and of the output. */
    std::string stepper, bodies, output;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &step_number &time &last_field_time &parameters;
      archive &fluid &stepper &bodies             &output;
    }
  };
} // namespace caudal

#endif
