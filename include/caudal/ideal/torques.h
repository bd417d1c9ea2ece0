// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_torques_h
#define caudal_ideal_torques_h

#include <caudal/ideal/screw.h>

#include <vector>

namespace caudal::ideal
{
  /** The torques of the joints that are wanted; those of any swim cost many times as much. */
  enum class Torques
  {
    none,
    from_rest, ///< at the start, and without external forces
    any
  };

  /**
   * What drives the body: the gait, and the impulses that it has not got from its gait. By
   * default the gait alone, at the unit rate of its argument.
   */
  struct Drive
  {
    double rate = 1.;    ///< dpsi/dt
    Screw  impulse;      ///< (Lambda, Pi)
    Screw  impulse_rate; ///< its derivative by time, in the body's frame

    /** Their number, without and with impulses. */
    static constexpr unsigned int n_from_rest = 1, n = 7;

    /** z: the rate, then the impulses. */
    double get(const unsigned int a) const
    {
      return a == 0 ? rate : impulse[a - 1];
    }

    double get_derivative(const unsigned int a) const
    {
      return a == 0 ? 0. : impulse_rate[a - 1];
    }
  };

  /**
   * What the torques of the modes need. A body whose drives are z moves with u = (q, dc/dt) =
   * sum_a z_a u_a: u_0 is the motion from rest for unit rate of the gait, u_a = (M^-1 e_a, 0)
   * that of a unit impulse. M is the mass matrix of all motions.
   */
  struct TorqueCoefficients
  {
    std::vector<double> momenta; ///< (M u_a)_i by mode i, then drive a

    /**
     * By mode i, then pairs a <= b: dT/dc_i at fixed u = sum_(a<=b) z_a z_b times these, of
     * which those of a = b are u_a^T (dM/dc_i) u_a/2.
     */
    std::vector<double> energy_gradient;
  };

  /**
   * Lagrange's equations: Q_i = d/dt (dT/dc_i') - dT/dc_i. @p momentum_rates are the
   * derivatives of coefficients.momenta by the gait's argument.
   */
  std::vector<double> compute_lagrange_torques(const TorqueCoefficients  &coefficients,
                                               const std::vector<double> &momentum_rates,
                                               unsigned int n_modes, const Drive &drive);
} // namespace caudal::ideal

#endif
