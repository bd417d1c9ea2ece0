#ifndef caudal_potential_cell_integrals_h
#define caudal_potential_cell_integrals_h

#include <caudal/potential/surface_quadrature.h>

namespace caudal::potential
{
  /** Integrals over a cell or a part of it, for each of its shape functions N_k. */
  struct CellMoments
  {
    alignas(64) double dipole[ReferenceRule::stride];    ///< int N_k dG/dn_y dS [1]
    alignas(64) double single[3][ReferenceRule::stride]; ///< int N_k G n dS [m]
  };

  /** Adds the integrals by @p rule, as seen from x, which is none of its points. */
  void add_moments(const CellRule &rule, const Point<3> &x, CellMoments &moments);

  /**
   * The same for the dipole alone; and the integrals of G times several normal velocities,
   * whose values times N are in the rows of @p fluxes, to @p single.
   */
  void add_far_moments(const CellRule &rule, const Point<3> &x, const double *fluxes,
                       unsigned int n_fluxes, double *dipole, double *single);
} // namespace caudal::potential

#endif
