#ifndef caudal_app_run_state_h
#define caudal_app_run_state_h

#include <caudal/base/declared_parameters.h>
#include <caudal/fluid/fluid_snapshot.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

#include <sstream>

namespace caudal
{
  /** Everything that the next step of a run depends on: what a checkpoint holds. */
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

  /** The bytes of an object that boost can serialise. */
  template <class Object>
  std::string pack(const Object &object)
  {
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream);
    archive << object;
    return stream.str();
  }

  /** Its inverse; throws a sentence if the bytes are not those of such an object. */
  template <class Object>
  void unpack(const std::string &bytes, Object &object)
  {
    std::string error;
    try
    {
      std::istringstream              stream(bytes);
      boost::archive::binary_iarchive archive(stream);
      archive >> object;
    }
    catch (const ExceptionBase &)
    {
      throw;
    }
    catch (const std::exception &exception)
    {
      error = exception.what();
    }
    AssertThrow(error.empty(), ExcMessage("The checkpoint can't be read by this version of Caudal, "
                                          "or with these parameters (" +
                                          error + "). Resume with those that wrote it."));
  }
} // namespace caudal

#endif
