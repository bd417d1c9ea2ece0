// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/gait.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * A wave of curvature kappa = c_1 K cos(w s) + c_2 K sin(w s), w = 2 pi k/L: with
     * c = (sin psi, -cos psi) it is K sin(psi - w s). K(s) = K_0/L ((1 - g) + g s/L).
     */
    class CurvatureWaveGait : public ModalGait
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Amplitude", amplitude,
                          "K_0, the amplitude of curvature times body length [1].");
      }

      void check(const std::string &path) const override
      {
        check_finite(path + "/Amplitude", amplitude);
      }

      unsigned int n_coordinates() const override
      {
        return 2;
      }

    protected:
      GaitState evaluate_stroke(const double psi) const override
      {
        return {{std::sin(psi), -std::cos(psi)}, {std::cos(psi), std::sin(psi)}};
      }

      double mode(const unsigned int i, const double s) const override
      {
        const double start = amplitude / length * (1. - shared.growth);
        const double slope = amplitude / length * shared.growth / length;
        const double w     = 2. * numbers::PI * shared.wave_number / length;
        if (w == 0.)
          return i == 0 ? start * s + 0.5 * slope * s * s : 0.;
        const double K = start + slope * s;
        return i == 0 ? K * std::sin(w * s) / w + slope * (std::cos(w * s) - 1.) / (w * w)
                      : (start - K * std::cos(w * s)) / w + slope * std::sin(w * s) / (w * w);
      }

    private:
      double amplitude = 2.;
    };

    const Registration<Gait, CurvatureWaveGait>
        registration("curvature wave", "a wave of curvature that runs to the tail");
  } // namespace
} // namespace caudal
