// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_archive_h
#define caudal_base_archive_h

#include <deal.II/base/exceptions.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>
#include <string>

namespace caudal
{
  /** The bytes of an object that boost can serialise. */
  template <class Object>
  std::string pack(const Object &object)
  {
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream);
    archive << object;
    return stream.str();
  }

  /** Reads @p object from @p bytes; throws a sentence if they are not those of such an object. */
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
    catch (const dealii::ExceptionBase &)
    {
      throw;
    }
    catch (const std::exception &exception)
    {
      error = exception.what();
    }
    AssertThrow(error.empty(),
                dealii::ExcMessage("The checkpoint can't be read by this version of Caudal, "
                                   "or with these parameters (" +
                                   error + "). Resume with those that wrote it."));
  }
} // namespace caudal

#endif
