// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_version_h
#define caudal_base_version_h

#include <string>

namespace caudal
{
  /**
   * The program's name and version, and the git revision of its sources where that is known:
   * "Caudal 0.2.0 (1a2b3c4)", "-dirty" behind it if files were changed since.
   */
  std::string get_version();
} // namespace caudal

#endif
