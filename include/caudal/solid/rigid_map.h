// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_rigid_map_h
#define caudal_solid_rigid_map_h

#include <deal.II/base/tensor.h>

namespace caudal
{
  using namespace dealii;

  /** The motion x = center + rotation (s - reference_center). */
  template <int dim>
  struct RigidMotion
  {
    Tensor<2, dim> rotation;
    Tensor<1, dim> reference_center, center;

    /** Where the motion takes the place @p s. */
    Tensor<1, dim> apply(const Tensor<1, dim> &s) const
    {
      return center + rotation * (s - reference_center);
    }
  };
} // namespace caudal

#endif
