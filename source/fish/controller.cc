// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/controller.h>

namespace caudal
{
  namespace
  {
    const Registration<Controller, Controller> none("none", "gain 1, bias 0");
  }
} // namespace caudal
