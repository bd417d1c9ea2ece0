#ifndef caudal_ideal_trigonometric_table_h
#define caudal_ideal_trigonometric_table_h

#include <vector>

namespace caudal::ideal
{
  /**
   * Periodic functions f(psi), given at the equidistant phases psi_k = 2 pi k/M, as the
   * trigonometric polynomials through these samples. For smooth functions the error falls
   * faster than any power of 1/M.
   */
  class TrigonometricTable
  {
  public:
    /** @p samples by phase, then function. */
    explicit TrigonometricTable(std::vector<std::vector<double>> samples);

    /** The functions [first, last) at psi [rad]. */
    std::vector<double> values(double psi, unsigned int first, unsigned int last) const;

    /** Their derivatives with respect to psi. */
    std::vector<double> derivatives(double psi, unsigned int first, unsigned int last) const;

    unsigned int n_functions() const
    {
      return samples.front().size();
    }

  private:
    std::vector<std::vector<double>> samples;
  };
} // namespace caudal::ideal

#endif
