// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_state_archive_h
#define caudal_observe_state_archive_h

#include <caudal/base/archive.h>

#include <vector>

namespace caudal
{
  /**
   * The state of an observer on its way to a checkpoint or back: `archive & a & b` writes the
   * objects or reads them, so that they are listed once and behind a virtual function.
   */
  class StateArchive
  {
  public:
    /** An empty archive to write to. */
    StateArchive()
        : is_loading(false)
    {}

    /** An archive to read what another one got. */
    explicit StateArchive(const std::vector<std::string> &parts)
        : is_loading(true)
        , parts(parts)
    {}

    template <class Object>
    StateArchive &operator&(Object &object)
    {
      if (is_loading)
        unpack(parts.at(next++), object);
      else
        parts.push_back(pack(object));
      return *this;
    }

    const std::vector<std::string> &get_parts() const
    {
      return parts;
    }

  private:
    const bool               is_loading;
    std::vector<std::string> parts; // the bytes of each object
    std::size_t              next = 0;
  };
} // namespace caudal

#endif
