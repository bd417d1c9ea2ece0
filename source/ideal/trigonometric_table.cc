#include <caudal/ideal/trigonometric_table.h>

#include <deal.II/base/numbers.h>

#include <complex>

namespace caudal::ideal
{
  namespace
  {
    struct Weight
    {
      double value;
      double derivative;
    };

    /**
     * The polynomial of M samples of which only that at the phase 0 is not zero, but one: at
     * @p psi, with its derivative. Of an even number of samples the highest sine, which vanishes
     * at all of them, is left out.
     */
    Weight compute_weight(const double psi, const unsigned int M)
    {
      const std::complex<double> turn     = std::polar(1., psi);
      std::complex<double>       harmonic = 1.;
      Weight                     weight{1. / M, 0.};
      for (unsigned int j = 1; 2 * j <= M; ++j)
      {
        harmonic *= turn;
        const double amplitude = (2 * j == M ? 1. : 2.) / M;
        weight.value += amplitude * harmonic.real();
        weight.derivative -= amplitude * j * harmonic.imag();
      }
      return weight;
    }

    std::vector<double> combine(const std::vector<std::vector<double>> &samples,
                                double Weight::*which, const double psi, const unsigned int first,
                                const unsigned int last)
    {
      std::vector<double> result(last - first, 0.);
      for (unsigned int k = 0; k < samples.size(); ++k)
      {
        const double phase  = 2. * dealii::numbers::PI * k / samples.size();
        const double weight = compute_weight(psi - phase, samples.size()).*which;
        for (unsigned int i = first; i < last; ++i)
          result[i - first] += weight * samples[k][i];
      }
      return result;
    }
  } // namespace

  TrigonometricTable::TrigonometricTable(std::vector<std::vector<double>> samples)
      : samples(std::move(samples))
  {}

  std::vector<double> TrigonometricTable::values(const double psi, const unsigned int first,
                                                 const unsigned int last) const
  {
    return combine(samples, &Weight::value, psi, first, last);
  }

  std::vector<double> TrigonometricTable::derivatives(const double psi, const unsigned int first,
                                                      const unsigned int last) const
  {
    return combine(samples, &Weight::derivative, psi, first, last);
  }
} // namespace caudal::ideal
