// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/controller.h>

namespace caudal
{
  ControllerParameters::ControllerParameters()
      : type("Type", "none", "What commands the muscle")
  {}

  void ControllerParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Controller");
    type.add_parameters(prm);
    prm.leave_subsection();
  }

  void ControllerParameters::check(const std::string &path) const
  {
    type.check(path + "/Controller");
  }

  namespace
  {
    const Registration<Controller, Controller> none("none", "gain 1, bias 0");
  }
} // namespace caudal
