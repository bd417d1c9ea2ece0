#include <caudal/ideal/deformation.h>

#include <deal.II/lac/vector.h>

namespace caudal::ideal
{
  namespace
  {
    /** Weights of a value at c + k step, k = -2, -1, 1, 2, in the derivative by c. */
    const std::pair<double, double> stencil[] = {
        {-2., 1. / 12.}, {-1., -8. / 12.}, {1., 8. / 12.}, {2., -1. / 12.}};

    const double step = 1e-3;
  } // namespace

  std::vector<std::vector<Tensor<1, 3>>>
  Deformation::compute_mode_rates(const std::vector<double> &c,
                                  const std::vector<double> &rates) const
  {
    // d^2X/(dc_i dc_j) is symmetric: the modes' derivatives in the direction of the rates.
    std::vector<std::vector<Tensor<1, 3>>> result(n_modes());
    for (const auto &[distance, weight] : stencil)
    {
      std::vector<double> moved = c;
      for (unsigned int i = 0; i < moved.size(); ++i)
        moved[i] += distance * step * rates[i];
      const SurfaceMotion motion = place(moved);
      for (unsigned int i = 0; i < result.size(); ++i)
      {
        result[i].resize(motion.modes[i].size());
        for (unsigned int node = 0; node < result[i].size(); ++node)
          result[i][node] += weight / step * motion.modes[i][node];
      }
    }
    return result;
  }

  std::vector<double> Deformation::compute_body_energy_gradient(const std::vector<double> &c,
                                                                const std::vector<double> &u) const
  {
    const Vector<double> motion(u.begin(), u.end());
    std::vector<double>  gradient(n_modes(), 0.);
    for (unsigned int i = 0; i < gradient.size(); ++i)
      for (const auto &[distance, weight] : stencil)
      {
        std::vector<double> moved = c;
        moved[i] += distance * step;
        gradient[i] += weight / step * 0.5 * compute_body_mass(moved).matrix_norm_square(motion);
      }
    return gradient;
  }
} // namespace caudal::ideal
