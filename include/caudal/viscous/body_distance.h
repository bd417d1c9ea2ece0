#ifndef caudal_viscous_body_distance_h
#define caudal_viscous_body_distance_h

#include <caudal/viscous/swimming_body.h>

namespace caudal
{
  /** Two bodies are too close to each other: a sentence. */
  DeclException1(ExcBodiesMeet, std::string, << arg1);

  /**
   * Throws ExcBodiesMeet if two bodies are closer, at their new positions, than a cell of the
   * finest level of the fluid's @p lattice or the width of a kernel: grid and kernel then do not
   * resolve the fluid between them, and nothing keeps them from running into each other.
   */
  template <int dim>
  void check_distances(const std::vector<std::unique_ptr<SwimmingBody<dim>>> &bodies,
                       const CellLattice<dim>                                &lattice);
} // namespace caudal

#endif
