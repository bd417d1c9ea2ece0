// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_screw_h
#define caudal_ideal_screw_h

#include <deal.II/base/tensor.h>

namespace caudal::ideal
{
  using namespace dealii;

  /** A pair of an angular and a linear vector: (omega, v), the impulses (Lambda, Pi), ... */
  using Screw = Tensor<1, 6>;

  inline Screw make_screw(const Tensor<1, 3> &angular, const Tensor<1, 3> &linear)
  {
    return Screw({angular[0], angular[1], angular[2], linear[0], linear[1], linear[2]});
  }

  inline Tensor<1, 3> get_angular(const Screw &screw)
  {
    return Tensor<1, 3>({screw[0], screw[1], screw[2]});
  }

  inline Tensor<1, 3> get_linear(const Screw &screw)
  {
    return Tensor<1, 3>({screw[3], screw[4], screw[5]});
  }
} // namespace caudal::ideal

#endif
