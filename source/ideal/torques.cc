#include <caudal/ideal/torques.h>

namespace caudal::ideal
{
  std::vector<double> compute_lagrange_torques(const TorqueCoefficients  &coefficients,
                                               const std::vector<double> &momentum_rates,
                                               const unsigned int n_modes, const Drive &drive)
  {
    std::vector<double> torques(n_modes, 0.);
    const unsigned int  n = n_modes > 0 ? momentum_rates.size() / n_modes : 0;
    auto momentum = coefficients.momenta.begin(), gradient = coefficients.energy_gradient.begin();
    auto momentum_rate = momentum_rates.begin();
    for (double &torque : torques)
      for (unsigned int a = 0; a < n; ++a)
      {
        torque +=
            *momentum_rate++ * drive.rate * drive.get(a) + *momentum++ * drive.get_derivative(a);
        for (unsigned int b = a; b < n; ++b)
          torque -= *gradient++ * drive.get(a) * drive.get(b);
      }
    return torques;
  }
} // namespace caudal::ideal
