// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/trigonometric_interpolation.h>

#include <deal.II/base/numbers.h>

#include <complex>

namespace caudal::ideal
{
  namespace
  {
    /**
     * The polynomial of M samples of which only that at the phase 0 is not zero, but one: at
     * @p psi, or its derivative. Of an even number of samples the highest sine, which vanishes
     * at all of them, is left out.
     */
    double compute_weight(const double psi, const unsigned int M, const bool derivative)
    {
      const std::complex<double> turn     = std::polar(1., psi);
      std::complex<double>       harmonic = 1.;
      double                     weight   = derivative ? 0. : 1.;
      for (unsigned int j = 1; 2 * j <= M; ++j)
      {
        harmonic *= turn;
        weight += (2 * j == M ? 1. : 2.) * (derivative ? -(j * harmonic.imag()) : harmonic.real());
      }
      return weight / M;
    }
  } // namespace

  std::vector<double> interpolate(const std::vector<std::vector<double>> &samples, const double psi,
                                  const unsigned int first, const unsigned int last,
                                  const bool derivative)
  {
    std::vector<double> result(last - first, 0.);
    for (unsigned int k = 0; k < samples.size(); ++k)
    {
      const double phase  = 2. * dealii::numbers::PI * k / samples.size();
      const double weight = compute_weight(psi - phase, samples.size(), derivative);
      for (unsigned int i = first; i < last; ++i)
        result[i - first] += weight * samples[k][i];
    }
    return result;
  }
} // namespace caudal::ideal
