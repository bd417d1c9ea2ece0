// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/revision.h>
#include <caudal/base/version.h>

namespace caudal
{
  std::string get_version()
  {
    const std::string revision = CAUDAL_REVISION;
    return "Caudal " CAUDAL_VERSION + (revision.empty() ? "" : " (" + revision + ")");
  }
} // namespace caudal
