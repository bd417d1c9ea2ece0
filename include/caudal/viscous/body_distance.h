// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_body_distance_h
#define caudal_viscous_body_distance_h

#include <caudal/viscous/operators.h>

namespace caudal
{
  /** Two bodies are too close to each other: a sentence. */
  DeclException1(ExcBodiesMeet, std::string, << arg1);

  /**
   * Throws ExcBodiesMeet if two bodies in these @p states are closer than a cell of the finest
   * level of the fluid's grid or the width of the kernel: grid and kernel then do not resolve the
   * fluid between them, and nothing keeps them from running into each other.
   */
  template <int dim>
  void check_distances(const Operators<dim> &operators, const std::vector<BodyState> &states);
} // namespace caudal

#endif
