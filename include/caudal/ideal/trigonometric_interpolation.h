// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_trigonometric_interpolation_h
#define caudal_ideal_trigonometric_interpolation_h

#include <vector>

namespace caudal::ideal
{
  /**
   * The functions [first, last) at psi [rad], or their derivatives, by the trigonometric
   * polynomials through @p samples, which are functions of period 2 pi at the phases
   * psi_k = 2 pi k/M; by phase, then function. For smooth functions the error falls faster than
   * any power of 1/M.
   */
  std::vector<double> interpolate(const std::vector<std::vector<double>> &samples, double psi,
                                  unsigned int first, unsigned int last, bool derivative = false);
} // namespace caudal::ideal

#endif
