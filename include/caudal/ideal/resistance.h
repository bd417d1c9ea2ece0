// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_resistance_h
#define caudal_ideal_resistance_h

#include <caudal/ideal/kirchhoff.h>

namespace caudal::ideal
{
  /** Section `Resistance` of the .prm: what an ideal fluid lacks, as a crude model. */
  struct ResistanceParameters
  {
    bool   active    = false;
    double friction  = 0.;
    double drag      = 0.;
    double viscosity = 1e-6;

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  /**
   * Force on each element of the surface that moves with u in the fluid at rest, whose
   * tangential and normal parts are u_t and u_n n:
   *   df = -(1/2) rho C_f |u_t| u_t dS - (1/2) rho C_D |u_n| u_n n dS,
   * with a given C_f, or that of a laminar boundary layer on a plate (Blasius),
   * 1.328 Re^(-1/2), Re = u L/nu with u the root mean square of |u| over the surface. The first
   * part is friction, the second one a cross-flow force, as of slender bodies in Taylor 1952
   * (doi:10.1098/rspa.1952.0159), by which undulating sides drive a body as well.
   */
  ExternalForce create_resistance(const ResistanceParameters &parameters,
                                  const SwimmingShape        &shape);
} // namespace caudal::ideal

#endif
