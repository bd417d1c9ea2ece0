#include <caudal/ideal/trigonometric_table.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace caudal::ideal
{
  namespace
  {
    /** Calls @p add with j, cos(j psi), sin(j psi) for j < n: by rotations, their errors add up to
     * j rounding errors. */
    template <class Function>
    void visit_harmonics(const double psi, const unsigned int n, const Function &add)
    {
      const double cosine = std::cos(psi), sine = std::sin(psi);
      double       c = 1., s = 0.;
      for (unsigned int j = 0; j < n; ++j)
      {
        add(j, c, s);
        const double next = c * cosine - s * sine;
        s                 = s * cosine + c * sine;
        c                 = next;
      }
    }
  } // namespace

  TrigonometricTable::TrigonometricTable(const std::vector<std::vector<double>> &samples)
  {
    const unsigned int M = samples.size(), n = samples[0].size();
    for (unsigned int j = 0; j <= M / 2; ++j)
    {
      cosines.emplace_back(n, 0.);
      sines.emplace_back(n, 0.);
      // The mean and, for even M, the highest cosine appear once among 0..M-1, the others twice.
      const double factor = (j == 0 || 2 * j == M ? 1. : 2.) / M;
      for (unsigned int k = 0; k < M; ++k)
      {
        const double angle  = 2. * dealii::numbers::PI * ((j * k) % M) / M;
        const double cosine = factor * std::cos(angle), sine = factor * std::sin(angle);
        for (unsigned int i = 0; i < n; ++i)
        {
          cosines[j][i] += cosine * samples[k][i];
          sines[j][i] += 2 * j == M ? 0. : sine * samples[k][i];
        }
      }
    }
  }

  std::vector<double> TrigonometricTable::values(const double psi, const unsigned int first,
                                                 const unsigned int last) const
  {
    std::vector<double> result(last - first, 0.);
    visit_harmonics(psi, cosines.size(), [&](unsigned int j, double cosine, double sine) {
      for (unsigned int i = first; i < last; ++i)
        result[i - first] += cosine * cosines[j][i] + sine * sines[j][i];
    });
    return result;
  }

  std::vector<double> TrigonometricTable::derivatives(const double psi, const unsigned int first,
                                                      const unsigned int last) const
  {
    std::vector<double> result(last - first, 0.);
    visit_harmonics(psi, cosines.size(), [&](unsigned int j, double cosine, double sine) {
      for (unsigned int i = first; i < last; ++i)
        result[i - first] += j * (cosine * sines[j][i] - sine * cosines[j][i]);
    });
    return result;
  }
} // namespace caudal::ideal
